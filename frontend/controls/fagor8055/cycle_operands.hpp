// Operands that the canned cycles of the 8055 T share (8055 T chapter 9). `C` is the neutral cycle that they fill.
// X-type operands act on the ordinate, Z-type ones on the abscissa of the active plane; coordinates are always
// absolute.
#pragma once

#include "frontend/controls/fagor8055/operands.hpp"
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

inline constexpr Range not_zero{.not_zero = true};
inline constexpr Range count_range{.least = 1, .most = 9999, .whole = true};
inline constexpr Range hundredths_range{.least = 0, .most = 99999, .whole = true};

template <class C>
inline constexpr Operand start_x{
    .address = 'X',
    .role = Role::ordinate,
    .need = Need::required,
    .slot = at<&C::start_v>,
    .text = {"X of the start point", "cote X du point initial", "cota X del punto inicial"}};
template <class C>
inline constexpr Operand start_z{
    .address = 'Z',
    .role = Role::abscissa,
    .need = Need::required,
    .slot = at<&C::start_u>,
    .text = {"Z of the start point", "cote Z du point initial", "cota Z del punto inicial"}};
template <class C>
inline constexpr Operand end_x{.address = 'Q',
                               .role = Role::ordinate,
                               .need = Need::required,
                               .slot = at<&C::end_v>,
                               .text = {"X of the end point", "cote X du point final", "cota X del punto final"}};
template <class C>
inline constexpr Operand end_z{.address = 'R',
                               .role = Role::abscissa,
                               .need = Need::required,
                               .slot = at<&C::end_u>,
                               .text = {"Z of the end point", "cote Z du point final", "cota Z del punto final"}};
template <class C>
inline constexpr Operand pass_depth{
    .address = 'C',
    .role = Role::length,
    .need = Need::required,
    .range = positive,
    .slot = at<&C::step>,
    .text = {"depth of a pass, along X as a radius", "profondeur de passe, au rayon suivant X",
             "profundidad de pasada, en radios según X"}};
template <class C>
inline constexpr Operand retreat{
    .address = 'D',
    .role = Role::length,
    .range = not_negative,
    .slot = at<&C::retreat>,
    .text = {"safety distance of the retreat; 0: back on the way in; none: along the profile",
             "distance de sécurité du retrait ; 0 : par le chemin d'entrée ; absente : en suivant le profil",
             "distancia de seguridad de la retirada; 0: por el camino de entrada; ausente: siguiendo el perfil"}};
template <class C>
inline constexpr Operand final_roughing_feed{
    .address = 'F',
    .role = Role::feed,
    .range = not_negative,
    .slot = at<&C::roughing_feed>,
    .text = {"feed of the last roughing pass; 0 or none: no such pass",
             "avance de la dernière passe d'ébauche ; 0 ou absente : pas de passe",
             "avance de la última pasada de desbaste; 0 o ausente: sin pasada"}};
template <class C>
inline constexpr Operand finishing_feed{.address = 'H',
                                        .role = Role::feed,
                                        .range = not_negative,
                                        .slot = at<&C::finishing_feed>,
                                        .text = {"feed of the finishing pass; 0 or none: no finishing pass",
                                                 "avance de la passe de finition ; 0 ou absente : sans finition",
                                                 "avance de la pasada de acabado; 0 o ausente: sin acabado"}};
template <class C>
inline constexpr Operand dwell{.address = 'K',
                               .role = Role::hundredths,
                               .range = hundredths_range,
                               .slot = at<&C::dwell>,
                               .text = {"dwell at the bottom", "temporisation au fond", "temporización en el fondo"}};

/// A cycle whose cuts run along one axis of the plane.
template <class C, operation::Cut cut>
inline constexpr auto cutting = +[]() -> program::Function {
    C cycle;
    cycle.cut = cut;
    return cycle;
};

/// What all rows of canned cycles have in common: every word of the block is theirs.
template <class C>
constexpr Construct cycle(std::uint16_t number, std::string_view code, std::string_view section, Text title,
                          std::string_view syntax, std::string_view snippet, std::span<const Operand> operands,
                          program::Function (*make)() = makes<C>) {
    return {.number = number,
            .code = code,
            .support = Support::planned,
            .takes = Takes::all,
            .syntax = syntax,
            .snippet = snippet,
            .section = section,
            .title = title,
            .operands = operands,
            .make = make,
            .target = target_of<C>,
            .misuse = diag::Id::cycle_operand_missing,
            .out_of_range = diag::Id::cycle_operand_out_of_range};
}

}  // namespace fagorc::frontend::fagor8055
