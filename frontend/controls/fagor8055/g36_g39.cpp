// G36 to G39: rounding, tangential entry and exit, chamfer (8055 T 6.8 to 6.11).
#include "frontend/controls/fagor8055/operands.hpp"
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using program::CornerFunction;
using Kind = CornerFunction::Kind;

template <Kind kind>
constexpr auto corner = +[]() -> program::Function { return CornerFunction{.kind = kind, .radius = {}}; };

constexpr Operand radius_operands[] = {{.address = 'R',
                                        .role = Role::length,
                                        .need = Need::required,
                                        .range = positive,
                                        .slot = at<&CornerFunction::radius>,
                                        .text = {"radius", "rayon", "radio"}}};

constexpr Operand chamfer_operands[] = {{.address = 'R',
                                         .role = Role::length,
                                         .need = Need::required,
                                         .range = positive,
                                         .slot = at<&CornerFunction::radius>,
                                         .text = {"distance from the corner to each end of the chamfer",
                                                  "distance de l'arête à chaque extrémité du chanfrein",
                                                  "distancia de la arista a cada extremo del chaflán"}}};

/// All but the operands: these stand right after the code, before a second R of the arc (8055 T 6.10).
constexpr Construct row(std::uint16_t number, std::string_view code, std::string_view syntax, std::string_view snippet,
                        std::string_view section, Text title, std::span<const Operand> operands,
                        program::Function (*make)()) {
    return {.number = number,
            .code = code,
            .support = Support::planned,
            .takes = Takes::next,
            .syntax = syntax,
            .snippet = snippet,
            .section = section,
            .title = title,
            .operands = operands,
            .make = make,
            .target = target_of<CornerFunction>,
            .misuse = diag::Id::corner_radius_missing,
            .out_of_range = diag::Id::corner_radius_out_of_range};
}

}  // namespace

constexpr Construct g36 =
    row(36, "G36", "G36 R5.5", "G01 X20 Z60 F100\nG36 R10 X80\nZ10", "8055 T 6.10",
        {"controlled corner rounding", "arrondissement commandé d'arêtes", "redondeo controlado de aristas"},
        radius_operands, corner<Kind::rounding>);
constexpr Construct g37 = row(
    37, "G37", "G37 R5.5", "G00 X40 Z60\nG01 G37 R5 X40 Z30 F100\nG03 X80 Z10 R20", "8055 T 6.8",
    {"tangential entry", "entrée tangentielle au début de l'usinage", "entrada tangencial al comienzo del mecanizado"},
    radius_operands, corner<Kind::entry>);
constexpr Construct g38 =
    row(38, "G38", "G38 R5.5", "G00 X20 Z50\nG02 G38 R5 X60 Z30 R20 F100\nG01 Z10", "8055 T 6.9",
        {"tangential exit", "sortie tangentielle à la fin de l'usinage", "salida tangencial al final del mecanizado"},
        radius_operands, corner<Kind::exit>);
constexpr Construct g39 = row(39, "G39", "G39 R5.5", "G01 X20 Z80 F100\nG39 R10 X80 Z60\nX100 Z10", "8055 T 6.11",
                              {"chamfer", "chanfreinage", "achaflanado"}, chamfer_operands, corner<Kind::chamfer>);

static_assert(well_formed(g36) && well_formed(g37) && well_formed(g38) && well_formed(g39));

}  // namespace fagorc::frontend::fagor8055
