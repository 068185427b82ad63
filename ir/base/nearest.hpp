// The name that a mistyped one was probably meant to be.
#pragma once

#include <span>
#include <string_view>

namespace fagorc {

/// The one of `names` that is nearest to `word` in single-letter edits, letter case aside; empty when none is near:
/// at most one edit for each three letters, so that short words are not "corrected" into different ones.
std::string_view nearest(std::string_view word, std::span<const std::string_view> names);

}  // namespace fagorc
