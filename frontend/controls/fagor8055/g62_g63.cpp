// G62 G63: keyways with a driven tool (8055 T 9.15, 9.16).
#include "frontend/controls/fagor8055/driven_tool_operands.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using Cycle = operation::Keyway;
using operation::Cut;

constexpr Operand length_z{.address = 'L',
                           .role = Role::distance_u,
                           .need = Need::required,
                           .range = not_zero,
                           .slot = at<&Cycle::length>,
                           .text = {"length along Z, positive towards -Z", "longueur suivant Z, positive vers -Z",
                                    "longitud según Z, positiva hacia -Z"}};
constexpr Operand length_x{
    .address = 'L',
    .role = Role::distance_v,
    .need = Need::required,
    .range = not_zero,
    .slot = at<&Cycle::length>,
    .text = {"length along X as a radius, positive towards the axis",
             "longueur suivant X au rayon, positive vers l'axe", "longitud según X en radios, positiva hacia el eje"}};
constexpr Operand depth_x{
    .address = 'I',
    .role = Role::distance_v,
    .need = Need::required,
    .range = not_zero,
    .slot = at<&Cycle::depth>,
    .text = {"depth along X as a radius", "profondeur suivant X au rayon", "profundidad según X en radios"}};
constexpr Operand depth_z{.address = 'I',
                          .role = Role::distance_u,
                          .need = Need::required,
                          .range = not_zero,
                          .slot = at<&Cycle::depth>,
                          .text = {"depth along Z", "profondeur suivant Z", "profundidad según Z"}};
constexpr Operand safety{.address = 'D',
                         .role = Role::length,
                         .slot = at<&Cycle::approach>,
                         .text = {"safety distance from the surface", "distance de sécurité à la surface",
                                  "distancia de seguridad a la superficie"}};
constexpr Operand key_feed{
    .address = 'F',
    .role = Role::feed,
    .range = not_negative,
    .slot = at<&Cycle::feed>,
    .text = {"feed along the keyway; none: the active feed", "avance le long de la clavette ; absente : celle active",
             "avance a lo largo del chavetero; ausente: el activo"}};

constexpr Operand side_operands[] = {start_x<Cycle>,    start_z<Cycle>,         length_z, depth_x,  first_angle<Cycle>,
                                     angle_step<Cycle>, operation_count<Cycle>, safety,   key_feed, tool_speed<Cycle>};
constexpr Operand face_operands[] = {start_x<Cycle>,    start_z<Cycle>,         length_x, depth_z,  first_angle<Cycle>,
                                     angle_step<Cycle>, operation_count<Cycle>, safety,   key_feed, tool_speed<Cycle>};

}  // namespace

constexpr Construct g62 = cycle<Cycle>(
    62, "G62", "8055 T 9.15",
    {"keyway on the turned surface", "cycle fixe de clavette sur la face de tournage",
     "ciclo fijo de chavetero en la cara de cilindrado"},
    "G62 X5.5 Z5.5 L5.5 I5.5 Q5.5 A5.5 J4 [D5.5] [F5.5] S5.5",
    "G00 X60 Z-5\nG62 X40 Z-5 L30 I4 Q0 A180 J2 D2 F80 S1800", side_operands, cutting<Cycle, Cut::along_u>);
constexpr Construct g63 =
    cycle<Cycle>(63, "G63", "8055 T 9.16",
                 {"keyway on the face", "cycle fixe de clavette sur la face de dressage",
                  "ciclo fijo de chavetero en la cara de refrentado"},
                 "G63 X5.5 Z5.5 L5.5 I5.5 Q5.5 A5.5 J4 [D5.5] [F5.5] S5.5",
                 "G00 X60 Z10\nG63 X50 Z0 L10 I4 Q0 A180 J2 D2 F80 S1800", face_operands, cutting<Cycle, Cut::along_v>);

static_assert(well_formed(g62) && well_formed(g63));

}  // namespace fagorc::frontend::fagor8055
