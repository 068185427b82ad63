// Operands of drilling in pecks, on the axis of the part (G83) and with a driven tool (G60 G61).
#pragma once

#include "frontend/controls/fagor8055/cycle_operands.hpp"

namespace fagorc::frontend::fagor8055 {

template <class C>
inline constexpr Operand peck{.address = 'B',
                              .role = Role::length,
                              .need = Need::required,
                              .range = not_negative,
                              .slot = at<&C::peck>,
                              .text = {"depth of a peck; 0: tapping", "profondeur d'une pénétration ; 0 : taraudage",
                                       "profundidad de cada penetración; 0: roscado"}};
template <class C>
inline constexpr Operand approach{
    .address = 'D',
    .role = Role::length,
    .range = not_negative,
    .slot = at<&C::approach>,
    .text = {"distance from the approach point to the surface", "distance du point d'approche à la surface",
             "distancia del punto de aproximación a la superficie"}};
template <class C>
inline constexpr Operand lift{.address = 'H',
                              .role = Role::length,
                              .range = not_negative,
                              .slot = at<&C::lift>,
                              .text = {"retreat after a peck; 0 or none: to the approach point",
                                       "recul après une pénétration ; 0 ou absent : au point d'approche",
                                       "retroceso tras una penetración; 0 o ausente: al punto de aproximación"}};
template <class C>
inline constexpr Operand clearance{
    .address = 'C',
    .role = Role::length,
    .range = not_negative,
    .slot = at<&C::clearance>,
    .text = {"rapid approach up to this distance from the last depth; none: 1 mm",
             "approche rapide jusqu'à cette distance de la dernière profondeur ; absente : 1 mm",
             "aproximación rápida hasta esta distancia de la última profundidad; ausente: 1 mm"}};
template <class C>
inline constexpr Operand least_peck{.address = 'L',
                                    .role = Role::length,
                                    .range = not_negative,
                                    .slot = at<&C::least_peck>,
                                    .text = {"smallest peck", "pénétration minimale", "penetración mínima"}};
template <class C>
inline constexpr Operand peck_factor{
    .address = 'R',
    .role = Role::factor,
    .range = not_negative,
    .slot = at<&C::factor>,
    .text = {"drilling: factor from peck to peck; tapping: 0 floating holder, 1 rigid oriented, 2 rigid",
             "perçage : facteur d'une pénétration à l'autre ; taraudage : 0 porte-taraud flottant, 1 rigide orienté, 2 "
             "rigide",
             "taladrado: factor entre penetraciones; roscado: 0 portamachos flotante, 1 rígido orientado, 2 rígido"}};

}  // namespace fagorc::frontend::fagor8055
