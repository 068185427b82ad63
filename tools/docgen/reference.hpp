// The reference of a control's language, made from its tables.
#pragma once

#include <string>

#include "ir/control/dialect.hpp"

namespace fagorc::docgen {

/// The whole reference as Markdown.
std::string reference(const control::Dialect& dialect, Language language);

}  // namespace fagorc::docgen
