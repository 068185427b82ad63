// The index of diagnostics in docs/diagnostics.md.
#pragma once

#include <string>
#include <string_view>

namespace fagorc::docgen {

/// The page with its index made anew: what stands before the mark `<!-- index: made by tools/docgen -->` is written by
/// hand and kept. Empty where the page has no mark.
std::string diagnostics(std::string_view page);

}  // namespace fagorc::docgen
