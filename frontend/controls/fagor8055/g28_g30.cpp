// G28 G29 G30: the second spindle, swapped axes (8055 T 5.4, 5.5, 7.8).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using program::AxisSwap;

constexpr Operand swap_operands[] = {
    {.address = any_axis,
     .role = Role::axis_name,
     .slot = at<&AxisSwap::axes>,
     .text = {"two axes to swap; none: the second spindle", "deux axes à commuter ; sans axe : seconde broche",
              "dos ejes que se conmutan; sin ejes: segundo cabezal"}}};

constexpr Operand undo_operands[] = {{.address = any_axis,
                                      .role = Role::axis_name,
                                      .slot = at<&AxisSwap::axes>,
                                      .text = {"an axis of the pair to undo; none: the main spindle",
                                               "un axe de la paire à rétablir ; sans axe : broche principale",
                                               "un eje de la pareja que se anula; sin ejes: cabezal principal"}}};

constexpr Operand phase_operands[] = {
    {.address = 'D',
     .role = Role::angle,
     .need = Need::required,
     .range = {.least = -359.9999, .most = 359.9999},
     .slot = at<&program::SpindlePhase::lag>,
     .text = {"lag of the second spindle", "déphasage de la seconde broche", "desfase del segundo cabezal"}}};

}  // namespace

constexpr Construct g28{.number = 28,
                        .code = "G28",
                        .group = Group::spindle,
                        .setting = setting(program::Spindle::second),
                        .support = Support::planned,
                        .company = Company::alone,
                        .takes = Takes::listed,
                        .syntax = "G28 | G28 axis1 axis2",
                        .snippet = "G28 Z W",
                        .section = "8055 T 5.4",
                        .title = {"second spindle, axis swap", "sélection de la seconde broche, commutation d'axes",
                                  "selección del segundo cabezal, conmutación de ejes"},
                        .operands = swap_operands,
                        .make = makes<AxisSwap>,
                        .target = target_of<AxisSwap>,
                        .least_axes = 2,
                        .most_axes = 2};

constexpr Construct g29{
    .number = 29,
    .code = "G29",
    .group = Group::spindle,
    .setting = setting(program::Spindle::main),
    .support = Support::planned,
    .company = Company::alone,
    .takes = Takes::listed,
    .syntax = "G29 | G29 axis",
    .snippet = "G29",
    .section = "8055 T 5.4",
    .title = {"main spindle, end of axis swap", "sélection de la broche principale, fin de commutation d'axes",
              "selección del cabezal principal, fin de conmutación de ejes"},
    .operands = undo_operands,
    .make = +[]() -> program::Function { return AxisSwap{.undo = true, .axes = {}}; },
    .target = target_of<AxisSwap>,
    .most_axes = 2};

constexpr Construct g30{.number = 30,
                        .code = "G30",
                        .lasts = true,
                        .support = Support::planned,
                        .company = Company::alone_expected,
                        .takes = Takes::listed,
                        .syntax = "G30 D3.4",
                        .snippet = "G77 S\nG30 D90\nG78 S",
                        .section = "8055 T 5.5",
                        .title = {"spindle synchronisation in position", "synchronisation des broches en position",
                                  "sincronización de cabezales en posición"},
                        .operands = phase_operands,
                        .make = makes<program::SpindlePhase>,
                        .target = target_of<program::SpindlePhase>,
                        .misuse = diag::Id::spindle_phase_operands,
                        .out_of_range = diag::Id::spindle_phase_out_of_range};

static_assert(well_formed(g28) && well_formed(g29) && well_formed(g30));

}  // namespace fagorc::frontend::fagor8055
