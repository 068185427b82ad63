// G86 G87: longitudinal and face threading (8055 T 9.9, 9.10).
#include "frontend/controls/fagor8055/cycle_operands.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using Cycle = operation::Threading;
using operation::Cut;

constexpr Text repair_text{"coordinate along the thread at which a groove was measured, to repair a thread",
                           "cote le long du filet où un sillon a été mesuré, pour réparer un filet",
                           "cota a lo largo de la rosca en la que se midió un surco, para repasar roscas"};
constexpr Text depth_text{"depth of the thread: G86 positive outside; G87 positive towards -Z",
                          "profondeur du filet : G86 positive à l'extérieur ; G87 positive vers -Z",
                          "profundidad de la rosca: G86 positiva en exteriores; G87 positiva hacia -Z"};

constexpr Operand repair_z{.address = 'K', .role = Role::abscissa, .slot = at<&Cycle::repair>, .text = repair_text};
constexpr Operand repair_x{.address = 'K', .role = Role::ordinate, .slot = at<&Cycle::repair>, .text = repair_text};
constexpr Operand depth_x{.address = 'I',
                          .role = Role::distance_v,
                          .need = Need::required,
                          .range = not_zero,
                          .slot = at<&Cycle::depth>,
                          .text = depth_text};
constexpr Operand depth_z{.address = 'I',
                          .role = Role::distance_u,
                          .need = Need::required,
                          .range = not_zero,
                          .slot = at<&Cycle::depth>,
                          .text = depth_text};
constexpr Operand infeed{.address = 'B',
                         .role = Role::length,
                         .need = Need::required,
                         .range = not_zero,
                         .slot = at<&Cycle::infeed>,
                         .text = {"infeed; positive: B times the root of the pass number; negative: the same for all",
                                  "pénétration ; positive : B par racine du numéro de passe ; négative : constante",
                                  "penetración; positiva: B por la raíz del número de pasada; negativa: constante"}};
constexpr Operand least_infeed{.address = 'E',
                               .role = Role::length,
                               .range = not_negative,
                               .slot = at<&Cycle::least_infeed>,
                               .text = {"smallest infeed", "pénétration minimale", "penetración mínima"}};
constexpr Operand safety{.address = 'D',
                         .role = Role::length,
                         .slot = at<&Cycle::approach>,
                         .text = {"safety distance; positive: return in G05, negative: in G07",
                                  "distance de sécurité ; positive : retour en G05, négative : en G07",
                                  "distancia de seguridad; positiva: retorno en G05, negativa: en G07"}};
constexpr Operand allowance{
    .address = 'L',
    .role = Role::length,
    .slot = at<&Cycle::allowance>,
    .text = {
        "finishing stock; positive: infeed at the angle, negative: radial, 0: last pass again",
        "surépaisseur de finition ; positive : pénétration suivant l'angle, négative : radiale, 0 : répétition de la "
        "dernière passe",
        "demasía de acabado; positiva: penetración según el ángulo, negativa: radial, 0: repite la última pasada"}};
constexpr Operand lead{.address = 'C',
                       .role = Role::lead,
                       .need = Need::required,
                       .range = not_zero,
                       .slot = at<&Cycle::lead>,
                       .text = {"pitch; positive along the taper, negative along the axis",
                                "pas ; positif suivant le cône, négatif suivant l'axe associé",
                                "paso; positivo según el cono, negativo según el eje asociado"}};
constexpr Operand exit_length{
    .address = 'J',
    .role = Role::length,
    .slot = at<&Cycle::exit>,
    .text = {
        "length of the thread exit; positive: to the safety line, negative: to the end point",
        "longueur de la sortie du filet ; positive : jusqu'à la ligne de sécurité, négative : jusqu'au point final",
        "longitud de la salida de rosca; positiva: hasta la línea de seguridad, negativa: hasta el punto final"}};
constexpr Operand angle{.address = 'A',
                        .role = Role::angle,
                        .slot = at<&Cycle::infeed_angle>,
                        .text = {"infeed angle; 0 radial, negative zigzag; none: 30 degrees",
                                 "angle de pénétration ; 0 radiale, négatif en zigzag ; absent : 30 degrés",
                                 "ángulo de penetración; 0 radial, negativo en zigzag; ausente: 30 grados"}};
constexpr Operand start_angle{.address = 'W',
                              .role = Role::angle,
                              .slot = at<&Cycle::start_angle>,
                              .text = {"spindle angle of the start; with K: of the groove measured",
                                       "angle de broche du début du filet ; avec K : du sillon mesuré",
                                       "ángulo del cabezal del comienzo; con K: del surco medido"}};
constexpr Operand starts{.address = 'V',
                         .role = Role::count,
                         .range = {.least = 0, .whole = true},
                         .slot = at<&Cycle::starts>,
                         .text = {"number of starts", "nombre de filets", "número de entradas"}};
constexpr Operand lead_change{.address = 'M',
                              .role = Role::lead,
                              .slot = at<&Cycle::lead_change>,
                              .text = {"change of the pitch in a spindle turn", "variation du pas par tour de broche",
                                       "incremento del paso por vuelta del cabezal"}};
constexpr Operand entry{
    .address = 'H',
    .role = Role::choice,
    .range = {.least = 0, .most = 5, .whole = true},
    .slot = at<&Cycle::entry>,
    .text = {"infeed: 0 radial, 1 first flank, 2 radial zigzag, 3 last flank, 4 radial zigzag, 5 zigzag on both flanks",
             "pénétration : 0 radiale, 1 flanc initial, 2 zigzag radial, 3 flanc final, 4 zigzag radial, 5 zigzag sur "
             "les deux flancs",
             "penetración: 0 radial, 1 flanco inicial, 2 zigzag radial, 3 flanco final, 4 zigzag radial, 5 zigzag por "
             "los dos flancos"}};
constexpr Operand partial{
    .address = 'U',
    .role = Role::choice,
    .range = {.least = 0, .most = 1, .whole = true},
    .slot = at<&Cycle::partial>,
    .text = {"1: partial thread, in and out on a ramp", "1 : filet partiel, entrée et sortie en rampe",
             "1: roscado parcial, entrada y salida en rampa"}};

constexpr Operand longitudinal_operands[] = {start_x<Cycle>, start_z<Cycle>, end_x<Cycle>, end_z<Cycle>, repair_z,
                                             depth_x,        infeed,         least_infeed, safety,       allowance,
                                             lead,           exit_length,    angle,        start_angle,  starts,
                                             lead_change,    entry,          partial};
constexpr Operand face_operands[] = {start_x<Cycle>, start_z<Cycle>, end_x<Cycle>, end_z<Cycle>, repair_x, depth_z,
                                     infeed,         least_infeed,   safety,       allowance,    lead,     exit_length,
                                     angle,          start_angle,    starts,       lead_change,  entry,    partial};

}  // namespace

constexpr Construct g86 = cycle<Cycle>(
    86, "G86", "8055 T 9.9",
    {"longitudinal threading", "cycle fixe de filetage longitudinal", "ciclo fijo de roscado longitudinal"},
    "G86 X5.5 Z5.5 Q5.5 R5.5 [K5.5] I5.5 B5.5 [E5.5] [D5.5] [L5.5] C5.5 [J5.5] [A5.5] [W5.5] [V4] [M5.5] [H0..5] "
    "[U0..1]",
    "S400 M03\nG00 X60 Z5\nG86 X40 Z5 Q40 R-60 I1.2 B0.4 E0.05 D2 L0.05 C2", longitudinal_operands,
    cutting<Cycle, Cut::along_u>);
constexpr Construct g87 = cycle<Cycle>(
    87, "G87", "8055 T 9.10", {"face threading", "cycle fixe de filetage frontal", "ciclo fijo de roscado frontal"},
    "G87 X5.5 Z5.5 Q5.5 R5.5 [K5.5] I5.5 B5.5 [E5.5] [D5.5] [L5.5] C5.5 [J5.5] [A5.5] [W5.5] [V4] [M5.5] [H0..5] "
    "[U0..1]",
    "S400 M03\nG00 X60 Z10\nG87 X60 Z0 Q24 R0 I1 B0.4 E0.05 D2 L0.05 C-2", face_operands, cutting<Cycle, Cut::along_v>);

static_assert(well_formed(g86) && well_formed(g87));

}  // namespace fagorc::frontend::fagor8055
