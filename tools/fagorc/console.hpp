// Where the findings of a run are shown, whichever of its programs they come from.
#pragma once

#include <cstdio>
#include <memory>
#include <vector>

#include "frontend/frontend.hpp"
#include "ir/diag/collection.hpp"
#include "tools/fagorc/report/reporter.hpp"
#include "tools/fagorc/settings.hpp"

namespace fagorc::tool {

/// Prints the findings of any number of workspaces to one file. Numbers files by workspace, so that one report may
/// speak of many programs.
class Console final : public report::SourceTexts {
  public:
    Console(const Settings& settings, std::FILE* file);
    ~Console() override;

    /// A sink for the findings of one workspace, which must outlive the console's `finish`.
    diag::Sink& sink_of(const frontend::Workspace*& workspace);
    /// The exit code that the findings so far ask for.
    Exit outcome() const;
    /// Ends the report.
    void finish();
    Language language() const { return language_; }

    std::string_view name(diag::FileId file) const override;
    std::string_view line_at(diag::FileId file, std::uint64_t offset) const override;

  private:
    class PartSink;
    /// A file's workspace and its number there.
    std::pair<const frontend::Workspace*, diag::FileId> resolve(diag::FileId file) const;

    Language language_;
    bool deny_warnings_;
    std::vector<std::unique_ptr<PartSink>> parts_;
    std::unique_ptr<report::Reporter> reporter_;
    std::unique_ptr<diag::Once> once_;
};

/// The language that the settings or the locale ask for.
Language language_of(const Settings& settings);

}  // namespace fagorc::tool
