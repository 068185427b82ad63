// Templates of block texts, for the tests of the binder.
#pragma once

#include <string>
#include <string_view>

#include "frontend/bind/bind.hpp"
#include "frontend/controls/controls.hpp"
#include "frontend/scan/scanner.hpp"
#include "ir/program/describe.hpp"

namespace fagorc {

/// Scans a block of the 8055 T and makes the template of its key.
inline program::BlockTemplate shape_of(std::string_view block) {
    const control::Dialect& dialect = *frontend::dialect("8055");
    static const frontend::Scanner scanner(dialect);
    static frontend::Scan room(dialect.limits.block_bytes);
    static const auto maker = frontend::make_template_maker(dialect);
    const std::string text = std::string(block) + "\n";
    scanner.scan(text.c_str(), room);
    return maker->make(room.key());
}

/// The template as one line.
inline std::string shape_text(std::string_view block) {
    return program::describe(shape_of(block), *frontend::dialect("8055"));
}

/// A block and what its template must read like. The expectations were written from the manual's description of the form,
/// numbers counted from 0 in the order in which they stand in the block.
struct BlockCase {
    const char* block;
    const char* shape;
};

}  // namespace fagorc
