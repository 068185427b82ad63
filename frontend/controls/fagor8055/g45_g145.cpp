// G45 G145: tangential control of a rotary axis (8055 T 6.18, 6.19).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

constexpr Operand control_operands[] = {
    {.address = any_axis,
     .role = Role::angle,
     .range = {.least = -359.9999, .most = 359.9999},
     .slot = at<&program::TangentialControl::axis>,
     .text = {"rotary axis and its angle to the path; none: off",
              "axe rotatif et son angle par rapport à la trajectoire ; aucun : désactivation",
              "eje rotativo y su ángulo respecto a la trayectoria; ninguno: anulación"}}};

constexpr Operand pause_operands[] = {
    {.address = 'K',
     .role = Role::choice,
     .range = {.least = 0, .most = 1, .whole = true},
     .slot = at<&program::TangentialPause::resume>,
     .text = {"0 or none: suspend, 1: resume", "0 ou absent : suspendre, 1 : reprendre",
              "0 o ausente: suspender, 1: reanudar"}}};

}  // namespace

constexpr Construct g45{.number = 45,
                        .code = "G45",
                        .lasts = true,
                        .support = Support::planned,
                        .company = Company::alone_expected,
                        .takes = Takes::listed,
                        .syntax = "G45 A|B|C[3.4] | G45",
                        .snippet = "G45 C90\nG01 X10 Z20 F100\nG45",
                        .section = "8055 T 6.18",
                        .title = {"tangential control", "contrôle tangentiel", "control tangencial"},
                        .operands = control_operands,
                        .make = makes<program::TangentialControl>,
                        .target = target_of<program::TangentialControl>,
                        .most_axes = 1};

constexpr Construct g145{
    .number = 145,
    .code = "G145",
    .lasts = true,
    .support = Support::planned,
    .company = Company::alone_expected,
    .takes = Takes::listed,
    .syntax = "G145 [K0..1]",
    .snippet = "G45 C90\nG145 K0\nG145 K1",
    .section = "8055 T 6.19",
    .title = {"suspension of tangential control", "désactivation temporaire du contrôle tangentiel",
              "desactivación temporal del control tangencial"},
    .operands = pause_operands,
    .make = makes<program::TangentialPause>,
    .target = target_of<program::TangentialPause>};

static_assert(well_formed(g45) && well_formed(g145));

}  // namespace fagorc::frontend::fagor8055
