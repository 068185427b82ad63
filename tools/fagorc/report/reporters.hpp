// The four reporters behind make_reporter, and what they share.
#pragma once

#include <utility>

#include "tools/fagorc/report/reporter.hpp"

namespace fagorc::report {

/// What every reporter holds.
struct Output {
    Write write;
    const SourceTexts& texts;
    Options options;
};

std::unique_ptr<Reporter> make_human(Output output);
std::unique_ptr<Reporter> make_brief(Output output);
std::unique_ptr<Reporter> make_json(Output output);
std::unique_ptr<Reporter> make_sarif(Output output);

/// The name of the file of a place as printable UTF-8; empty for a place in no file.
std::string file_name(const SourceTexts& texts, const diag::Place& place);

/// "error F0205 [alarm 0046]" in a language.
std::string headline(const diag::Diagnostic& diagnostic, const Options& options);

/// "1 error", "2 errors" in a language.
std::string counted(std::uint64_t n, const Text& one, const Text& many, Language language);

/// "12 not shown" in a language.
std::string not_shown(std::uint64_t findings, Language language);

}  // namespace fagorc::report
