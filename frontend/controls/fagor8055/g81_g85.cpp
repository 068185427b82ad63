// G81 G82 G84 G85: turning and facing of straight and arc sections (8055 T 9.4, 9.5, 9.7, 9.8).
#include "frontend/controls/fagor8055/cycle_operands.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using Cycle = operation::Turning;
using operation::Cut;

constexpr Operand allowance_x{
    .address = 'L',
    .role = Role::length,
    .range = not_negative,
    .slot = at<&Cycle::allowance_v>,
    .text = {"finishing stock along X, radius", "surépaisseur de finition suivant X, au rayon",
             "demasía de acabado según X, en radios"}};
constexpr Operand allowance_z{
    .address = 'M',
    .role = Role::length,
    .range = not_negative,
    .slot = at<&Cycle::allowance_u>,
    .text = {"finishing stock along Z", "surépaisseur de finition suivant Z", "demasía de acabado según Z"}};

constexpr Operand straight_operands[] = {start_x<Cycle>,       start_z<Cycle>,    end_x<Cycle>,
                                         end_z<Cycle>,         pass_depth<Cycle>, retreat<Cycle>,
                                         allowance_x,          allowance_z,       final_roughing_feed<Cycle>,
                                         finishing_feed<Cycle>};

constexpr Operand arc_operands[] = {
    start_x<Cycle>,
    start_z<Cycle>,
    end_x<Cycle>,
    end_z<Cycle>,
    pass_depth<Cycle>,
    retreat<Cycle>,
    allowance_x,
    allowance_z,
    final_roughing_feed<Cycle>,
    finishing_feed<Cycle>,
    {.address = 'I',
     .role = Role::distance_v,
     .need = Need::required,
     .slot = at<&Cycle::centre_v>,
     .text = {"centre of the arc along X from the start, radius",
              "centre de l'arc suivant X depuis le point initial, au rayon",
              "centro del arco según X desde el punto inicial, en radios"}},
    {.address = 'K',
     .role = Role::distance_u,
     .need = Need::required,
     .slot = at<&Cycle::centre_u>,
     .text = {"centre of the arc along Z from the start", "centre de l'arc suivant Z depuis le point initial",
              "centro del arco según Z desde el punto inicial"}}};

constexpr std::string_view g81_syntax = "G81 X5.5 Z5.5 Q5.5 R5.5 C5.5 [D5.5] [L5.5] [M5.5] [F5.5] [H5.5]";
constexpr std::string_view g82_syntax = "G82 X5.5 Z5.5 Q5.5 R5.5 C5.5 [D5.5] [L5.5] [M5.5] [F5.5] [H5.5]";
constexpr std::string_view g84_syntax = "G84 X5.5 Z5.5 Q5.5 R5.5 C5.5 [D5.5] [L5.5] [M5.5] [F5.5] [H5.5] I5.5 K5.5";
constexpr std::string_view g85_syntax = "G85 X5.5 Z5.5 Q5.5 R5.5 C5.5 [D5.5] [L5.5] [M5.5] [F5.5] [H5.5] I5.5 K5.5";

}  // namespace

constexpr Construct g81 = cycle<Cycle>(81, "G81", "8055 T 9.4",
                                       {"turning of straight sections", "cycle fixe de tournage de segments droits",
                                        "ciclo fijo de torneado de tramos rectos"},
                                       g81_syntax, "G00 X60 Z5\nG81 X20 Z0 Q40 R-30 C3 D1 L0.5 M0.2 F150 H80",
                                       straight_operands, cutting<Cycle, Cut::along_u>);
constexpr Construct g82 = cycle<Cycle>(82, "G82", "8055 T 9.5",
                                       {"facing of straight sections", "cycle fixe de dressage de segments droits",
                                        "ciclo fijo de refrentado de tramos rectos"},
                                       g82_syntax, "G00 X60 Z5\nG82 X40 Z-10 Q10 R0 C2 D1 L0.5 M0.2 F150 H80",
                                       straight_operands, cutting<Cycle, Cut::along_v>);
constexpr Construct g84 = cycle<Cycle>(84, "G84", "8055 T 9.7",
                                       {"turning of arc sections", "cycle fixe de tournage de segments courbes",
                                        "ciclo fijo de torneado de tramos curvos"},
                                       g84_syntax, "G00 X60 Z5\nG84 X0 Z0 Q40 R-20 C3 D1 L0.5 M0.2 F150 H80 I0 K-20",
                                       arc_operands, cutting<Cycle, Cut::along_u>);
constexpr Construct g85 = cycle<Cycle>(85, "G85", "8055 T 9.8",
                                       {"facing of arc sections", "cycle fixe de dressage de segments courbes",
                                        "ciclo fijo de refrentado de tramos curvos"},
                                       g85_syntax, "G00 X60 Z5\nG85 X50 Z-20 Q20 R-5 C4 D1 L0.5 M0.2 F150 H80 I0 K15",
                                       arc_operands, cutting<Cycle, Cut::along_v>);

static_assert(well_formed(g81) && well_formed(g82) && well_formed(g84) && well_formed(g85));

}  // namespace fagorc::frontend::fagor8055
