// Values of ISO words: parameters, formats, units, X as a diameter (8055 T 2, 3.3, 3.5).
#include <cmath>

#include "passes/execute/iso_control.hpp"

namespace fagorc::passes {

using control::Role;
using program::Word;
using program::WordValue;

namespace {

constexpr double mm_per_inch = 25.4;
/// Words go to 99999.9999 mm and degrees, 3937.00787 inches (8055 T 2).
constexpr double limit_mm = 1e5, limit_inch = 3937.007875;
/// Centres and radii of arcs have one digit more.
constexpr double digits_of_centre = 10;

}  // namespace

double IsoRunner::Control::other_number(const Word& word) {
    if (word.value.kind == WordValue::Kind::none) {
        session.report_once(diag::Id::number_left_out, word.token, word.end_token, word.address);
        return 0;
    }
    if (word.value.kind == WordValue::Kind::literal) return word.value.slot;
    const double number = session.block->slots[word.value.slot].value;
    const double* cell = session.parameter(number, word.token, word.end_token);
    if (cell == nullptr) return 0;
    if (is_unknown(*cell)) session.blocked = true;
    return word.value.negative ? -*cell : *cell;
}

double IsoRunner::Control::rounded(const Word& word, double value) {
    session.report(diag::Id::decimals_rounded, word.token, word.end_token, word.address, most_decimals);
    const double steps = std::pow(10, most_decimals);
    const double v = std::round(value * steps) / steps;
    if (!(std::abs(v) < word_limit)) beyond_format(word, v);
    return v;
}

void IsoRunner::Control::beyond_format(const Word& word, double value) {
    if (is_unknown(value)) {
        session.blocked = true;
    } else if (state.modal.unit == program::LengthUnit::inch) {
        session.report(diag::Id::inch_limit_exceeded, word.token, word.end_token, word.address, limit_inch);
    } else {
        session.report(diag::Id::number_too_long, word.token, word.end_token, word.address,
                       session.dialect.coordinate.integer_digits, session.dialect.coordinate.decimals_mm);
    }
}

double IsoRunner::Control::converted(Role role, Axis axis, double value) const {
    switch (role) {
        case Role::coordinate:
        case Role::centre_point:
            return value * scale[axis];
        case Role::abscissa:
            return value * scale[state.modal.plane.u];
        case Role::ordinate:
            return value * scale[state.modal.plane.v];
        case Role::machine_coordinate:
        case Role::distance:
            return is_rotary(axis) ? value : value * unit;
        case Role::centre:
        case Role::distance_u:
        case Role::distance_v:
        case Role::length:
        case Role::lead:
        case Role::feed:
            return value * unit;
        case Role::none:
        case Role::axis_name:
        case Role::angle:
        case Role::speed:
        case Role::factor:
        case Role::percent:
        case Role::count:
        case Role::row:
        case Role::choice:
        case Role::label:
        case Role::program:
        case Role::hundredths:
            return value;
    }
    return value;
}

bool IsoRunner::Control::allowed(const control::Construct& row, const control::Operand& operand, const Word& word,
                                 double value) {
    if (is_unknown(value)) return true;
    if (!operand.range.allows(value)) {
        session.report(row.out_of_range, word.token, word.end_token, word.address, row.code, to_string(operand.range));
        return false;
    }
    const bool wide = operand.role == Role::centre || operand.role == Role::length;
    if (std::abs(value) >= limit_mm * (wide ? digits_of_centre : 1)) {
        const auto& format = wide ? session.dialect.centre : session.dialect.coordinate;
        session.report(diag::Id::number_too_long, word.token, word.end_token, word.address, format.integer_digits,
                       format.decimals_mm);
        return false;
    }
    return true;
}

std::optional<std::uint32_t> IsoRunner::Control::whole(const Word& word) {
    const double v = number(word);
    if (session.ends()) return std::nullopt;
    if (v < 0) {
        session.report(diag::Id::negative_not_allowed, word.token, word.end_token, word.address, v);
        return std::nullopt;
    }
    if (v != std::trunc(v)) {
        session.report(diag::Id::decimals_not_allowed, word.token, word.end_token, word.address, v);
        return std::nullopt;
    }
    return static_cast<std::uint32_t>(std::min(v, limit_mm));
}

void IsoRunner::Control::units_changed() {
    const bool inch = state.modal.unit == program::LengthUnit::inch;
    unit = inch ? mm_per_inch : 1;
    word_limit = inch ? limit_inch : limit_mm;
    most_decimals = static_cast<std::uint8_t>(inch ? session.dialect.coordinate.decimals_inch
                                                   : session.dialect.coordinate.decimals_mm);
    for (Axis a : all_axes) scale[a] = is_rotary(a) ? 1 : unit;
    if (state.modal.x == program::XWord::diameter) scale[Axis::X] = unit / 2;
}

}  // namespace fagorc::passes
