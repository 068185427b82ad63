// Codes and words of the 8055 M that the 8055 T has not: a mill's program is refused by name.
#include "frontend/controls/fagor8055/fagor8055.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

constexpr control::SisterCode code_rows[] = {
    {'G', 23, {"tracing", "copiage", "copiado"}},
    {'G', 24, {"digitising", "numérisation", "digitalización"}},
    {'G', 25, {"end of tracing or digitising", "fin de copiage ou de numérisation", "fin de copiado o digitalización"}},
    {'G', 26, {"tracing probe calibration", "étalonnage du palpeur de copiage", "calibrado de la sonda de copiado"}},
    {'G', 27, {"tracing contour definition", "définition du contour de copiage", "definición del contorno de copiado"}},
    {'G', 43, {"tool length compensation", "compensation de longueur d'outil", "compensación de longitud"}},
    {'G',
     44,
     {"tool length compensation off", "annulation de la compensation de longueur d'outil",
      "anulación de la compensación de longitud"}},
    {'G',
     47,
     {"motion along the tool axis", "déplacement selon l'axe de l'outil",
      "desplazamiento según el eje de la herramienta"}},
    {'G', 48, {"TCP transformation", "transformation TCP", "transformación TCP"}},
    {'G', 49, {"inclined plane", "plan incliné", "plano inclinado"}},
    {'G', 64, {"multiple machining in an arc", "usinage multiple en arc", "mecanizado múltiple formando un arco"}},
    {'G',
     65,
     {"machining programmed by a chord", "usinage programmé au moyen d'une corde d'arc",
      "mecanizado programado mediante una cuerda de arco"}},
    {'G', 67, {"pocket roughing", "ébauchage de poche", "desbaste de cajera"}},
    {'G',
     73,
     {"rotation of the coordinate system", "rotation du système de coordonnées", "giro del sistema de coordenadas"}},
    {'G',
     79,
     {"change of canned cycle parameters", "modification des paramètres du cycle fixe",
      "modificación de parámetros del ciclo fijo"}},
    {'G', 80, {"end of canned cycle", "annulation du cycle fixe", "anulación de ciclo fijo"}},
    {'G', 98, {"return to the starting plane", "retour au plan de départ", "vuelta al plano de partida"}},
    {'G', 99, {"return to the reference plane", "retour au plan de référence", "vuelta al plano de referencia"}}};

constexpr control::SisterWord word_rows[] = {
    {"DIGIT", {"digitising cycle", "cycle de numérisation", "ciclo de digitalización"}},
    {"TOL", {"length of a tool", "longueur d'un outil", "longitud de una herramienta"}},
    {"TRACE", {"tracing cycle", "cycle de copiage", "ciclo de copiado"}}};

}  // namespace

std::span<const control::SisterCode> mill_codes() {
    return code_rows;
}

std::span<const control::SisterWord> mill_words() {
    return word_rows;
}

}  // namespace fagorc::frontend::fagor8055
