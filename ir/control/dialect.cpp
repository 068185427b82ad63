#include "ir/control/dialect.hpp"

#include <algorithm>

namespace fagorc::control {

const Construct* Dialect::find(char letter, std::uint16_t number) const {
    const auto before = [](const Construct* c, std::pair<char, std::uint16_t> key) {
        return std::pair(c->letter, c->number) < key;
    };
    const auto at = std::lower_bound(constructs.begin(), constructs.end(), std::pair(letter, number), before);
    return at != constructs.end() && (*at)->letter == letter && (*at)->number == number ? *at : nullptr;
}

const SisterCode* Dialect::find_sister(char letter, std::uint16_t number) const {
    const auto at = std::find_if(sister_codes.begin(), sister_codes.end(),
                                 [=](const SisterCode& c) { return c.letter == letter && c.number == number; });
    return at != sister_codes.end() ? &*at : nullptr;
}

const SisterWord* Dialect::find_sister(std::string_view word) const {
    const auto at =
        std::find_if(sister_words.begin(), sister_words.end(), [=](const SisterWord& w) { return w.word == word; });
    return at != sister_words.end() ? &*at : nullptr;
}

std::string_view Dialect::word(program::Token kind, std::uint16_t payload) const {
    const auto at = std::find_if(words.begin(), words.end(),
                                 [=](const ReservedWord& w) { return w.token == kind && w.payload == payload; });
    return at != words.end() ? at->text : std::string_view();
}

std::string Dialect::variable_name(std::uint16_t payload) const {
    const std::uint16_t row = variable_row(payload);
    if (row >= variables.size()) return {};
    std::string full(variables[row].name);
    if (const int axis = variable_axis(payload); axis >= 0) full += letter(all_axes[static_cast<std::size_t>(axis)]);
    return full;
}

const StatementRow* Dialect::find_statement(std::string_view word) const {
    const auto at =
        std::find_if(statements.begin(), statements.end(), [=](const StatementRow& r) { return r.word == word; });
    return at != statements.end() ? &*at : nullptr;
}

}  // namespace fagorc::control
