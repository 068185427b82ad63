// What a diagnostic is, and where all of them go.
#pragma once

#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ir/base/text.hpp"
#include "ir/diag/id.hpp"

namespace fagorc::diag {

enum class FileId : std::uint32_t { none = 0xffffffff };

/// A piece of one line of a file. Lines count from 1 (physical lines); columns are bytes from 1, the end exclusive.
/// `block` is the offset of the line's first byte, so that a reporter finds the text without counting lines.
struct Place {
    FileId file = FileId::none;
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    std::uint32_t end_column = 0;
    std::uint64_t block = 0;
    friend bool operator==(const Place&, const Place&) = default;
};

/// A value for a `{}` of the message: plain, or a text that the reporter takes in the reader's language.
struct Argument {
    std::string plain;
    Text text;

    Argument(Text t) : text(t) {}                     // NOLINT(google-explicit-constructor): arguments read as values
    Argument(std::string s) : plain(std::move(s)) {}  // NOLINT
    Argument(std::string_view s) : plain(s) {}        // NOLINT
    Argument(const char* s) : plain(s) {}             // NOLINT
    Argument(char c) : plain(1, c) {}                 // NOLINT
    Argument(double value);                           // NOLINT: as a reader writes it, at most five decimals
    template <std::integral I>
    Argument(I value) : plain(std::to_string(value)) {}  // NOLINT
    std::string_view in(Language l) const { return text.en.empty() ? std::string_view(plain) : text.in(l); }
};

/// A second place that says why, e.g. "diameter since here".
struct Label {
    Place place;
    Text text;
};

/// One finding. The severity, the code, the alarm number and the texts stand in the catalogue row of `id`.
struct Diagnostic {
    Id id{};
    Place place;
    std::vector<Argument> arguments;
    std::vector<Label> related;
};

/// Whether the message of `id` has a place for each of `count` arguments and no other (ir/diag/catalogue.cpp).
bool takes(Id id, std::size_t count);

/// Takes diagnostics one by one, in the order of discovery.
class Sink {
  public:
    virtual ~Sink() = default;
    virtual void report(Diagnostic diagnostic) = 0;

    template <class... Arguments>
    void report(Id id, const Place& place, Arguments&&... arguments) {
        assert(takes(id, sizeof...(arguments)));
        Diagnostic d{id, place, {}, {}};
        (d.arguments.emplace_back(std::forward<Arguments>(arguments)), ...);
        report(std::move(d));
    }
};

}  // namespace fagorc::diag
