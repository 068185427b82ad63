// G60 G61: drilling and tapping with a driven tool (8055 T 9.13, 9.14).
#include "frontend/controls/fagor8055/drilling_operands.hpp"
#include "frontend/controls/fagor8055/driven_tool_operands.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using Cycle = operation::LiveDrilling;
using operation::Cut;

constexpr Operand depth_z{.address = 'I',
                          .role = Role::distance_u,
                          .need = Need::required,
                          .range = not_zero,
                          .slot = at<&Cycle::depth>,
                          .text = {"depth from Z, positive towards -Z", "profondeur depuis Z, positive vers -Z",
                                   "profundidad desde Z, positiva hacia -Z"}};
constexpr Operand depth_x{
    .address = 'I',
    .role = Role::distance_v,
    .need = Need::required,
    .range = not_zero,
    .slot = at<&Cycle::depth>,
    .text = {"depth from X as a radius, positive towards -X", "profondeur depuis X au rayon, positive vers -X",
             "profundidad desde X en radios, positiva hacia -X"}};

constexpr Operand face_operands[] = {
    start_x<Cycle>,    start_z<Cycle>,         depth_z,           peck<Cycle>,       first_angle<Cycle>,
    angle_step<Cycle>, operation_count<Cycle>, approach<Cycle>,   dwell<Cycle>,      lift<Cycle>,
    clearance<Cycle>,  tool_speed<Cycle>,      least_peck<Cycle>, peck_factor<Cycle>};
constexpr Operand side_operands[] = {
    start_x<Cycle>,    start_z<Cycle>,         depth_x,           peck<Cycle>,       first_angle<Cycle>,
    angle_step<Cycle>, operation_count<Cycle>, approach<Cycle>,   dwell<Cycle>,      lift<Cycle>,
    clearance<Cycle>,  tool_speed<Cycle>,      least_peck<Cycle>, peck_factor<Cycle>};

}  // namespace

constexpr Construct g60 =
    cycle<Cycle>(60, "G60", "8055 T 9.13",
                 {"drilling, tapping on the face", "perçage, taraudage sur la face de dressage",
                  "taladrado, roscado en la cara de refrentado"},
                 "G60 X5.5 Z5.5 I5.5 B5.5 Q5.5 A5.5 J4 [D5.5] [K5] [H5.5] [C5.5] S5.5 [L5.5] [R5.5]",
                 "G00 X60 Z10\nG60 X50 Z0 I18 B8 Q45 A90 J4 D2 K20 S1500", face_operands, cutting<Cycle, Cut::along_u>);
constexpr Construct g61 =
    cycle<Cycle>(61, "G61", "8055 T 9.14",
                 {"drilling, tapping on the turned surface", "perçage, taraudage sur la face de chariotage",
                  "taladrado, roscado en la cara de cilindrado"},
                 "G61 X5.5 Z5.5 I5.5 B5.5 Q5.5 A5.5 J4 [D5.5] [K5] [H5.5] [C5.5] S5.5 [L5.5] [R5.5]",
                 "G00 X60 Z-10\nG61 X40 Z-10 I12 B5 Q0 A120 J3 D2 S2000", side_operands, cutting<Cycle, Cut::along_v>);

static_assert(well_formed(g60) && well_formed(g61));

}  // namespace fagorc::frontend::fagor8055
