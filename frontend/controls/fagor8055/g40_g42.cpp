// G40 to G42: tool radius compensation (8055 T 8.2, 8.3).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using program::CompensationSearch;
using program::Side;

constexpr Operand operands[] = {
    {.address = 'N',
     .role = Role::count,
     .range = {.least = 0, .most = 50, .whole = true},
     .slot = at<&CompensationSearch::blocks>,
     .text = {"blocks searched for collisions, 3 to 50; less: no search",
              "blocs analysés pour la détection de collisions, 3 à 50 ; moins : sans détection",
              "bloques analizados para la detección de colisiones, 3 a 50; menos: sin detección"}}};

}  // namespace

constexpr Construct g40{.number = 40,
                        .code = "G40",
                        .group = Group::compensation,
                        .setting = setting(Side::off),
                        .syntax = "G40",
                        .snippet = "G40 X110 Z100",
                        .section = "8055 T 8.2.6",
                        .title = {"tool radius compensation off", "annulation de la compensation de rayon d'outil",
                                  "anulación de la compensación de radio de herramienta"}};

constexpr Construct g41{.number = 41,
                        .code = "G41",
                        .group = Group::compensation,
                        .setting = setting(Side::left),
                        .support = Support::planned,
                        .takes = Takes::next,
                        .syntax = "G41 [N3..50]",
                        .snippet = "T1 D1\nG01 G41 X70 Z20 F100\nZ40\nG40 X110 Z100",
                        .section = "8055 T 8.2.4",
                        .title = {"tool radius compensation, left", "compensation de rayon d'outil à gauche",
                                  "compensación de radio de herramienta a la izquierda"},
                        .operands = operands,
                        .make = makes<CompensationSearch>,
                        .target = target_of<CompensationSearch>};

constexpr Construct g42{.number = 42,
                        .code = "G42",
                        .group = Group::compensation,
                        .setting = setting(Side::right),
                        .support = Support::planned,
                        .takes = Takes::next,
                        .syntax = "G42 [N3..50]",
                        .snippet = "T1 D1\nG01 G42 X10 Z60 F100\nX70 Z40\nG40 X110 Z100",
                        .section = "8055 T 8.2.4",
                        .title = {"tool radius compensation, right", "compensation de rayon d'outil à droite",
                                  "compensación de radio de herramienta a la derecha"},
                        .operands = operands,
                        .make = makes<CompensationSearch>,
                        .target = target_of<CompensationSearch>};

static_assert(well_formed(g40) && well_formed(g41) && well_formed(g42));

}  // namespace fagorc::frontend::fagor8055
