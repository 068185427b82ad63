// The 8055 T as one value: its tables, its limits and the state in which it starts.
#include "frontend/controls/fagor8055/fagor8055.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using Scope = control::ParameterRange::Scope;

/// 8055 T 11.2.1. The numbers between the ranges name no parameter.
constexpr control::ParameterRange parameters[] = {
    {0, 25, Scope::local}, {100, 299, Scope::global}, {1000, 1255, Scope::user}, {2000, 2255, Scope::oem}};

}  // namespace

const control::Dialect& dialect() {
    static const control::Dialect fagor_8055{
        .name = "8055",
        .model = "8055 T",
        .sister_model = "8055 M",
        .title = {"Fagor CNC 8055, model T", "CNC Fagor 8055, modèle T", "CNC Fagor 8055, modelo T"},
        .word_order = "GXYZUVWABCFSTDM",  // 8055 T 5
        .constructs = constructs(),
        .sister_codes = mill_codes(),
        .sister_words = mill_words(),
        .statements = statements(),
        .operators = operators(),
        .addresses = addresses(),
        .variables = variables(),
        .words = words(),
        .parameters = parameters,
        .limits = {},     // the defaults are those of this control
        .power_on = {}};  // G00 G18 G71 G90 G94 G97 G151 G05 G40: the machine file may say otherwise (8055 T 5.1)
    return fagor_8055;
}

}  // namespace fagorc::frontend::fagor8055
