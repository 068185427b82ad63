#include "tools/fagorc/console.hpp"

#include <cstdlib>

#include "tools/fagorc/report/language.hpp"
#include "tools/fagorc/version.hpp"

namespace fagorc::tool {
namespace {

/// How many findings are shown unless --max-errors says otherwise, the rest is counted; 0: all. A person reads no more
/// than so many, and services take no more of one SARIF document, which is kept in memory until it is whole.
constexpr std::size_t usual_limit(report::Format format) {
    return format == report::Format::human ? 200 : format == report::Format::sarif ? 25'000 : 0;
}

/// Files of one workspace.
constexpr std::uint32_t files_per_part = 1u << 16;

const char* environment(const char* name) {
    return std::getenv(name);
}

}  // namespace

Language language_of(const Settings& settings) {
    return report::language_of(settings.language).value_or(report::language_of_environment(environment));
}

/// Moves the file numbers of one workspace to its own range.
class Console::PartSink final : public diag::Sink {
  public:
    PartSink(const frontend::Workspace*& workspace, std::uint32_t base, diag::Sink& next)
        : workspace_(workspace), base_(base), next_(next) {}
    using Sink::report;
    void report(diag::Diagnostic d) override {
        move(d.place);
        for (diag::Label& l : d.related) move(l.place);
        next_.report(std::move(d));
    }
    const frontend::Workspace* workspace() const { return workspace_; }

  private:
    void move(diag::Place& p) const {
        if (p.file != diag::FileId::none)
            p.file = static_cast<diag::FileId>(static_cast<std::uint32_t>(p.file) + base_);
    }
    const frontend::Workspace*& workspace_;
    std::uint32_t base_;
    diag::Sink& next_;
};

Console::Console(const Settings& settings, std::FILE* file)
    : language_(tool::language_of(settings)), deny_warnings_(settings.deny_warnings) {
    report::Options options;
    options.language = language_;
    options.version = version;
    options.color = report::color_wanted(report::color_of(settings.color).value_or(report::Color::automatic),
                                         report::is_terminal(file), environment);
    options.width = report::terminal_width(file).value_or(options.width);
    const auto write = [file](std::string_view text) { std::fwrite(text.data(), 1, text.size(), file); };
    const report::Format format = report::format_of(settings.format).value_or(report::Format::human);
    reporter_ = report::make_reporter(format, write, *this, options);
    once_ = std::make_unique<diag::Once>(*reporter_, settings.max_errors.value_or(usual_limit(format)));
}

Console::~Console() = default;

diag::Sink& Console::sink_of(const frontend::Workspace*& workspace) {
    const auto base = static_cast<std::uint32_t>(parts_.size()) * files_per_part;
    return *parts_.emplace_back(std::make_unique<PartSink>(workspace, base, *once_));
}

Exit Console::outcome() const {
    return diag::fails(once_->counts(), deny_warnings_) ? Exit::errors_found : Exit::ok;
}

void Console::finish() {
    reporter_->finish(once_->counts(), once_->left_out());
}

std::pair<const frontend::Workspace*, diag::FileId> Console::resolve(diag::FileId file) const {
    const auto n = static_cast<std::uint32_t>(file);
    if (file == diag::FileId::none || n / files_per_part >= parts_.size()) return {};
    return {parts_[n / files_per_part]->workspace(), static_cast<diag::FileId>(n % files_per_part)};
}

std::string_view Console::name(diag::FileId file) const {
    const auto [workspace, id] = resolve(file);
    return workspace ? workspace->name(id) : std::string_view{};
}

std::string_view Console::line_at(diag::FileId file, std::uint64_t offset) const {
    const auto [workspace, id] = resolve(file);
    return workspace ? workspace->line_at(id, offset) : std::string_view{};
}

}  // namespace fagorc::tool
