// Statements of customisation programs: pages, windows, keys (8055 T 12.9).
#include "frontend/controls/fagor8055/statements.hpp"

#include "frontend/controls/fagor8055/operands.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using control::StatementRow;
using control::Support;

constexpr Operand page_operands[] = {{.address = '1',
                                      .role = Role::choice,
                                      .need = Need::required,
                                      .range = {.least = 0, .whole = true},
                                      .text = {"page: 0 to 255 of the user, from 1000 of the system",
                                               "page : 0 à 255 de l'utilisateur, à partir de 1000 du système",
                                               "página: 0 a 255 del usuario, a partir de 1000 del sistema"}}};

constexpr Operand symbol_operands[] = {{.address = '1',
                                        .role = Role::choice,
                                        .need = Need::required,
                                        .range = {.least = 0, .most = 255, .whole = true},
                                        .text = {"symbol", "symbole", "símbolo"}},
                                       {.address = '2',
                                        .role = Role::count,
                                        .need = Need::required,
                                        .range = {.least = 0, .most = 639, .whole = true},
                                        .text = {"column", "colonne", "columna"}},
                                       {.address = '3',
                                        .role = Role::count,
                                        .need = Need::required,
                                        .range = {.least = 0, .most = 335, .whole = true},
                                        .text = {"row", "ligne", "fila"}}};

constexpr Operand input_operands[] = {
    {.address = '1',
     .role = Role::row,
     .need = Need::required,
     .range = {.least = 0, .most = 25, .whole = true},
     .text = {"variable that takes the value", "variable qui reçoit la donnée", "variable que recibe el dato"}},
    {.address = '2',
     .role = Role::count,
     .range = {.least = 0, .most = 6},
     .text = {"digits before and after the point; a minus allows negative values",
              "chiffres avant et après le point ; un moins admet les valeurs négatives",
              "cifras antes y después del punto; un menos admite valores negativos"}}};

constexpr Operand window_operands[] = {{.address = '1',
                                        .role = Role::row,
                                        .need = Need::required,
                                        .range = {.least = 0, .most = 25, .whole = true},
                                        .text = {"window", "fenêtre", "ventana"}},
                                       {.address = '2',
                                        .role = Role::count,
                                        .need = Need::required,
                                        .range = {.least = 0, .most = 20, .whole = true},
                                        .text = {"row", "ligne", "fila"}},
                                       {.address = '3',
                                        .role = Role::count,
                                        .need = Need::required,
                                        .range = {.least = 0, .most = 79, .whole = true},
                                        .text = {"column", "colonne", "columna"}}};

constexpr Operand value_operands[] = {{.address = '1',
                                       .role = Role::row,
                                       .need = Need::required,
                                       .range = {.least = 0, .most = 25, .whole = true},
                                       .text = {"window", "fenêtre", "ventana"}},
                                      {.address = '2',
                                       .role = Role::none,
                                       .need = Need::required,
                                       .text = {"value to show", "valeur à afficher", "valor que se muestra"}}};

constexpr Operand softkey_operands[] = {
    {.address = '1',
     .role = Role::row,
     .need = Need::required,
     .range = {.least = 1, .most = 7, .whole = true},
     .text = {"softkey; its text has up to 20 characters", "touche logicielle ; texte de 20 caractères au plus",
              "tecla de función; texto de 20 caracteres como máximo"}}};

constexpr Operand buffer_operands[] = {
    {.address = '1',
     .role = Role::none,
     .text = {"value written after the text", "valeur écrite après le texte", "valor que se escribe tras el texto"}}};

constexpr StatementRow table[] = {
    {.word = "PAGE",
     .support = Support::planned,
     .syntax = "(PAGE expression)",
     .snippet = "(PAGE 10)",
     .section = "8055 T 12.9",
     .title = {"page of the screen", "page d'écran", "página de pantalla"},
     .operands = page_operands},
    {.word = "SYMBOL",
     .support = Support::planned,
     .syntax = "(SYMBOL symbol, column, row)",
     .snippet = "(SYMBOL 3, 100, 200)",
     .section = "8055 T 12.9",
     .title = {"symbol on the screen", "symbole à l'écran", "símbolo en pantalla"},
     .operands = symbol_operands},
    {.word = "IB",
     .support = Support::planned,
     .syntax = "(IBn = INPUT \"text\" [, [-]integer.decimals])",
     .snippet = "(IB1=INPUT \"LENGTH: \", 5.4)",
     .section = "8055 T 12.9",
     .title = {"input of a value by the operator", "saisie d'une donnée par l'opérateur",
               "entrada de un dato por el operario"},
     .operands = input_operands},
    {.word = "INPUT",
     .support = Support::planned,
     .syntax = "(IBn = INPUT \"text\" [, [-]integer.decimals])",
     .snippet = "(IB1=INPUT \"LENGTH: \", 5.4)",
     .section = "8055 T 12.9",
     .title = {"prompt of an input", "texte de la demande de donnée", "texto de la petición de dato"},
     .operands = input_operands},
    {.word = "ODW",
     .support = Support::planned,
     .syntax = "(ODW window, row, column)",
     .snippet = "(ODW 1, 5, 40)",
     .section = "8055 T 12.9",
     .title = {"definition of a window", "définition d'une fenêtre", "definición de una ventana"},
     .operands = window_operands},
    {.word = "DW",
     .support = Support::planned,
     .syntax = "(DWn = expression, ...)",
     .snippet = "(DW1=P100)",
     .section = "8055 T 12.9",
     .title = {"decimal value in a window", "valeur décimale dans une fenêtre", "valor decimal en una ventana"},
     .operands = value_operands},
    {.word = "DWH",
     .support = Support::planned,
     .syntax = "(DWHn = expression, ...)",
     .snippet = "(DWH2=P100)",
     .section = "8055 T 12.9",
     .title = {"hexadecimal value in a window", "valeur hexadécimale dans une fenêtre",
               "valor hexadecimal en una ventana"},
     .operands = value_operands},
    {.word = "DWB",
     .support = Support::planned,
     .syntax = "(DWBn = expression, ...)",
     .snippet = "(DWB3=P100)",
     .section = "8055 T 12.9",
     .title = {"binary value in a window", "valeur binaire dans une fenêtre", "valor binario en una ventana"},
     .operands = value_operands},
    {.word = "SK",
     .support = Support::planned,
     .syntax = "(SKn = \"text\", ...)",
     .snippet = "(SK1=\"START\", SK2=\"END\")",
     .section = "8055 T 12.9",
     .title = {"text of softkeys", "texte des touches logicielles", "texto de las teclas de función"},
     .operands = softkey_operands},
    {.word = "WKEY",
     .support = Support::planned,
     .syntax = "(WKEY)",
     .snippet = "(WKEY)",
     .section = "8055 T 12.9",
     .title = {"wait for a key", "attente d'une touche", "espera de una tecla"}},
    {.word = "WBUF",
     .support = Support::planned,
     .syntax = "(WBUF [\"text\" [, expression]])",
     .snippet = "(WBUF \"G1 X\", P100)",
     .section = "8055 T 12.9",
     .title = {"text into the block being edited", "texte dans le bloc en édition", "texto en el bloque en edición"},
     .operands = buffer_operands},
    {.word = "SYSTEM",
     .support = Support::planned,
     .syntax = "(SYSTEM)",
     .snippet = "(SYSTEM)",
     .section = "8055 T 12.9",
     .title = {"end of a customisation program", "fin du programme utilisateur", "fin del programa de usuario"}}};
static_assert(well_formed(std::span<const StatementRow>(table)));

}  // namespace

std::span<const StatementRow> screen_statements() {
    return table;
}

}  // namespace fagorc::frontend::fagor8055
