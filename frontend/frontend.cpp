#include "frontend/frontend.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <deque>
#include <map>
#include <system_error>
#include <tuple>

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

    /// A program that is open has its number for itself, whatever the library holds: a number is unique in the
    /// control's memory (8055 T 12.4), and the text at hand may be newer than the one in the folder.
    ProgramText& opened_program(ProgramText& program) {
        if (const auto number = program.number())
            library.insert_or_assign(*number, Stored{program.name(), std::nullopt, &program, false});
        return program;
    }

    Program* program(std::uint32_t number) override {
        const auto at = library.find(number);
        return at != library.end() ? of(at->second) : nullptr;
    }

    /// The texts at hand first, then the library in the order of its numbers.
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
    const std::string name = path == "-" ? "<stdin>" : path;
    std::unique_ptr<Text> text =
        path == "-" ? text_of_stream(::dup(STDIN_FILENO), name, i.diagnostics) : text_of_file(path, i.diagnostics);
    return text ? &i.opened_program(i.add(name, std::move(text))) : nullptr;
}

Program& Workspace::add(std::string name, std::string text) {
    auto& i = *implementation_;
    return i.opened_program(i.add(std::move(name), text_of(text)));
}

diag::FileId Workspace::add_text(std::string name, std::string text) {
    auto& sources = implementation_->sources;
    sources.push_back({std::move(name), nullptr, std::move(text), false});
    return static_cast<diag::FileId>(sources.size() - 1);
}

bool Workspace::add_library(const std::filesystem::path& folder) {
    auto& i = *implementation_;
    std::error_code error;
    std::vector<std::pair<std::uint32_t, std::string>> programs;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (const auto number = program_number(entry.path().string()))
            programs.emplace_back(*number, entry.path().string());
    if (error) {
        i.diagnostics.report(diag::Id::cannot_read_folder, diag::Place{}, folder.string(), error.message());
        return false;
    }
    // Not as the folder happens to list them: .PIT, the lathe's, stands before .PIM, the mill's (8055 T 1.1).
    std::sort(programs.begin(), programs.end(), [](const auto& a, const auto& b) {
        const auto place = [](const auto& p) { return std::tuple(p.first, (p.second.back() | 0x20) == 'm', p.second); };
        return place(a) < place(b);
    });
    const std::string* before = nullptr;
    for (const auto& [number, path] : programs) {
        if (before && program_number(*before) == number)
            i.diagnostics.report(diag::Id::program_number_twice, diag::Place{}, number, *before, path);
        else
            i.library.try_emplace(number, Stored{path, std::nullopt, nullptr, false});
        before = &path;
    }
    return true;
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
