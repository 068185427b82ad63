// From the key of a block shape to its template: parse (once per shape) and bind with the control's tables.
#pragma once

#include <memory>
#include <string_view>

#include "ir/control/dialect.hpp"
#include "ir/program/block.hpp"

namespace fagorc::frontend {

/// Makes the template of a shape from its key alone, never from the text: one key is one parse by construction.
class TemplateMaker {
  public:
    virtual ~TemplateMaker() = default;
    /// The template of a key, a string of the bytes that ir/program/token.hpp describes. Never fails: what is wrong
    /// with the shape are findings of the template, and a syntax error makes it `broken`.
    virtual program::BlockTemplate make(std::string_view key) = 0;
};

/// A maker for one control. `dialect` must outlive it and the templates that it makes (they point at its constructs).
std::unique_ptr<TemplateMaker> make_template_maker(const control::Dialect& dialect);

}  // namespace fagorc::frontend
