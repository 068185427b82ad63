// What the tests of the text side share: the dialect, and a maker of templates that needs no grammar.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frontend/bind/bind.hpp"
#include "frontend/controls/controls.hpp"
#include "frontend/scan/readable_key.hpp"

namespace fagorc::frontend {

inline const control::Dialect& lathe() {
    return *dialect("8055");
}

/// Makes templates of what the text side itself looks at: labels, subroutines, returns, and characters that no block
/// can hold. Everything else is a block without a body.
class PlainMaker final : public TemplateMaker {
  public:
    program::BlockTemplate make(std::string_view key) override {
        ++calls;
        program::BlockTemplate made;
        made.bytes = 1000;
        if (key.starts_with(static_cast<char>(program::Token::lower_case))) key.remove_prefix(1);  // no token
        const std::string text = readable_key(key, lathe());
        if (text.starts_with("N #")) made.label_slot = 0;
        const auto sub = [&](bool local) {
            made.body = program::Statement{program::SubroutineBegin{0, local, 1}, 0, 4};
        };
        if (text == "( SUB # )") sub(false);
        if (text == "( LSUB # )") sub(true);
        if (text == "( RET )") made.body = program::Statement{program::Return{}, 0, 3};
        if (const auto at = text.find('!'); at != std::string::npos) {
            std::uint16_t token = 0;
            for (char c : text.substr(0, at)) token = static_cast<std::uint16_t>(token + (c == ' '));
            made.findings.push_back({diag::Id::strange_character, token, static_cast<std::uint16_t>(token + 1), {}});
            made.broken = true;
        }
        return made;
    }
    std::uint64_t calls = 0;
};

}  // namespace fagorc::frontend
