// Statements that run and write other programs (8055 T 12.8).
#include "frontend/controls/fagor8055/statements.hpp"

#include "frontend/controls/fagor8055/operands.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using control::StatementRow;

constexpr Operand program_operands[] = {
    {.address = '1',
     .role = Role::program,
     .need = Need::required,
     .range = {.least = 1, .most = 999999, .whole = true},
     .text = {"number of the program", "numéro du programme", "número del programa"}}};

constexpr StatementRow table[] = {
    {.word = "EXEC",
     .syntax = "(EXEC P(expression) [, HD | DNC2 | DNCE])",
     .snippet = "(EXEC P200)",
     .section = "8055 T 12.8",
     .title = {"execution of another program", "exécution d'un autre programme", "ejecución de otro programa"},
     .operands = program_operands},
    {.word = "MEXEC",
     .syntax = "(MEXEC P(expression) [, HD | DNC2 | DNCE])",
     .snippet = "(MEXEC P200)",
     .section = "8055 T 12.8",
     .title = {"modal execution of another program", "exécution modale d'un autre programme",
               "ejecución modal de otro programa"},
     .operands = program_operands},
    {.word = "OPEN",
     .syntax = "(OPEN P(expression) [, HD | DNC2 | DNCE] [, A | D] [, \"comment\"])",
     .snippet = "(OPEN P12345, A, \"PROFILE\")",
     .section = "8055 T 12.8",
     .title = {"opening of a program to be written", "ouverture d'un programme pour édition",
               "apertura de un programa para edición"},
     .operands = program_operands},
    {.word = "WRITE",
     .syntax = "(WRITE block text)",
     .snippet = "(WRITE G1 XP100 ZP101 F100)",
     .section = "8055 T 12.8",
     .title = {"block written to the open program", "écriture d'un bloc dans le programme ouvert",
               "escritura de un bloque en el programa abierto"}}};
static_assert(well_formed(std::span<const StatementRow>(table)));

}  // namespace

std::span<const StatementRow> program_statements() {
    return table;
}

}  // namespace fagorc::frontend::fagor8055
