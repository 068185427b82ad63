// G33 G34 G233: threads of constant and variable pitch, withdrawal from a thread (8055 T 6.12 to 6.14).
#include "frontend/controls/fagor8055/operands.hpp"
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

constexpr Operand pitch{
    .address = 'L', .role = Role::lead, .need = Need::required, .text = {"pitch", "pas du filet", "paso de rosca"}};
constexpr Operand start_angle{
    .address = 'Q',
    .role = Role::angle,
    .range = {.least = -359.9999, .most = 359.9999},
    .text = {"spindle angle of the start of the thread", "angle de la broche au début du filet",
             "ángulo del cabezal al comienzo de la rosca"}};

constexpr Operand thread_operands[] = {end_point, pitch, start_angle};

constexpr Operand variable_operands[] = {
    end_point,
    pitch,
    start_angle,
    {.address = 'K',
     .role = Role::lead,
     .need = Need::required,
     .text = {"change of the pitch in a spindle turn", "variation du pas par tour de broche",
              "incremento del paso por vuelta del cabezal"}}};

constexpr Operand withdrawal_operands[] = {
    {.address = any_axis,
     .role = Role::distance,
     .slot = at<&program::ThreadWithdrawal::axes>,
     .text = {"distance that the axis withdraws", "distance de retrait de l'axe", "distancia que se retira el eje"}}};

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
                        .operands = thread_operands,
                        .misuse = diag::Id::pitch_missing,
                        .out_of_range = diag::Id::thread_angle_out_of_range};

constexpr Construct g34{.number = 34,
                        .code = "G34",
                        .group = Group::motion,
                        .setting = setting(program::Motion::variable_thread),
                        .support = Support::planned,
                        .takes = Takes::motion,
                        .syntax = "G34 X..C5.5 L5.5 [Q3.5] K5.5",
                        .snippet = "S500 M03\nG00 X40 Z10\nG34 Z-60 L2 K0.5",
                        .section = "8055 T 6.14",
                        .title = {"variable-pitch threading", "filets à pas variable", "roscado de paso variable"},
                        .operands = variable_operands,
                        .misuse = diag::Id::pitch_missing,
                        .out_of_range = diag::Id::thread_angle_out_of_range};

constexpr Construct g233{
    .number = 233,
    .code = "G233",
    .lasts = true,
    .support = Support::planned,
    .company = Company::alone,
    .takes = Takes::listed,
    .syntax = "G233 [X..C5.5]",
    .snippet = "G233 X5 Z-20",
    .section = "8055 T 6.13",
    .title = {"withdrawal of the axes when a thread is stopped", "retrait des axes face à un arrêt lors du filetage",
              "retirada de ejes ante una parada en el roscado"},
    .operands = withdrawal_operands,
    .make = makes<program::ThreadWithdrawal>,
    .target = target_of<program::ThreadWithdrawal>};

static_assert(well_formed(g33) && well_formed(g34) && well_formed(g233));

}  // namespace fagorc::frontend::fagor8055
