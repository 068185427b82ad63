// The M functions that have a meaning of their own (8055 T 5.7).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using program::SpindleCommand;
using Turn = SpindleCommand::Turn;

template <Turn turn>
constexpr auto turning = +[]() -> program::Function { return SpindleCommand{turn}; };
template <bool conditional>
constexpr auto stopping = +[]() -> program::Function { return program::ProgramStop{conditional}; };
template <int number>
constexpr auto gear = +[]() -> program::Function { return program::SpindleGear{number}; };

/// A code without operands.
constexpr Construct m(std::uint16_t number, std::string_view code, std::string_view section, std::string_view snippet,
                      Text title, program::Function (*make)() = nullptr) {
    return {.letter = 'M',
            .number = number,
            .code = code,
            .syntax = code,
            .snippet = snippet,
            .section = section,
            .title = title,
            .make = make};
}

constexpr Operand m19_operands[] = {
    {.address = 'S',
     .role = Role::angle,
     .slot = at<&program::OrientedStop::angle>,
     .text = {"angle from the marker pulse; the sign is the sense of counting",
              "angle depuis l'impulsion de référence ; le signe donne le sens de comptage",
              "ángulo desde el impulso de referencia; el signo indica el sentido de conteo"}}};

constexpr Operand m45_operands[] = {
    {.address = 'S',
     .role = Role::speed,
     .slot = at<&program::LiveTool::speed>,
     .text = {"speed in rpm, the sign is the sense of rotation; none or 0: stop",
              "vitesse en tr/min, le signe donne le sens de rotation ; absente ou 0 : arrêt",
              "velocidad en r.p.m., el signo indica el sentido de giro; ausente o 0: parada"}}};

}  // namespace

constexpr Construct m00 =
    m(0, "M00", "8055 T 5.7.1", "M00", {"program stop", "arrêt de programme", "parada de programa"}, stopping<false>);
constexpr Construct m01 = m(
    1, "M01", "8055 T 5.7.2", "M01",
    {"conditional program stop", "arrêt conditionnel du programme", "parada condicional del programa"}, stopping<true>);
constexpr Construct m02 = m(2, "M02", "8055 T 5.7.3", "M02",
                            {"end of program", "fin de programme", "final de programa"}, makes<program::ProgramEnd>);
constexpr Construct m30 =
    m(30, "M30", "8055 T 5.7.4", "M30",
      {"end of program with return to the first block", "fin de programme avec retour au premier bloc",
       "final de programa con vuelta al primer bloque"},
      makes<program::ProgramEnd>);
constexpr Construct m03 = m(3, "M03", "8055 T 5.7.5", "S1000 M03",
                            {"spindle clockwise", "broche à droite (sens horaire)", "cabezal a derechas (horario)"},
                            turning<Turn::clockwise>);
constexpr Construct m04 =
    m(4, "M04", "8055 T 5.7.5", "S1000 M04",
      {"spindle counter-clockwise", "broche à gauche (sens antihoraire)", "cabezal a izquierdas (antihorario)"},
      turning<Turn::counter_clockwise>);
constexpr Construct m05 =
    m(5, "M05", "8055 T 5.7.5", "M05", {"spindle stop", "arrêt de broche", "parada de cabezal"}, turning<Turn::stop>);
constexpr Construct m06 = m(6, "M06", "8055 T 5.7.6", "T2 M06",
                            {"tool change", "changement d'outil", "cambio de herramienta"}, makes<program::ToolChange>);
constexpr Construct m08 =
    m(8, "M08", "8055 T 5.7", "M08",
      {"coolant on (by the PLC)", "arrosage en marche (par l'automate)", "refrigerante conectado (por el PLC)"});
constexpr Construct m09 =
    m(9, "M09", "8055 T 5.7", "M09",
      {"coolant off (by the PLC)", "arrosage arrêté (par l'automate)", "refrigerante desconectado (por el PLC)"});

constexpr Construct m19{
    .letter = 'M',
    .number = 19,
    .code = "M19",
    .takes = Takes::next,
    .syntax = "M19 [S5.5]",
    .snippet = "M19 S100",
    .section = "8055 T 5.7.7",
    .title = {"oriented spindle stop", "arrêt orienté de la broche", "parada orientada del cabezal"},
    .operands = m19_operands,
    .make = makes<program::OrientedStop>,
    .target = target_of<program::OrientedStop>};

constexpr Construct m41 =
    m(41, "M41", "8055 T 5.7.8", "M41", {"spindle gear 1", "gamme de broche 1", "gama del cabezal 1"}, gear<1>);
constexpr Construct m42 =
    m(42, "M42", "8055 T 5.7.8", "M42", {"spindle gear 2", "gamme de broche 2", "gama del cabezal 2"}, gear<2>);
constexpr Construct m43 =
    m(43, "M43", "8055 T 5.7.8", "M43", {"spindle gear 3", "gamme de broche 3", "gama del cabezal 3"}, gear<3>);
constexpr Construct m44 =
    m(44, "M44", "8055 T 5.7.8", "M44", {"spindle gear 4", "gamme de broche 4", "gama del cabezal 4"}, gear<4>);

constexpr Construct m45{.letter = 'M',
                        .number = 45,
                        .code = "M45",
                        .takes = Takes::next,
                        .syntax = "M45 [S5.5]",
                        .snippet = "M45 S500",
                        .section = "8055 T 5.7.9",
                        .title = {"live tool", "outil motorisé", "herramienta motorizada"},
                        .operands = m45_operands,
                        .make = makes<program::LiveTool>,
                        .target = target_of<program::LiveTool>};

static_assert(well_formed(m00) && well_formed(m01) && well_formed(m02) && well_formed(m30) && well_formed(m03) &&
              well_formed(m04) && well_formed(m05) && well_formed(m06) && well_formed(m08) && well_formed(m09) &&
              well_formed(m19) && well_formed(m41) && well_formed(m42) && well_formed(m43) && well_formed(m44) &&
              well_formed(m45));

}  // namespace fagorc::frontend::fagor8055
