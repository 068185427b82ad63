// G74: home search (8055 T 4.2).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

constexpr Operand operands[] = {{.address = any_axis,
                                 .role = Role::axis_name,
                                 .slot = at<&program::Home::axes>,
                                 .text = {"axes, in the order of their search", "axes, dans l'ordre de leur recherche",
                                          "ejes, en el orden de búsqueda"}}};

}  // namespace

constexpr Construct g74{
    .number = 74,
    .code = "G74",
    .company = Company::no_other_g,
    .takes = Takes::listed,
    .syntax = "G74 | G74 axis...",
    .snippet = "G74 X Z",
    .section = "8055 T 4.2",
    .title = {"machine reference (home) search", "recherche de référence machine", "búsqueda de referencia máquina"},
    .operands = operands,
    .make = makes<program::Home>,
    .target = target_of<program::Home>};
static_assert(well_formed(g74));

}  // namespace fagorc::frontend::fagor8055
