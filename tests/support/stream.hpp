// Operations made by hand for the tests of the backends, and what a backend needs besides them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "backends/backend.hpp"
#include "backends/output.hpp"
#include "ir/diag/collection.hpp"

namespace fagorc::test {

/// Keeps findings.
struct Findings : diag::Sink {
    using Sink::report;
    void report(diag::Diagnostic d) override { list.push_back(std::move(d)); }
    std::vector<diag::Diagnostic> list;
};

/// Programs by file number, and a place for an operation in them.
struct SomePrograms : backends::Programs {
    struct One {
        std::string name, text;
    };
    std::vector<One> list;
    std::map<std::uint32_t, std::uint32_t> labels;  ///< by line
    std::string_view name(diag::FileId file) const override { return list.at(static_cast<std::size_t>(file)).name; }
    std::string_view text(diag::FileId file, std::size_t from) const override {
        return std::string_view(list.at(static_cast<std::size_t>(file)).text).substr(from);
    }
    diag::Place place(const operation::Context& at) const override { return {diag::FileId{0}, at.line, 1, 2, 0}; }
    std::optional<std::uint32_t> label(const operation::Context& at) const override {
        const auto found = labels.find(at.line);
        return found == labels.end() ? std::nullopt : std::optional(found->second);
    }
};

/// A stream of operations: each call makes one, in the state that `now` and `at` hold.
class Stream {
  public:
    Stream();

    backends::Job job() { return {tables, texts, machine, programs, findings, "test 1.0"}; }

    operation::State now;       ///< state of the operations that follow; call `state` after a change
    operation::Operation next;  ///< context and axes of the operations that follow
    void state() { next.at.state = tables.states.intern(now); }
    void frame(const operation::Frame& f) { next.at.frame = tables.frames.intern(f); }
    void chain(const operation::Chain& c) { next.at.chain = tables.chains.intern(c); }

    /// One operation more; each has the next line.
    void add(const operation::What& what);
    /// u v of the plane: Z and X (radius) of a lathe.
    void rapid(double u, double v) { add(operation::Line{{u, v}, true}); }
    void line(double u, double v) { add(operation::Line{{u, v}, false}); }
    void arc(Point end, Point centre, bool ccw, bool full = false) { add(operation::Arc{end, centre, ccw, full}); }
    void event(operation::Event::Kind kind, double value = 0) { add(operation::Event{kind, {}, 0, value}); }
    void message(std::string text);

    void play(operation::Sink& sink) const;

    operation::Tables tables;
    std::vector<std::string> texts{1};
    machine::Machine machine;
    SomePrograms programs;
    Findings findings;
    std::vector<operation::Operation> operations;
};

/// One of each: a chain of two programs, all kinds of moves, other axes, another plane, events, an offset that moves
/// the tip, a home search.
Stream everything();

}  // namespace fagorc::test
