// The explain pages: what a finding means, what the control does, what cures it, and programs that show it. One file a
// code, ir/diag/explain/F0205.md, compiled into the binary.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "ir/base/text.hpp"
#include "ir/diag/id.hpp"

namespace fagorc::diag {

/// What the programs of a page show. `shown`: the first raises the code, the others nothing. `planned`: a construct in
/// them is not executed yet, and raises not_yet_supported alone. `none`: no program can raise the code.
enum class Examples : std::uint8_t { shown, planned, none };

/// The page of a code in a language, Markdown without the examples; empty where the code has no page.
std::string_view explain_page(Id id, Language language);

/// How the examples of a page are to be read.
Examples explain_examples_kind(Id id);

/// The programs of a page, the one that raises the code first. Lines `;@ ` are a machine file laid over the built-in
/// lathe, when the mark is taken away.
std::vector<std::string_view> explain_examples(Id id);

}  // namespace fagorc::diag
