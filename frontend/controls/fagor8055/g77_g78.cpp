// G77 G78: coupled axes, synchronised spindles (8055 T 7.7, 5.5).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using program::Coupling;

constexpr Operand couple_operands[] = {
    {.address = 'S',
     .role = Role::choice,
     .need = Need::alternative,
     .slot = named<&Coupling::spindle>,
     .text = {"synchronises the spindles instead", "synchronise les broches", "sincroniza los cabezales"}},
    {.address = any_axis,
     .role = Role::axis_name,
     .need = Need::alternative,
     .slot = at<&Coupling::axes>,
     .text = {"master axis, then slaved axes", "axe maître, puis axes subordonnés",
              "eje maestro y ejes subordinados"}}};

constexpr Operand undo_operands[] = {
    {.address = 'S',
     .role = Role::choice,
     .slot = named<&Coupling::spindle>,
     .text = {"ends the synchronisation of the spindles", "annule la synchronisation des broches",
              "anula la sincronización de los cabezales"}},
    {.address = any_axis,
     .role = Role::axis_name,
     .slot = at<&Coupling::axes>,
     .text = {"slaved axes to free; none: all", "axes subordonnés à libérer ; aucun : tous",
              "ejes subordinados que se liberan; ninguno: todos"}}};

}  // namespace

constexpr Construct g77{
    .number = 77,
    .code = "G77",
    .lasts = true,
    .support = Support::planned,
    .company = Company::alone_expected,
    .takes = Takes::listed,
    .syntax = "G77 axis1 axis2 [axis3...] | G77 S",
    .snippet = "G77 X U",
    .section = "8055 T 7.7.1",
    .title = {"axis coupling, spindle synchronisation", "couplage électronique d'axes, synchronisation des broches",
              "acoplo electrónico de ejes, sincronización de cabezales"},
    .operands = couple_operands,
    .make = makes<Coupling>,
    .target = target_of<Coupling>,
    .least_axes = 2,
    .most_axes = 6,
    .misuse = diag::Id::coupling_axes};

constexpr Construct g78{
    .number = 78,
    .code = "G78",
    .lasts = true,
    .support = Support::planned,
    .company = Company::alone_expected,
    .takes = Takes::listed,
    .syntax = "G78 [axis...] | G78 S",
    .snippet = "G77 X U\nG78",
    .section = "8055 T 7.7.2",
    .title = {"end of axis coupling, of spindle synchronisation",
              "annulation du couplage d'axes, de la synchronisation des broches",
              "anulación del acoplo de ejes, de la sincronización de cabezales"},
    .operands = undo_operands,
    .make = +[]() -> program::Function { return Coupling{.undo = true, .spindle = false, .axes = {}}; },
    .target = target_of<Coupling>};

static_assert(well_formed(g77) && well_formed(g78));

}  // namespace fagorc::frontend::fagor8055
