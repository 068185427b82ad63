// Probing cycles and return from interruptions (8055 T 10.3 to 10.6, 12.6, 12.7).
#include "frontend/controls/fagor8055/statements.hpp"

#include "frontend/controls/fagor8055/operands.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using control::StatementRow;
using control::Support;

constexpr Operand cycle_operands[] = {{.address = '1',
                                       .role = Role::choice,
                                       .need = Need::required,
                                       .range = {.least = 1, .most = 4, .whole = true},
                                       .text = {"number of the cycle", "numéro du cycle", "número del ciclo"}}};

// Where the probe stands, for the call at hand alone.
constexpr Operand lowest_x = {.address = 'X',
                              .role = Role::machine_coordinate,
                              .text = {"lowest position of the probe along X, for this call",
                                       "position minimale du palpeur suivant X, pour cet appel",
                                       "posición mínima del palpador según X, para esta llamada"}};
constexpr Operand highest_x = {.address = 'U',
                               .role = Role::machine_coordinate,
                               .text = {"highest position of the probe along X, for this call",
                                        "position maximale du palpeur suivant X, pour cet appel",
                                        "posición máxima del palpador según X, para esta llamada"}};
constexpr Operand lowest_y = {.address = 'Y',
                              .role = Role::machine_coordinate,
                              .text = {"lowest position of the probe along Y, for this call",
                                       "position minimale du palpeur suivant Y, pour cet appel",
                                       "posición mínima del palpador según Y, para esta llamada"}};
constexpr Operand highest_y = {.address = 'V',
                               .role = Role::machine_coordinate,
                               .text = {"highest position of the probe along Y, for this call",
                                        "position maximale du palpeur suivant Y, pour cet appel",
                                        "posición máxima del palpador según Y, para esta llamada"}};
constexpr Operand lowest_z = {.address = 'Z',
                              .role = Role::machine_coordinate,
                              .text = {"lowest position of the probe along Z, for this call",
                                       "position minimale du palpeur suivant Z, pour cet appel",
                                       "posición mínima del palpador según Z, para esta llamada"}};
constexpr Operand highest_z = {.address = 'W',
                               .role = Role::machine_coordinate,
                               .text = {"highest position of the probe along Z, for this call",
                                        "position maximale du palpeur suivant Z, pour cet appel",
                                        "posición máxima del palpador según Z, para esta llamada"}};

constexpr Operand tool_calibration_operands[] = {
    {.address = 'B',
     .role = Role::length,
     .need = Need::required,
     .range = positive,
     .text = {"safety distance", "distance de sécurité", "distancia de seguridad"}},
    {.address = 'J',
     .role = Role::choice,
     .range = {.least = 0, .most = 1, .whole = true},
     .text = {"0 calibration, 1 wear measurement", "0 étalonnage, 1 mesure d'usure",
              "0 calibrado, 1 medición de desgaste"}},
    {.address = 'F',
     .role = Role::feed,
     .need = Need::required,
     .range = positive,
     .text = {"probing feed, mm/min or inch/min", "avance de palpage, mm/min ou pouces/min",
              "avance de palpación, mm/min o pulgadas/min"}},
    {.address = 'L',
     .role = Role::length,
     .range = not_negative,
     .text = {"largest wear along X; 0: not checked", "usure maximale suivant X ; 0 : non contrôlée",
              "desgaste máximo según X; 0: sin control"}},
    {.address = 'M',
     .role = Role::length,
     .range = not_negative,
     .text = {"largest wear along Z; 0: not checked", "usure maximale suivant Z ; 0 : non contrôlée",
              "desgaste máximo según Z; 0: sin control"}},
    {.address = 'N',
     .role = Role::length,
     .range = not_negative,
     .text = {"largest wear along Y; 0: not checked", "usure maximale suivant Y ; 0 : non contrôlée",
              "desgaste máximo según Y; 0: sin control"}},
    {.address = 'C',
     .role = Role::choice,
     .range = {.least = 0, .most = 1, .whole = true},
     .text = {"worn tool: 0 stop, 1 next of the family", "outil usé : 0 arrêt, 1 suivant de la famille",
              "herramienta gastada: 0 parada, 1 siguiente de la familia"}},
    lowest_x,
    highest_x,
    lowest_y,
    highest_y,
    lowest_z,
    highest_z};

constexpr Operand probe_calibration_operands[] = {
    {.address = 'B',
     .role = Role::length,
     .need = Need::required,
     .range = positive,
     .text = {"safety distance", "distance de sécurité", "distancia de seguridad"}},
    {.address = 'F',
     .role = Role::feed,
     .need = Need::required,
     .range = positive,
     .text = {"probing feed, mm/min or inch/min", "avance de palpage, mm/min ou pouces/min",
              "avance de palpación, mm/min o pulgadas/min"}},
    lowest_x,
    highest_x,
    lowest_z,
    highest_z};

constexpr Operand measurement_operands[] = {
    {.address = 'X',
     .role = Role::ordinate,
     .need = Need::required,
     .text = {"theoretical X of the point", "cote X théorique du point", "cota X teórica del punto"}},
    {.address = 'Z',
     .role = Role::abscissa,
     .need = Need::required,
     .text = {"theoretical Z of the point", "cote Z théorique du point", "cota Z teórica del punto"}},
    {.address = 'B',
     .role = Role::length,
     .need = Need::required,
     .range = positive,
     .text = {"safety distance", "distance de sécurité", "distancia de seguridad"}},
    {.address = 'F',
     .role = Role::feed,
     .need = Need::required,
     .range = positive,
     .text = {"probing feed, mm/min or inch/min", "avance de palpage, mm/min ou pouces/min",
              "avance de palpación, mm/min o pulgadas/min"}},
    {.address = 'L',
     .role = Role::length,
     .range = not_negative,
     .text = {"error from which the offset is corrected", "erreur à partir de laquelle le correcteur est modifié",
              "error a partir del cual se corrige el corrector"}},
    {.address = 'D',
     .role = Role::row,
     .range = {.least = 0, .most = 255, .whole = true},
     .text = {"tool offset to correct; 0 or none: no correction", "correcteur à modifier ; 0 ou absent : aucun",
              "corrector que se modifica; 0 o ausente: ninguno"}}};

constexpr StatementRow table[] = {
    {.word = "PROBE",
     .support = Support::planned,
     .syntax = "(PROBE 1..4 [, assignment, ...])",
     .snippet = "(PROBE 1, B5, J0, F100)",
     .section = "8055 T 12.6",
     .title = {"probing cycle", "cycle de palpage", "ciclo de palpador"},
     .operands = cycle_operands},
    {.word = "PROBE 1",
     .support = Support::planned,
     .syntax = "(PROBE 1, B5.5, [J0..1], F5.5, [L5.5], [M5.5], [N5.5], [C0..1], [X5.5], [U5.5], [Y5.5], [V5.5], "
               "[Z5.5], [W5.5])",
     .snippet = "T4 D4\n(PROBE 1, B5, J0, F100)",
     .section = "8055 T 10.3",
     .title = {"tool calibration", "cycle d'étalonnage d'outil", "ciclo de calibrado de herramienta"},
     .operands = tool_calibration_operands},
    {.word = "PROBE 2",
     .support = Support::planned,
     .syntax = "(PROBE 2, B5.5, F5.5, [X5.5], [U5.5], [Z5.5], [W5.5])",
     .snippet = "T9 D9\n(PROBE 2, B5, F100)",
     .section = "8055 T 10.4",
     .title = {"probe calibration", "cycle d'étalonnage de palpeur", "ciclo de calibrado de palpador"},
     .operands = probe_calibration_operands},
    {.word = "PROBE 3",
     .support = Support::planned,
     .syntax = "(PROBE 3, X5.5, Z5.5, B5.5, F5.5, [L5.5], [D3])",
     .snippet = "T10 D10\nG00 X100 Z20\n(PROBE 3, X60, Z-15, B3, F80, L0.02, D1)",
     .section = "8055 T 10.5",
     .title = {"part measurement and tool correction along X",
               "cycle de mesure de pièce et correction d'outil sur l'axe X",
               "ciclo de medida de pieza y corrección de herramienta en el eje X"},
     .operands = measurement_operands},
    {.word = "PROBE 4",
     .support = Support::planned,
     .syntax = "(PROBE 4, X5.5, Z5.5, B5.5, F5.5, [L5.5], [D3])",
     .snippet = "T10 D10\nG00 X100 Z20\n(PROBE 4, X40, Z0, B3, F80, L0.02, D1)",
     .section = "8055 T 10.6",
     .title = {"part measurement and tool correction along Z",
               "cycle de mesure de pièce et correction d'outil sur l'axe Z",
               "ciclo de medida de pieza y corrección de herramienta en el eje Z"},
     .operands = measurement_operands},
    {.word = "REPOS",
     .support = Support::planned,
     .syntax = "(REPOS axis, axis, ...)",
     .snippet = "(REPOS X, Z)",
     .section = "8055 T 12.7",
     .title = {"return to the point of interruption", "repositionnement au point d'interruption",
               "reposición en el punto de interrupción"}}};
static_assert(well_formed(std::span<const StatementRow>(table)));

}  // namespace

std::span<const StatementRow> probe_statements() {
    return table;
}

}  // namespace fagorc::frontend::fagor8055
