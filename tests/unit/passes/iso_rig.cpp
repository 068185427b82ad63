#include "tests/unit/passes/iso_rig.hpp"

#include <cmath>

#include "frontend/controls/controls.hpp"
#include "frontend/machine/machine.hpp"
#include "ir/program/findings.hpp"

namespace fagorc::passes::testing {

machine::Machine built_in_lathe() {
    return frontend::built_in_lathe(*frontend::dialect("8055"));
}

IsoRig::IsoRig(machine::Machine machine)
    : workspace(*frontend::dialect("8055"), findings),
      session{.dialect = *frontend::dialect("8055"),
              .machine = std::move(machine),
              .library = workspace.library(),
              .live = live,
              .tables = tables,
              .texts = texts,
              .diagnostics = findings,
              .head = out,
              .options = options,
              .parameters = Parameters(*frontend::dialect("8055"), {})},
      runner(session) {
    workspace.add("009990.PIT", "(SUB 9990)\n(RET)\n");
}

IsoRig& IsoRig::run(std::string_view blocks) {
    session.program = &workspace.add("001234.PIT", std::string(blocks));
    for (program::Cursor at = session.program->first(); !session.ends(); at = session.block->next) {
        session.block = session.program->read(at);
        if (!session.block) break;
        session.failed = program::report_findings(*session.program, *session.block, findings);
        if (!session.failed) outcome = runner.run(std::get<program::IsoBlock>(session.block->shape->body));
    }
    session.block = nullptr;
    return *this;
}

std::string IsoRig::alarm() const {
    for (auto d = findings.list().rbegin(); d != findings.list().rend(); ++d) {
        const diag::Row& row = diag::row(d->id);
        if (row.severity == diag::Severity::error)
            return std::string(row.alarm_8055.empty() ? row.name : row.alarm_8055);
    }
    return {};
}

std::vector<std::string> IsoRig::warnings() const {
    std::vector<std::string> names;
    for (const auto& d : findings.list())
        if (diag::row(d.id).severity == diag::Severity::warning) names.emplace_back(diag::row(d.id).name);
    return names;
}

std::vector<operation::Operation> IsoRig::moves() const {
    std::vector<operation::Operation> list;
    for (const auto& o : out.list)
        if (operation::is_motion(o.what)) list.push_back(o);
    return list;
}

const operation::Operation& IsoRig::last_move() const {
    for (auto o = out.list.rbegin(); o != out.list.rend(); ++o)
        if (operation::is_motion(o->what)) return *o;
    static const operation::Operation none{};
    return none;
}

std::uint16_t IsoRig::variable_row(std::string_view name, bool per_axis) const {
    const auto& rows = session.dialect.variables;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].name == name && rows[i].per_axis == per_axis) return static_cast<std::uint16_t>(i);
    return 0;
}

double IsoRig::variable(std::string_view name, std::optional<Axis> axis, std::optional<long> number) {
    const auto row = variable_row(name, axis.has_value());
    return runner.variable(row, axis ? static_cast<int>(index(*axis)) : -1, number).value_or(std::nan(""));
}

}  // namespace fagorc::passes::testing
