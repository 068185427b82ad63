// Text outputs: lines gathered to large writes, and numbers as their documents state them.
#pragma once

#include <string>
#include <string_view>

#include "backends/output.hpp"

namespace fagorc::backends {

/// Gathers text; `text` is appended to, `end_line` ends a line and passes the text on from time to time.
class TextWriter {
  public:
    explicit TextWriter(Output& output) : output_(output) {}
    std::string text;
    void end_line() {
        text += '\n';
        if (text.size() >= full) flush();
    }
    void flush() {
        output_.write(std::string_view(text));
        text.clear();
    }

  private:
    static constexpr std::size_t full = 65536;
    Output& output_;
};

/// `value` with a fixed number of decimals, rounded to nearest; never "-0".
void append_fixed(std::string& out, double value, int decimals);
/// `value` with at most so many decimals, zeros at the end left out: "12.5", "3".
void append_trimmed(std::string& out, double value, int decimals);
/// The shortest text that gives the value back.
void append_shortest(std::string& out, double value);
void append_whole(std::string& out, std::uint64_t value);

}  // namespace fagorc::backends
