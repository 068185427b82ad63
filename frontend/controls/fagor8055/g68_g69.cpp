// G68 G69: stock removal along X and along Z (8055 T 9.2, 9.3).
#include "frontend/controls/fagor8055/profile_operands.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using Cycle = operation::StockRemoval;

constexpr Operand valley_feed{.address = 'K',
                              .role = Role::feed,
                              .range = not_negative,
                              .slot = at<&Cycle::valley_feed>,
                              .text = {"penetration feed in valleys; 0 or none: the active feed",
                                       "avance de pénétration dans les vallées ; 0 ou absente : celle d'usinage",
                                       "avance de penetración en los valles; 0 o ausente: el de mecanizado"}};

constexpr Operand along_x_operands[] = {start_x<Cycle>,
                                        start_z<Cycle>,
                                        pass_depth<Cycle>,
                                        retreat<Cycle>,
                                        signed_allowance_x<Cycle>,
                                        signed_allowance_z<Cycle>,
                                        valley_feed,
                                        final_roughing_feed<Cycle>,
                                        finishing_feed<Cycle>,
                                        first_label<Cycle>,
                                        last_label<Cycle>,
                                        profile_program<Cycle>,
                                        segment<Cycle>};

constexpr Operand along_z_operands[] = {start_x<Cycle>,
                                        start_z<Cycle>,
                                        pass_depth<Cycle>,
                                        retreat<Cycle>,
                                        signed_allowance_x<Cycle>,
                                        signed_allowance_z<Cycle>,
                                        valley_feed,
                                        final_roughing_feed<Cycle>,
                                        finishing_feed<Cycle>,
                                        first_label<Cycle>,
                                        last_label<Cycle>,
                                        profile_program<Cycle>};

}  // namespace

constexpr Construct g68 = cycle<Cycle>(
    68, "G68", "8055 T 9.2",
    {"stock removal along X", "cycle fixe d'ébauchage sur l'axe X", "ciclo fijo de desbastado en el eje X"},
    "G68 X5.5 Z5.5 C5.5 [D5.5] [L5.5] [M5.5] [K5.5] [F5.5] [H5.5] S4 E4 [Q6] [J5.5]",
    "G00 X60 Z2\nG68 X20 Z0 C3 D1 L0.5 M0.25 H80 S100 E120\nM30\nN100 G01 X20 Z-20\nN110 X40 Z-40\nN120 Z-60",
    along_x_operands, cutting<Cycle, operation::Cut::along_u>);

constexpr Construct g69 = cycle<Cycle>(
    69, "G69", "8055 T 9.3",
    {"stock removal along Z", "cycle fixe d'ébauchage sur l'axe Z", "ciclo fijo de desbastado en el eje Z"},
    "G69 X5.5 Z5.5 C5.5 [D5.5] [L5.5] [M5.5] [K5.5] [F5.5] [H5.5] S4 E4 [Q6]",
    "G00 X80 Z2\nG69 X60 Z-30 C3 D1 L0.5 M0.25 H80 S100 E120\nM30\nN100 G01 X40 Z-30\nN110 X20 Z-15\nN120 Z0",
    along_z_operands, cutting<Cycle, operation::Cut::along_v>);

static_assert(well_formed(g68) && well_formed(g69));

}  // namespace fagorc::frontend::fagor8055
