#include "tests/bench/part.hpp"

#include <cstdio>
#include <cstdlib>

#include "frontend/controls/controls.hpp"
#include "frontend/machine/machine.hpp"
#include "tests/bench/programs.hpp"

namespace fagorc::bench {

namespace {

struct KeepingSink final : operation::Sink {
    void push(const operation::Operation& o) override { list.push_back(o); }
    std::vector<operation::Operation> list;
};

}  // namespace

Part::Part(const std::string& blocks)
    : dialect_(*frontend::dialect("8055")),
      workspace_(dialect_, findings_),
      program_(workspace_.add("part.pit", whole(blocks))),
      machine_(frontend::built_in_lathe(dialect_)) {}

passes::ExecuteResult Part::execute(operation::Sink& head) {
    const auto result = passes::execute(program_, workspace_.library(), dialect_, machine_, live_, tables_, texts_,
                                        findings_, head, options_);
    if (result.completed) return result;
    for (const diag::Diagnostic& d : findings_.list())
        std::fprintf(stderr, "line %u: %s\n", d.place.line, diag::message(d, Language::english).c_str());
    std::exit(1);
}

std::vector<operation::Operation> Part::operations() {
    KeepingSink kept;
    execute(kept);
    return std::move(kept.list);
}

std::vector<operation::Operation> Part::moves() {
    KeepingSink kept;
    passes::Pipeline pipeline(environment(), kept, {});
    execute(pipeline.head());
    return std::move(kept.list);
}

passes::Session Part::session(operation::Sink& head) {
    return {.dialect = dialect_,
            .machine = machine_,
            .library = workspace_.library(),
            .live = live_,
            .tables = tables_,
            .texts = texts_,
            .diagnostics = findings_,
            .head = head,
            .options = options_,
            .parameters = passes::Parameters(dialect_, machine_.parameters),
            .program = &program_};
}

}  // namespace fagorc::bench
