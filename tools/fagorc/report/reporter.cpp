#include "tools/fagorc/report/reporter.hpp"

#include <fmt/format.h>

#include "tools/fagorc/report/readable.hpp"
#include "tools/fagorc/report/reporters.hpp"

namespace fagorc::report {

std::optional<Format> format_of(std::string_view name) {
    static constexpr std::pair<std::string_view, Format> names[] = {
        {"human", Format::human}, {"short", Format::brief}, {"json", Format::json}, {"sarif", Format::sarif}};
    for (const auto& [known, format] : names)
        if (known == name) return format;
    return std::nullopt;
}

std::unique_ptr<Reporter> make_reporter(Format format, Write write, const SourceTexts& texts, Options options) {
    Output output{std::move(write), texts, std::move(options)};
    switch (format) {
        case Format::human:
            return make_human(std::move(output));
        case Format::brief:
            return make_brief(std::move(output));
        case Format::json:
            return make_json(std::move(output));
        case Format::sarif:
            return make_sarif(std::move(output));
    }
    return nullptr;
}

std::string file_name(const SourceTexts& texts, const diag::Place& place) {
    return place.file == diag::FileId::none ? std::string{} : readable(texts.name(place.file));
}

std::string headline(const diag::Diagnostic& diagnostic, const Options& options) {
    static constexpr Text word{"alarm", "alarme", "alarma"};
    const diag::Row& row = diag::row(diagnostic.id);
    const std::string alarm = diag::alarm(diagnostic, options.control);
    std::string out = fmt::format("{} {}", diag::to_string(row.severity, options.language), row.code);
    if (!alarm.empty()) out += fmt::format(" [{} {}]", word.in(options.language), alarm);
    return out;
}

std::string counted(std::uint64_t n, const Text& one, const Text& many, Language language) {
    return fmt::format("{} {}", n, (n == 1 ? one : many).in(language));
}

std::string not_shown(std::uint64_t findings, Language language) {
    return counted(findings, {"not shown", "non affiché", "no mostrado"}, {"not shown", "non affichés", "no mostrados"},
                   language);
}

}  // namespace fagorc::report
