#include "ir/control/describe.hpp"

namespace fagorc::control {

Text describe(Role role) {
    switch (role) {
        case Role::none:
            return {"number", "nombre", "número"};
        case Role::coordinate:
            return {"coordinate, mm or inch; degrees of a rotary axis",
                    "cote, mm ou pouces ; degrés pour un axe rotatif",
                    "cota, mm o pulgadas; grados en un eje rotativo"};
        case Role::axis_name:
            return {"axis name", "nom d'axe", "nombre de eje"};
        case Role::centre:
            return {"way to the centre, X as a radius", "distance au centre, X au rayon",
                    "distancia al centro, X en radios"};
        case Role::centre_point:
            return {"coordinate, mm or inch", "cote, mm ou pouces", "cota, mm o pulgadas"};
        case Role::abscissa:
            return {"coordinate of the abscissa axis", "cote de l'axe d'abscisses", "cota del eje de abscisas"};
        case Role::ordinate:
            return {"coordinate of the ordinate axis", "cote de l'axe d'ordonnées", "cota del eje de ordenadas"};
        case Role::machine_coordinate:
            return {"machine coordinate, X as a radius", "cote machine, X au rayon", "cota máquina, X en radios"};
        case Role::distance:
            return {"signed length, X as a radius", "longueur avec signe, X au rayon",
                    "longitud con signo, X en radios"};
        case Role::distance_u:
            return {"signed length along the abscissa axis", "longueur avec signe suivant l'axe d'abscisses",
                    "longitud con signo según el eje de abscisas"};
        case Role::distance_v:
            return {"signed length along the ordinate axis, X as a radius",
                    "longueur avec signe suivant l'axe d'ordonnées, X au rayon",
                    "longitud con signo según el eje de ordenadas, X en radios"};
        case Role::length:
            return {"length, mm or inch", "longueur, mm ou pouces", "longitud, mm o pulgadas"};
        case Role::lead:
            return {"mm or inch a turn", "mm ou pouces par tour", "mm o pulgadas por vuelta"};
        case Role::angle:
            return {"degrees", "degrés", "grados"};
        case Role::feed:
            return {"feed, in the active unit", "avance, dans l'unité active", "avance, en la unidad activa"};
        case Role::speed:
            return {"speed, in the active unit", "vitesse, dans l'unité active", "velocidad, en la unidad activa"};
        case Role::factor:
            return {"factor", "facteur", "factor"};
        case Role::percent:
            return {"percent", "pour cent", "por ciento"};
        case Role::count:
            return {"whole number", "nombre entier", "número entero"};
        case Role::row:
            return {"row of a table", "ligne d'une table", "fila de una tabla"};
        case Role::choice:
            return {"choice", "choix", "opción"};
        case Role::label:
            return {"label", "étiquette", "etiqueta"};
        case Role::program:
            return {"program number", "numéro de programme", "número de programa"};
        case Role::hundredths:
            return {"hundredths of a second", "centièmes de seconde", "centésimas de segundo"};
    }
    return {};
}

Text describe(program::Group group) {
    using program::Group;
    switch (group) {
        case Group::motion:
            return {"motion", "mouvement", "movimiento"};
        case Group::plane:
            return {"plane", "plan", "plano"};
        case Group::distance:
            return {"absolute or incremental", "absolu ou incrémental", "absoluto o incremental"};
        case Group::unit:
            return {"unit of length", "unité de longueur", "unidad de longitud"};
        case Group::diameter:
            return {"X in diameters or radii", "X au diamètre ou au rayon", "X en diámetros o radios"};
        case Group::feed:
            return {"feed mode", "mode d'avance", "modo de avance"};
        case Group::speed:
            return {"speed mode", "mode de vitesse", "modo de velocidad"};
        case Group::spindle:
            return {"selected spindle", "broche sélectionnée", "cabezal seleccionado"};
        case Group::corner:
            return {"corner", "arête", "arista"};
        case Group::compensation:
            return {"radius compensation", "compensation de rayon", "compensación de radio"};
        case Group::origin:
            return {"absolute zero offset", "décalage d'origine absolu", "decalaje de origen absoluto"};
        case Group::shift:
            return {"incremental zero offset", "décalage d'origine incrémental", "decalaje de origen incremental"};
        case Group::none:
        case Group::count_:
            return {};
    }
    return {};
}

Text describe(Company company) {
    switch (company) {
        case Company::any:
            return {};
        case Company::alone:
            return {"alone in its block", "seule dans son bloc", "sola en su bloque"};
        case Company::alone_expected:
            return {"usually alone in its block", "normalement seule dans son bloc", "normalmente sola en su bloque"};
        case Company::no_other_g:
            return {"no other G code in its block", "sans autre fonction G dans son bloc",
                    "sin otra función G en su bloque"};
        case Company::alone_without_operands:
            return {"without operands: alone in its block", "sans opérande : seule dans son bloc",
                    "sin operandos: sola en su bloque"};
    }
    return {};
}

Text describe(Need need) {
    switch (need) {
        case Need::required:
            return {"required", "obligatoire", "obligatorio"};
        case Need::optional:
            return {};
        case Need::together:
            return {"all or none", "tous ou aucun", "todos o ninguno"};
        case Need::alternative:
            return {"exactly one", "un seul", "uno solo"};
    }
    return {};
}

Text describe(Knowledge knowledge) {
    switch (knowledge) {
        case Knowledge::program:
            return {"program", "programme", "programa"};
        case Knowledge::table:
            return {"tables", "tables", "tablas"};
        case Knowledge::machine:
            return {"machine parameters", "paramètres machine", "parámetros máquina"};
        case Knowledge::overridable:
            return {"program, unless the PLC or DNC overrides it", "programme, sauf si l'automate ou la DNC l'impose",
                    "programa, salvo que lo imponga el PLC o DNC"};
        case Knowledge::live:
            return {"running machine", "machine en marche", "máquina en marcha"};
    }
    return {};
}

Text describe(ParameterRange::Scope scope) {
    using Scope = ParameterRange::Scope;
    switch (scope) {
        case Scope::local:
            return {"local", "locaux", "locales"};
        case Scope::global:
            return {"global", "globaux", "globales"};
        case Scope::user:
            return {"of the user", "de l'utilisateur", "de usuario"};
        case Scope::oem:
            return {"of the machine builder", "du constructeur", "de fabricante"};
    }
    return {};
}

}  // namespace fagorc::control
