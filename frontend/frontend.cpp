#include "frontend/frontend.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <deque>
#include <map>
#include <system_error>

#include "frontend/bind/bind.hpp"
#include "frontend/structure/program_text.hpp"

namespace fagorc::frontend {
namespace {

using program::Library;
using program::Program;

/// A text that findings may point into: a program, or the text of another file.
struct Source {
    std::string name;
    std::unique_ptr<ProgramText> program;
    std::string text;
    bool superseded = false;  ///< a program that OPEN or WRITE has changed since; findings may still point into it
};

/// A program of the library: a file, or a text that OPEN and WRITE make.
struct Stored {
    std::string name;                 ///< path of a file
    std::optional<std::string> text;  ///< of a program made by a program
    ProgramText* program = nullptr;   ///< once it has been asked for
    bool missing = false;             ///< a file that could not be read
};

}  // namespace

/// Counts how often a template is made, for `--stats`.
class Workspace::Counting final : public TemplateMaker {
  public:
    explicit Counting(std::unique_ptr<TemplateMaker> maker) : maker_(std::move(maker)) {}
    program::BlockTemplate make(std::string_view key) override { return ++calls_, maker_->make(key); }
    std::uint64_t calls() const { return calls_; }

  private:
    std::unique_ptr<TemplateMaker> maker_;
    std::uint64_t calls_ = 0;
};

struct Workspace::Implementation final : Library {
    Implementation(const control::Dialect& d, diag::Sink& out, Options o)
        : dialect(d),
          diagnostics(out),
          options(o),
          scanner(d),
          maker(make_template_maker(d)),
          shapes(maker, o.shape_cache) {}

    ProgramText& add(std::string name, std::unique_ptr<Text> text) {
        const auto id = static_cast<diag::FileId>(sources.size());
        const Decoder decoder{dialect, scanner, shapes, diagnostics, options.loop_cache};
        sources.push_back({name, std::make_unique<ProgramText>(decoder, id, name, std::move(text)), {}, false});
        return *sources.back().program;
    }

    ProgramText* of(Stored& stored) {
        if (stored.program || stored.missing) return stored.program;
        std::unique_ptr<Text> text = stored.text ? text_of(*stored.text) : text_of_file(stored.name, diagnostics);
        stored.missing = !text;
        if (text) stored.program = &add(stored.name, std::move(text));
        return stored.program;
    }

    Program* program(std::uint32_t number) override {
        const auto at = library.find(number);
        if (at != library.end()) return of(at->second);
        for (const Source& s : sources)
            if (s.program && !s.superseded && s.program->number() == number) return s.program.get();
        return nullptr;
    }

    /// The texts at hand first, then the library in the order of its numbers: a number is unique in the control's
    /// memory (8055 T 12.4).
    Found subroutine(std::uint32_t number) override {
        const auto in = [number](ProgramText* p) { return p ? p->subroutine(number, false) : nullptr; };
        for (std::size_t i = 0; i < sources.size(); ++i)
            if (!sources[i].superseded)
                if (const auto* s = in(sources[i].program.get())) return {sources[i].program.get(), s};
        for (auto& [key, stored] : library)
            if (!stored.program)
                if (const auto* s = in(of(stored))) return {stored.program, s};
        return {};
    }

    Opened open(std::uint32_t number, std::optional<bool> append, std::string_view comment) override {
        Program* before = program(number);
        if (before && !append) return Opened::exists;
        std::string text = before && *append ? std::string(before->text()) : fmt::format("%{},MX,\n", comment);
        if (!text.ends_with('\n')) text += '\n';
        supersede(before);
        library[number] = {fmt::format("{:06}.PIT", number), std::move(text), nullptr, false};
        opened = number;
        return !before ? Opened::created : *append ? Opened::appended : Opened::replaced;
    }

    bool write(std::string_view block) override {
        if (!opened) return false;
        Stored& s = library[*opened];
        s.text->append(block) += '\n';
        supersede(s.program);
        s.program = nullptr;  // read anew, with the block, when it is asked for
        return true;
    }
    void supersede(const Program* program) {
        if (!program) return;
        for (Source& s : sources) s.superseded = s.superseded || s.program.get() == program;
    }
    void close() override { opened.reset(); }

    const control::Dialect& dialect;
    diag::Sink& diagnostics;
    Options options;
    Scanner scanner;
    Counting maker;
    ShapeCache shapes;
    std::deque<Source> sources;  ///< by FileId
    std::map<std::uint32_t, Stored> library;
    std::optional<std::uint32_t> opened;
};

Workspace::Workspace(const control::Dialect& dialect, diag::Sink& diagnostics, Options options)
    : implementation_(std::make_unique<Implementation>(dialect, diagnostics, options)) {}
Workspace::~Workspace() = default;

Program* Workspace::open(const std::string& path) {
    auto& i = *implementation_;
    std::unique_ptr<Text> text =
        path == "-" ? text_of_stream(::dup(STDIN_FILENO), i.diagnostics) : text_of_file(path, i.diagnostics);
    return text ? &i.add(path == "-" ? "<stdin>" : path, std::move(text)) : nullptr;
}

Program& Workspace::add(std::string name, std::string text) {
    return implementation_->add(std::move(name), text_of(text));
}

diag::FileId Workspace::add_text(std::string name, std::string text) {
    auto& sources = implementation_->sources;
    sources.push_back({std::move(name), nullptr, std::move(text), false});
    return static_cast<diag::FileId>(sources.size() - 1);
}

bool Workspace::add_library(const std::filesystem::path& folder) {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (const auto number = program_number(entry.path().string()))
            implementation_->library.try_emplace(*number, Stored{entry.path().string(), std::nullopt, nullptr, false});
    if (error)
        implementation_->diagnostics.report(diag::Id::cannot_read_folder, diag::Place{}, folder.string(),
                                            error.message());
    return !error;
}

Library& Workspace::library() {
    return *implementation_;
}

Program* Workspace::program(diag::FileId file) const {
    const auto n = static_cast<std::size_t>(file);
    return n < implementation_->sources.size() ? implementation_->sources[n].program.get() : nullptr;
}

Statistics Workspace::statistics() const {
    const auto& i = *implementation_;
    Statistics s{0, i.shapes.shapes(), i.maker.calls()};
    for (const Source& source : i.sources)
        if (source.program) s.blocks += source.program->blocks_read();
    return s;
}

std::string_view Workspace::name(diag::FileId file) const {
    const auto n = static_cast<std::size_t>(file);
    return n < implementation_->sources.size() ? std::string_view(implementation_->sources[n].name)
                                               : std::string_view{};
}

std::string_view Workspace::line_at(diag::FileId file, std::uint64_t offset) const {
    const auto n = static_cast<std::size_t>(file);
    if (n >= implementation_->sources.size()) return {};
    const Source& s = implementation_->sources[n];
    if (s.program) return s.program->line_at(offset);
    if (offset >= s.text.size()) return {};
    const std::string_view rest = std::string_view(s.text).substr(offset);
    return rest.substr(0, rest.find_first_of("\r\n"));
}

}  // namespace fagorc::frontend
