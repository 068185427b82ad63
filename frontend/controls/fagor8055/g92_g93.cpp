// G92 G93: coordinate preset, spindle limit, polar origin (8055 T 4.4.1, 4.5).
#include "frontend/controls/fagor8055/operands.hpp"
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using program::PolarOrigin;
using program::Preset;

constexpr Operand preset_operands[] = {
    {.address = 'S',
     .role = Role::speed,
     .need = Need::alternative,
     .range = not_negative,
     .slot = at<&Preset::speed_limit>,
     .text = {"highest spindle speed, rpm", "vitesse maximale de la broche, tr/min",
              "velocidad máxima del cabezal, r.p.m."}},
    {.address = any_axis,
     .role = Role::coordinate,
     .need = Need::alternative,
     .slot = at<&Preset::axes>,
     .text = {"value that the present position takes", "valeur que prend la position actuelle",
              "valor que toma la posición actual"}}};

constexpr Operand polar_operands[] = {
    {.address = 'I',
     .role = Role::abscissa,
     .need = Need::together,
     .slot = at<&PolarOrigin::u>,
     .text = {"abscissa of the polar origin", "abscisse de l'origine polaire", "abscisa del origen polar"}},
    {.address = 'J',
     .role = Role::ordinate,
     .need = Need::together,
     .slot = at<&PolarOrigin::v>,
     .text = {"ordinate of the polar origin", "ordonnée de l'origine polaire", "ordenada del origen polar"}}};

}  // namespace

constexpr Construct g92{
    .number = 92,
    .code = "G92",
    .company = Company::alone,
    .takes = Takes::listed,
    .syntax = "G92 X..C5.5 | G92 S5.4",
    .snippet = "G92 X0 Z0",
    .section = "8055 T 4.4.1",
    .title = {"coordinate preset, spindle speed limit", "présélection de cotes, limitation de la vitesse de broche",
              "preselección de cotas, limitación de la velocidad del cabezal"},
    .operands = preset_operands,
    .make = makes<Preset>,
    .target = target_of<Preset>};

constexpr Construct g93{
    .number = 93,
    .code = "G93",
    .company = Company::alone,
    .takes = Takes::listed,
    .syntax = "G93 | G93 I5.5 J5.5",
    .snippet = "G93 I90 J160",
    .section = "8055 T 4.5",
    .title = {"polar origin preset", "présélection de l'origine polaire", "preselección del origen polar"},
    .operands = polar_operands,
    .make = makes<PolarOrigin>,
    .target = target_of<PolarOrigin>,
    .misuse = diag::Id::polar_origin_operands};

static_assert(well_formed(g92) && well_formed(g93));

}  // namespace fagorc::frontend::fagor8055
