// G33: thread of constant pitch (8055 T 6.12).
#include "frontend/controls/fagor8055/operands.hpp"
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

constexpr Operand operands[] = {
    end_point,
    {.address = 'L', .role = Role::lead, .need = Need::required, .text = {"pitch", "pas du filet", "paso de rosca"}},
    {.address = 'Q',
     .role = Role::angle,
     .range = {.least = -359.9999, .most = 359.9999},
     .text = {"spindle angle of the start of the thread", "angle de la broche au début du filet",
              "ángulo del cabezal al comienzo de la rosca"}}};

}  // namespace

constexpr Construct g33{.number = 33,
                        .code = "G33",
                        .group = Group::motion,
                        .setting = setting(program::Motion::thread),
                        .takes = Takes::motion,
                        .syntax = "G33 X..C5.5 L5.5 [Q3.5]",
                        .snippet = "S500 M03\nG00 X116 Z180\nG33 Z40 L5",
                        .section = "8055 T 6.12",
                        .title = {"electronic threading", "filetage électronique", "roscado electrónico"},
                        .operands = operands,
                        .misuse = diag::Id::pitch_missing,
                        .out_of_range = diag::Id::thread_angle_out_of_range};
static_assert(well_formed(g33));

}  // namespace fagorc::frontend::fagor8055
