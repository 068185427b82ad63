// G72: scale factor (8055 T 7.6).
#include "frontend/controls/fagor8055/operands.hpp"
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using program::Scale;

constexpr Operand operands[] = {
    {.address = 'S',
     .role = Role::factor,
     .need = Need::alternative,
     .range = positive,
     .slot = at<&Scale::general>,
     .text = {"factor of all axes; 1: off", "facteur de tous les axes ; 1 : annulation",
              "factor de todos los ejes; 1: anulación"}},
    {.address = any_axis,
     .role = Role::factor,
     .need = Need::alternative,
     .range = positive,
     .slot = at<&Scale::axes>,
     .text = {"factor of the axis; 1: off", "facteur de l'axe ; 1 : annulation", "factor del eje; 1: anulación"}}};

}  // namespace

constexpr Construct g72{.number = 72,
                        .code = "G72",
                        .lasts = true,
                        .support = Support::planned,
                        .company = Company::alone,
                        .takes = Takes::listed,
                        .syntax = "G72 S5.5 | G72 X..C5.5",
                        .snippet = "G72 S0.5\nG01 X100 F100\nG72 S1",
                        .section = "8055 T 7.6",
                        .title = {"scale factor", "facteur d'échelle", "factor de escala"},
                        .operands = operands,
                        .make = makes<Scale>,
                        .target = target_of<Scale>,
                        .misuse = diag::Id::scale_operands,
                        .out_of_range = diag::Id::scale_out_of_range};
static_assert(well_formed(g72));

}  // namespace fagorc::frontend::fagor8055
