// G05 G07 G50 G51: how the path goes through corners (8055 T 7.3, 7.4).
#include "frontend/controls/fagor8055/operands.hpp"
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using program::Corner;
using program::LookAhead;

constexpr Operand look_ahead_operands[] = {
    {.address = 'A',
     .role = Role::percent,
     .range = {.least = 0, .most = 255},
     .slot = at<&LookAhead::acceleration>,
     .text = {"percentage of the acceleration; 0 or none: the machine parameter's",
              "pourcentage d'accélération ; 0 ou absent : celle du paramètre machine",
              "porcentaje de aceleración; 0 o ausente: la del parámetro máquina"}},
    {.address = 'E',
     .role = Role::length,
     .need = Need::required,
     .range = positive,
     .slot = at<&LookAhead::error>,
     .text = {"contour error allowed", "erreur de contour permise", "error de contorno permitido"}},
    {.address = 'B',
     .role = Role::angle,
     .range = {.least = 0, .most = 180},
     .slot = at<&LookAhead::corner_angle>,
     .text = {"corners below this angle are machined square",
              "les angles inférieurs à cette valeur s'usinent en arête vive",
              "los ángulos inferiores a este valor se mecanizan en arista viva"}}};

}  // namespace

constexpr Construct g05{.number = 5,
                        .code = "G05",
                        .group = Group::corner,
                        .setting = setting(Corner::round),
                        .syntax = "G05",
                        .snippet = "G05 G01 X40 F100",
                        .section = "8055 T 7.3",
                        .title = {"round corner", "arête arrondie", "arista matada"}};

constexpr Construct g07{.number = 7,
                        .code = "G07",
                        .group = Group::corner,
                        .setting = setting(Corner::square),
                        .syntax = "G07",
                        .snippet = "G07 G01 X40 F100",
                        .section = "8055 T 7.3",
                        .title = {"square corner", "arête vive", "arista viva"}};

constexpr Construct g50{.number = 50,
                        .code = "G50",
                        .group = Group::corner,
                        .setting = setting(Corner::controlled),
                        .syntax = "G50",
                        .snippet = "G50 G01 X40 F100",
                        .section = "8055 T 7.3",
                        .title = {"controlled round corner", "arête arrondie commandée", "arista matada controlada"}};

constexpr Construct g51{
    .number = 51,
    .code = "G51",
    .group = Group::corner,
    .setting = setting(Corner::look_ahead),
    .company = Company::alone,
    .takes = Takes::listed,
    .syntax = "G51 [A0..255] E5.5 [B0..180]",
    .snippet = "G51 A50 E0.05 B90",
    .section = "8055 T 7.4",
    .title = {"look-ahead", "anticipation de trajectoire (look-ahead)", "análisis anticipado de bloques (look-ahead)"},
    .operands = look_ahead_operands,
    .make = makes<LookAhead>,
    .target = target_of<LookAhead>,
    .misuse = diag::Id::look_ahead_operands,
    .out_of_range = diag::Id::look_ahead_out_of_range};

static_assert(well_formed(g05) && well_formed(g07) && well_formed(g50) && well_formed(g51));

}  // namespace fagorc::frontend::fagor8055
