#include "passes/execute/variables.hpp"

#include <fmt/format.h>

#include "ir/control/variable.hpp"

namespace fagorc::passes {
namespace {

using control::Knowledge;
using control::Role;
using diag::Id;

constexpr double mm_per_inch = 25.4;
/// What GPOS reads for an axis that the block does not program (8055 T 11.2.7).
constexpr double not_programmed = 100000;

/// A table holds these in millimetres, a program reads them in the active unit.
bool is_length(Role role) {
    switch (role) {
        case Role::coordinate:
        case Role::abscissa:
        case Role::ordinate:
        case Role::machine_coordinate:
        case Role::distance:
        case Role::distance_u:
        case Role::distance_v:
        case Role::length:
            return true;
        default:
            return false;
    }
}

}  // namespace

/// The axis of a name; X for a column that has none, where it decides nothing.
Axis Variables::axis_or_x(const Access& a) {
    return a.axis < 0 ? Axis::X : all_axes[static_cast<std::size_t>(a.axis)];
}

double Variables::unit(const Access& a) const {
    const bool inch = iso_.modal().unit == program::LengthUnit::inch;
    return inch && is_length(a.row->unit) && !is_rotary(axis_or_x(a)) ? mm_per_inch : 1;
}

Variables::Variables(Session& session, IsoRunner& iso) : session_(session), iso_(iso) {
    for (const control::Variable& row : session.dialect.variables) columns_.push_back(find_column(row.name));
}

std::string Variables::name(const Access& access) const {
    std::string text(access.row->name);
    if (access.axis >= 0) text += letter(all_axes[static_cast<std::size_t>(access.axis)]);
    if (access.index) text += std::to_string(*access.index);
    return text;
}

std::optional<Variables::Access> Variables::open(std::uint16_t payload, std::optional<double> index,
                                                 std::uint16_t token) {
    const std::uint16_t number = control::variable_row(payload);
    Access a{&session_.dialect.variables[number], control::variable_axis(payload), {}, columns_[number], false};
    ++uses;
    if (a.axis >= 0 && !session_.machine.axes[all_axes[static_cast<std::size_t>(a.axis)]].exists) {
        session_.report(Id::variable_of_missing_axis, token, token + 1, name(a));
        return std::nullopt;
    }
    if (!a.row->readable && !a.row->writable) {
        session_.report(Id::variable_not_accessible, token, token + 1, name(a));
        return std::nullopt;
    }
    if (index && !check_index(a, *index, token)) return std::nullopt;
    // A real value is taken when everything before it has happened (8055 T 11.2).
    if (a.row->stops_preparation) iso_.push_barrier(operation::Barrier::Why::live);
    return a;
}

bool Variables::check_index(Access& a, double index, std::uint16_t token) {
    if (is_unknown(index)) {
        a.unknown_index = true;
        return true;
    }
    const double whole = std::round(index);
    const bool origin = a.column && a.column->name == "ORG";  // two index spaces with a gap between (8055 T 11.2.3)
    if (std::abs(index - whole) <= index_tolerance && whole >= a.row->least_index && whole <= a.row->most_index &&
        (!origin || origin_row(static_cast<long>(whole)) != 0)) {
        a.index = static_cast<long>(whole);
        return true;
    }
    session_.report(a.row->plc_resource ? Id::plc_resource_out_of_range : Id::index_out_of_range, token, token + 1,
                    name(a), index, a.row->least_index, a.row->most_index);
    return false;
}

double Variables::unsupported(const Access& a, std::uint16_t token) {
    session_.report(Id::not_yet_supported, token, token + 1, name(a), a.row->title);
    return unknown_value;
}

double Variables::live(std::string full, std::uint16_t token) {
    if (const auto given = session_.live.value(full)) return *given;
    if (!session_.options.live_may_be_unknown) session_.report(Id::live_value_unknown, token, token + 1, full);
    session_.wanted = std::move(full);
    return unknown_value;
}

double Variables::read(std::uint16_t payload, std::optional<double> index, std::uint16_t token) {
    const auto a = open(payload, index, token);
    if (!a) return unknown_value;
    if (!a->row->readable) {
        session_.report(Id::variable_write_only, token, token + 1, name(*a));
        return unknown_value;
    }
    if (a->unknown_index) return unknown_value;
    if (a->row->name == "NBTOOL") {
        session_.report(Id::outside_tool_subroutine, token, token + 1, name(*a));
        return unknown_value;
    }
    if (a->row->support == control::Support::planned) return unsupported(*a, token);
    if (!written_.empty())
        if (const auto at = written_.find(name(*a)); at != written_.end()) return at->second;
    if (a->row->name == "CALLP") return call_parameters;

    if (a->column && a->index) return a->column->get(session_.machine, *a->index, axis_or_x(*a)) / unit(*a);
    switch (a->row->knowledge) {
        case Knowledge::table:
            return 0;  // a column that no table of the machine holds is empty (TLFN)
        case Knowledge::machine:
            if (const auto at = session_.machine.other_parameters.find(name(*a));
                at != session_.machine.other_parameters.end())
                return at->second;
            return live(name(*a), token);
        case Knowledge::live:
            return live(name(*a), token);
        case Knowledge::program:
        case Knowledge::overridable:
            break;
    }
    if (const auto value = iso_.variable(control::variable_row(payload), a->axis, a->index)) return *value;
    return a->row->initial ? *a->row->initial : unsupported(*a, token);
}

bool Variables::fits(const Access& a, double value, std::uint16_t token) {
    if (is_unknown(value)) return true;
    if (a.row->name == "ANAO") {
        if (*a.index > session_.machine.free_analog_outputs) {
            session_.report(Id::analog_output_busy, token, token + 1, *a.index);
            return false;
        }
        if (std::abs(value) > 10) {
            session_.report(Id::analog_output_out_of_range, token, token + 1, value);
            return false;
        }
    }
    if (a.row->name == "KEYSRC" && value != 0 && value != 1 && value != 2) {
        session_.report(Id::key_source_wrong, token, token + 1, value);
        return false;
    }
    if (a.column && !a.column->range.allows(value)) {
        session_.report(Id::variable_value_wrong, token, token + 1, name(a), value);
        return false;
    }
    return true;
}

void Variables::write(std::uint16_t payload, std::optional<double> index, double value, std::uint16_t token) {
    const auto a = open(payload, index, token);
    if (!a) return;
    if (!a->row->writable || (a->column && !a->index && a->row->index == control::IndexForm::optional)) {
        session_.report(Id::variable_read_only, token, token + 1, name(*a));
        return;
    }
    if (a->row->support == control::Support::planned) return void(unsupported(*a, token));
    if (a->unknown_index || (a->column && is_unknown(value))) {  // which row, or what a table holds, must be known
        session_.blocked = true;
        return;
    }
    if (!fits(*a, value, token)) return;
    if (a->column && a->column->set) {
        a->column->set(session_.machine, *a->index, axis_or_x(*a), value * unit(*a));
        return;
    }
    if (a->row->knowledge == Knowledge::program && iso_.assign(control::variable_row(payload), a->axis, value)) return;
    written_[name(*a)] = value;
}

/// What an operator types is live (8055 T 12.9).
double Variables::entry(double number, std::uint16_t token) {
    ++uses;
    return is_unknown(number) ? unknown_value : live(fmt::format("IB{}", number), token);
}

double Variables::position(std::uint16_t payload, double label, double program, std::uint16_t token) {
    const auto a = open(payload, {}, token);
    if (!a || is_unknown(label) || is_unknown(program)) return unknown_value;
    const auto from = whole_number(program, index_tolerance), block_number = whole_number(label, index_tolerance);
    program::Program* in = session_.program;
    if (in->number() != from) in = from ? session_.library.program(*from) : nullptr;
    const auto at = in && block_number ? in->label(*block_number) : std::nullopt;
    if (!at) {
        session_.report(Id::position_target_missing, token, token + 1, label, program);
        return unknown_value;
    }
    // The block is looked at beside the one that is executed, as it is written: no G91, no unit (8055 T 11.2.7).
    const std::string_view rest = in->text().substr(at->offset);
    const program::Block* block =
        in->rebind(*session_.block, rest.substr(0, rest.find_first_of("\r\n")), session_.diagnostics);
    const auto* iso = block ? std::get_if<program::IsoBlock>(&block->shape->body) : nullptr;
    if (!iso) return not_programmed;
    for (const program::Word& word : block->shape->run(iso->geometry)) {
        if (word.address != letter(axis_or_x(*a))) continue;
        if (word.value.kind == program::WordValue::Kind::none) return 0;
        const double number = block->slots[word.value.slot].value;
        if (word.value.kind == program::WordValue::Kind::number) return number;
        const auto parameter = whole_number(number);
        const double* cell = parameter ? session_.parameters.find(*parameter) : nullptr;
        return !cell ? unknown_value : word.value.negative ? -*cell : *cell;
    }
    return not_programmed;
}

}  // namespace fagorc::passes
