// Texts with parameters in them: MSG, ERROR and WRITE (8055 T 12.2, 12.8).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace fagorc::passes {

/// The value of a parameter by its number; nothing where it does not exist or is not known.
using ParameterValue = std::function<std::optional<double>(double number)>;

/// A number as the control writes it: up to five decimals, no zeros at the end, no plus.
std::string written(double value);

/// `?Pn` becomes the value of Pn. Nothing when a value is missing.
std::optional<std::string> with_marked_values(std::string_view text, const ParameterValue& value);

/// The block that WRITE makes of its text: in a high-level text, which starts with a parenthesis, only what is marked
/// by
/// `?` is replaced; in an ISO text every parameter is, but `$P` behind an axis letter writes the parameter itself.
std::optional<std::string> written_block(std::string_view text, const ParameterValue& value);

}  // namespace fagorc::passes
