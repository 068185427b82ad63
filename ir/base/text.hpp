// A text in the three languages of the product.
#pragma once

#include <cstdint>
#include <string_view>

namespace fagorc {

enum class Language : std::uint8_t { english, french, spanish };

/// The same sentence in English, French and Spanish. UTF-8; lives as long as the program.
struct Text {
    std::string_view en, fr, es;
    constexpr std::string_view in(Language l) const {
        return l == Language::french ? fr : l == Language::spanish ? es : en;
    }
    constexpr bool complete() const { return !en.empty() && !fr.empty() && !es.empty(); }
};

}  // namespace fagorc
