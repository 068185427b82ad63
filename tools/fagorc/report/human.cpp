// For people: the message, the line with carets under the exact word, related places, one line of help.
#include <fmt/format.h>

#include <algorithm>

#include "tools/fagorc/report/readable.hpp"
#include "tools/fagorc/report/reporters.hpp"
#include "tools/fagorc/report/snippet.hpp"

namespace fagorc::report {
namespace {

using diag::Severity;

constexpr std::string_view bold = "\x1b[1m", blue = "\x1b[1;34m", plain = "\x1b[0m";

std::string_view color_of(Severity severity) {
    constexpr std::string_view colors[] = {"\x1b[1;36m", "\x1b[1;33m", "\x1b[1;31m"};
    return colors[static_cast<std::size_t>(severity)];
}

class Human final : public Reporter {
  public:
    explicit Human(Output output) : out_(std::move(output)) {}

    using Reporter::report;
    void report(diag::Diagnostic d) override {
        const Severity severity = diag::row(d.id).severity;
        std::string text = paint(color_of(severity), headline(d, out_.options));
        text += paint(bold, ": " + readable(diag::message(d, out_.options.language))) + '\n';
        const std::size_t margin = margin_of(d);
        place(text, d.place, "-->", {}, color_of(severity), margin);
        for (const diag::Label& label : d.related)
            place(text, label.place, ":::", label.text.in(out_.options.language), blue, margin);
        help(text, d, margin);
        out_.write(text + '\n');
    }

    void finish(const diag::Counts& counts, std::uint64_t left_out) override {
        const Language l = out_.options.language;
        std::string text;
        if (counts.errors() > 0)
            text = counted(counts.errors(), {"error", "erreur", "error"}, {"errors", "erreurs", "errores"}, l);
        if (counts.warnings() > 0)
            text += (text.empty() ? "" : ", ") + counted(counts.warnings(), {"warning", "avertissement", "advertencia"},
                                                         {"warnings", "avertissements", "advertencias"}, l);
        if (left_out > 0) text += ", " + not_shown(left_out, l);
        if (!text.empty()) out_.write(text + '\n');
    }

  private:
    std::string paint(std::string_view color, std::string_view text) const {
        return out_.options.color ? fmt::format("{}{}{}", color, text, plain) : std::string(text);
    }

    /// Room for the largest line number of a finding.
    static std::size_t margin_of(const diag::Diagnostic& d) {
        std::uint32_t line = d.place.line;
        for (const diag::Label& label : d.related) line = std::max(line, label.place.line);
        return fmt::formatted_size("{}", line);
    }

    void place(std::string& text, const diag::Place& p, std::string_view arrow, std::string_view why,
               std::string_view color, std::size_t margin) const {
        if (p.file == diag::FileId::none) return;
        text += fmt::format("{:{}}{} {}", "", margin, paint(blue, arrow), file_name(out_.texts, p));
        if (p.line > 0) text += fmt::format(":{}:{}", p.line, p.column);
        text += '\n';
        const std::string_view line = p.line > 0 ? out_.texts.line_at(p.file, p.block) : std::string_view{};
        if (!line.empty()) {
            const std::size_t frame = margin + 3;
            const std::size_t room = out_.options.width > frame ? out_.options.width - frame : 0;
            const Snippet s = snippet(line, p.column, p.end_column, room);
            text += fmt::format("{} {}\n", paint(blue, fmt::format("{:{}} |", p.line, margin)), s.text);
            text += fmt::format("{} {}{}", paint(blue, fmt::format("{:{}} |", "", margin)), s.indent,
                                paint(color, std::string(s.carets, '^')));
        } else if (!why.empty()) {
            text += fmt::format("{:{}} =", "", margin);
        } else {
            return;
        }
        text += why.empty() ? "\n" : fmt::format(" {}\n", why);
    }

    void help(std::string& text, const diag::Diagnostic& d, std::size_t margin) const {
        static constexpr Text word{"help", "aide", "ayuda"};
        text += fmt::format("{:{}} {} {}: fagorc explain {}\n", "", margin, paint(blue, "="),
                            word.in(out_.options.language), diag::row(d.id).code);
    }

    Output out_;
};

}  // namespace

std::unique_ptr<Reporter> make_human(Output output) {
    return std::make_unique<Human>(std::move(output));
}

}  // namespace fagorc::report
