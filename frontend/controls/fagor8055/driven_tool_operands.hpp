// Operands of the cycles with a driven tool: G60 to G63.
#pragma once

#include "frontend/controls/fagor8055/cycle_operands.hpp"

namespace fagorc::frontend::fagor8055 {

template <class C>
inline constexpr Operand first_angle{
    .address = 'Q',
    .role = Role::angle,
    .need = Need::required,
    .slot = at<&C::first_angle>,
    .text = {"spindle angle of the first operation", "angle de broche de la première opération",
             "ángulo del cabezal de la primera operación"}};
template <class C>
inline constexpr Operand angle_step{
    .address = 'A',
    .role = Role::angle,
    .need = Need::required,
    .slot = at<&C::angle_step>,
    .text = {"angle between operations", "angle entre opérations", "ángulo entre operaciones"}};
template <class C>
inline constexpr Operand operation_count{
    .address = 'J',
    .role = Role::count,
    .need = Need::required,
    .range = count_range,
    .slot = at<&C::count>,
    .text = {"number of operations", "nombre d'opérations", "número de operaciones"}};
template <class C>
inline constexpr Operand tool_speed{
    .address = 'S',
    .role = Role::speed,
    .need = Need::required,
    .slot = at<&C::tool_speed>,
    .text = {"speed of the driven tool in rpm, the sign is the sense",
             "vitesse de l'outil motorisé en tr/min, le signe donne le sens",
             "velocidad de la herramienta motorizada en r.p.m., el signo indica el sentido"}};

}  // namespace fagorc::frontend::fagor8055
