// G66: profile following (8055 T 9.1).
#include "frontend/controls/fagor8055/profile_operands.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using Cycle = operation::ContourRepeat;

constexpr Operand operands[] = {
    start_x<Cycle>,
    start_z<Cycle>,
    {.address = 'I',
     .role = Role::length,
     .need = Need::required,
     .range = not_negative,
     .slot = at<&Cycle::stock>,
     .text = {"stock to remove, along X as a radius", "surépaisseur à éliminer, au rayon suivant X",
              "sobrante que se elimina, en radios según X"}},
    pass_depth<Cycle>,
    {.address = 'A',
     .role = Role::choice,
     .range = {.least = 0, .most = 1, .whole = true},
     .slot = at<&Cycle::main_axis>,
     .text = {"main axis, 0: Z, stock along X; 1: X, stock along Z; none: by the tool",
              "axe principal, 0 : Z, surépaisseur suivant X ; 1 : X, surépaisseur suivant Z ; absent : selon l'outil",
              "eje principal, 0: Z, sobrante según X; 1: X, sobrante según Z; ausente: según la herramienta"}},
    signed_allowance_x<Cycle>,
    signed_allowance_z<Cycle>,
    finishing_feed<Cycle>,
    first_label<Cycle>,
    last_label<Cycle>,
    profile_program<Cycle>,
    segment<Cycle>};

}  // namespace

constexpr Construct g66 = cycle<Cycle>(
    66, "G66", "8055 T 9.1",
    {"profile following cycle", "cycle fixe de poursuite de profil", "ciclo fijo de seguimiento de perfil"},
    "G66 X5.5 Z5.5 I5.5 C5.5 [A0..1] [L5.5] [M5.5] [H5.5] S4 E4 [Q6] [J5.5]",
    "G00 X80 Z10\nG66 X20 Z0 I6 C2 A0 L0.5 M0.3 H80 S100 E120\nM30\nN100 G01 X20 Z-20\nN110 X40 Z-40\nN120 Z-60",
    operands);
static_assert(well_formed(g66));

}  // namespace fagorc::frontend::fagor8055
