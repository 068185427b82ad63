// G75 G76: probing moves (8055 T 10.1).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using program::ProbeMove;

constexpr Operand operands[] = {
    {.address = any_axis,
     .role = Role::coordinate,
     .need = Need::required,
     .slot = at<&ProbeMove::axes>,
     .text = {"end point if the probe does not answer", "point d'arrivée si le palpeur ne répond pas",
              "punto final si el palpador no responde"}}};

}  // namespace

constexpr Construct g75{.number = 75,
                        .code = "G75",
                        .support = Support::planned,
                        .takes = Takes::listed,
                        .syntax = "G75 X..C5.5",
                        .snippet = "G75 Z-10 F100",
                        .section = "8055 T 10.1",
                        .title = {"probing move until contact", "déplacement avec palpeur jusqu'au contact",
                                  "movimiento con palpador hasta tocar"},
                        .operands = operands,
                        .make = makes<ProbeMove>,
                        .target = target_of<ProbeMove>,
                        .least_axes = 1};

constexpr Construct g76{
    .number = 76,
    .code = "G76",
    .support = Support::planned,
    .takes = Takes::listed,
    .syntax = "G76 X..C5.5",
    .snippet = "G76 Z10 F50",
    .section = "8055 T 10.1",
    .title = {"probing move until contact is lost", "déplacement avec palpeur jusqu'à la perte du contact",
              "movimiento con palpador hasta dejar de tocar"},
    .operands = operands,
    .make = +[]() -> program::Function { return ProbeMove{.until_release = true, .axes = {}}; },
    .target = target_of<ProbeMove>,
    .least_axes = 1};

static_assert(well_formed(g75) && well_formed(g76));

}  // namespace fagorc::frontend::fagor8055
