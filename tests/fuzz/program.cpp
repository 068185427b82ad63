// Fuzz target of the front end: any bytes are a program that is read to its end, the same with the shape cache and
// without.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "frontend/controls/controls.hpp"
#include "frontend/frontend.hpp"
#include "ir/diag/collection.hpp"

namespace {

using namespace fagorc;

/// Everything that reading says about a text, as one text.
std::string reading(const std::string& text, bool cache) {
    diag::Collection found;
    frontend::Workspace workspace(*frontend::dialects().front(), found, {.shape_cache = cache, .loop_cache = cache});
    program::Program& program = workspace.add("fuzz.pit", text);
    std::string out;
    program::Cursor at = program.start();
    while (const program::Block* block = program.read(at)) {
        const program::BlockTemplate& shape = *block->shape;
        out += std::to_string(block->here.line) + ' ' + std::to_string(shape.body.index()) + ' ' +
               std::to_string(shape.words.size()) + ' ' + std::to_string(shape.nodes.size()) + ' ' +
               std::to_string(shape.findings.size()) + ' ' + std::to_string(program.tokens(*block).size());
        for (const program::Quantity& q : block->slots)
            out += ' ' + std::to_string(q.at) + '=' + std::to_string(q.value);
        out += '\n';
        if (block->next.offset <= block->here.offset) std::abort();  // reading would never end
        at = block->next;
    }
    program.check_unread(found);
    for (const diag::Diagnostic& d : found.list())
        out += std::to_string(d.place.line) + ':' + std::to_string(d.place.column) + '-' +
               std::to_string(d.place.end_column) + ' ' + diag::message(d, Language::english) + '\n';
    return out;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::string with = reading(text, true), without = reading(text, false);
    if (with != without) {
        std::fprintf(stderr, "with the cache:\n%s\nwithout:\n%s\n", with.c_str(), without.c_str());
        std::abort();
    }
    return 0;
}
