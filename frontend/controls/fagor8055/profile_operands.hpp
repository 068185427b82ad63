// Operands of the cycles that work down to a profile: G66 G68 G69 (8055 T 9.1 to 9.3).
#pragma once

#include "frontend/controls/fagor8055/cycle_operands.hpp"

namespace fagorc::frontend::fagor8055 {

inline constexpr Range program_range{.least = 0, .most = 999999, .whole = true};
inline constexpr Range label_range{.least = 0, .most = 9999, .whole = true};

/// Allowances of the profile cycles: the sign selects the corner mode of the finishing pass.
template <class C>
inline constexpr Operand signed_allowance_x{
    .address = 'L',
    .role = Role::length,
    .slot = at<&C::allowance_v>,
    .text = {"finishing stock along X, radius; negative: finishing in G05",
             "surépaisseur de finition suivant X, au rayon ; négative : finition en G05",
             "demasía de acabado según X, en radios; negativa: acabado en G05"}};
template <class C>
inline constexpr Operand signed_allowance_z{
    .address = 'M',
    .role = Role::length,
    .slot = at<&C::allowance_u>,
    .text = {"finishing stock along Z; negative: finishing in G05; none: L all along the profile",
             "surépaisseur de finition suivant Z ; négative : finition en G05 ; absente : L sur tout le profil",
             "demasía de acabado según Z; negativa: acabado en G05; ausente: L en todo el perfil"}};
template <class C>
inline constexpr Operand first_label{
    .address = 'S',
    .role = Role::label,
    .need = Need::required,
    .range = label_range,
    .slot = at<&C::first_label>,
    .text = {"label of the first block of the profile", "étiquette du premier bloc du profil",
             "etiqueta del primer bloque del perfil"}};
template <class C>
inline constexpr Operand last_label{
    .address = 'E',
    .role = Role::label,
    .need = Need::required,
    .range = label_range,
    .slot = at<&C::last_label>,
    .text = {"label of the last block of the profile", "étiquette du dernier bloc du profil",
             "etiqueta del último bloque del perfil"}};
template <class C>
inline constexpr Operand profile_program{.address = 'Q',
                                         .role = Role::program,
                                         .range = program_range,
                                         .slot = at<&C::program>,
                                         .text = {"program that holds the profile; none: the same one",
                                                  "programme qui contient le profil ; absent : le même",
                                                  "programa que contiene el perfil; ausente: el mismo"}};
template <class C>
inline constexpr Operand segment{
    .address = 'J',
    .role = Role::length,
    .range = not_negative,
    .slot = at<&C::segment>,
    .text = {"length of a segment, for roughing by segments", "longueur d'un segment, pour l'ébauche par segments",
             "longitud de un segmento, para el desbaste por segmentos"}};
}  // namespace fagorc::frontend::fagor8055
