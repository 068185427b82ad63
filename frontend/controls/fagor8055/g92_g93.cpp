// G92 G93: coordinate preset, spindle limit, polar origin (8055 T 4.4, 4.9).
#include "frontend/controls/fagor8055/operands.hpp"
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using program::PolarOrigin;
using program::Preset;

constexpr Operand preset_operands[] = {
    {'S',
     Role::speed,
     Need::optional,
     not_negative,
     at<&Preset::speed_limit>,
     {"highest spindle speed, rpm", "vitesse maximale de la broche, tr/min", "velocidad máxima del cabezal, r.p.m."}},
    {any_axis,
     Role::coordinate,
     Need::optional,
     {},
     at<&Preset::axes>,
     {"value that the present position takes", "valeur que prend la position actuelle",
      "valor que toma la posición actual"}}};

constexpr Operand polar_operands[] = {
    {'I',
     Role::abscissa,
     Need::optional,
     {},
     at<&PolarOrigin::u>,
     {"abscissa of the polar origin", "abscisse de l'origine polaire", "abscisa del origen polar"}},
    {'J',
     Role::ordinate,
     Need::optional,
     {},
     at<&PolarOrigin::v>,
     {"ordinate of the polar origin", "ordonnée de l'origine polaire", "ordenada del origen polar"}}};

}  // namespace

constexpr Construct g92{
    .number = 92,
    .code = "G92",
    .company = Company::alone,
    .takes = Takes::listed,
    .syntax = "G92 X..C5.5 | G92 S5.4",
    .snippet = "G92 X0 Z0",
    .section = "8055 T 4.4",
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
    .section = "8055 T 4.9",
    .title = {"polar origin preset", "présélection de l'origine polaire", "preselección del origen polar"},
    .operands = polar_operands,
    .make = makes<PolarOrigin>,
    .target = target_of<PolarOrigin>};

static_assert(well_formed(g92) && well_formed(g93));

}  // namespace fagorc::frontend::fagor8055
