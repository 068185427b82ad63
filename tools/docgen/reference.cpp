#include "tools/docgen/reference.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <set>

#include "ir/control/describe.hpp"

namespace fagorc::docgen {

namespace {

using control::Construct;
using control::describe;
using control::Dialect;
using control::StatementRow;
using control::Support;

/// `|` would end a cell of a table.
std::string cell(std::string_view text) {
    std::string out;
    for (char c : text) {
        if (c == '|') out += '\\';
        out += c;
    }
    return out;
}

std::string code_cell(std::string_view text) {
    return "`" + cell(text) + "`";
}

const Text colon{": ", " : ", ": "};
const Text meaning{"meaning", "signification", "significado"};
const Text syntax{"syntax", "syntaxe", "sintaxis"};
const Text example{"example", "exemple", "ejemplo"};
const Text section{"manual", "manuel", "manual"};

/// Writes one document; the members append to `out`.
struct Writer {
    const Dialect& dialect;
    Language language;
    std::string out{};

    template <class... A>
    void write(fmt::format_string<A...> format, A&&... arguments) {
        fmt::format_to(std::back_inserter(out), format, std::forward<A>(arguments)...);
    }
    std::string_view in(const Text& text) const { return text.in(language); }
    void heading(const Text& text) { write("\n## {}\n", in(text)); }
    void table(std::initializer_list<Text> titles) {
        write("\n|");
        for (const Text& t : titles) write(" {} |", in(t));
        write("\n|");
        for (std::size_t i = 0; i < titles.size(); ++i) write("---|");
        write("\n");
    }
    std::string_view planned(Support support) const {
        const Text text{"planned", "prévu", "previsto"};
        return support == Support::planned ? in(text) : std::string_view();
    }

    void introduction();
    void construct(const Construct& c);
    void operands(std::span<const control::Operand> list);
    void constructs(char letter, const Text& title);
    void statement(const StatementRow& row);
    void rows(std::span<const StatementRow> rows, const Text& title);
    void variables();
    void parameters();
    void sister_codes();
};

void Writer::introduction() {
    write("# {}\n\n", in(dialect.title));
    write("{}\n",
          in({"Made by `tools/docgen` from the tables of the control. What is marked *planned* is known and refused "
              "by name: nothing executes it yet.",
              "Produit par `tools/docgen` à partir des tables de la commande. Ce qui est marqué *prévu* est connu et "
              "refusé par son nom : rien ne l'exécute encore.",
              "Generado por `tools/docgen` a partir de las tablas del control. Lo marcado como *previsto* se conoce y "
              "se rechaza por su nombre: todavía no se ejecuta."}));
}

void Writer::operands(std::span<const control::Operand> list) {
    if (list.empty()) return;
    table({{"letter", "lettre", "letra"},
           meaning,
           {"value", "valeur", "valor"},
           {"range", "limites", "límites"},
           {"need", "emploi", "uso"}});
    for (const control::Operand& o : list) {
        const std::string letter = o.address == control::any_axis ? "X..C" : std::string(1, o.address);
        write("| `{}` | {} | {} | {} | {} |\n", letter, cell(in(o.text)), in(describe(o.role)), to_string(o.range),
              in(describe(o.need)));
    }
}

void Writer::construct(const Construct& c) {
    write("\n### {}{}{}\n\n`{}`\n\n", c.code, in(colon), in(c.title), c.syntax);
    write("{}", c.section);
    if (c.modal()) write("; {}", in({"modal", "modale", "modal"}));
    if (c.group != program::Group::none)
        write(", {}{}{}", in({"group", "groupe", "grupo"}), in(colon), in(describe(c.group)));
    if (c.company != control::Company::any) write("; {}", in(describe(c.company)));
    if (c.support == Support::planned) write("; *{}*", planned(c.support));
    write("\n");
    operands(c.operands);
    write("\n```\n{}\n```\n", c.snippet);
}

void Writer::constructs(char letter, const Text& title) {
    heading(title);
    std::set<std::string_view> written;  // codes that differ in their number alone (subroutine calls) share an entry
    for (const Construct* c : dialect.constructs)
        if (c->letter == letter && written.insert(c->syntax).second) construct(*c);
}

void Writer::statement(const StatementRow& row) {
    write("\n### {}{}{}\n\n`{}`\n\n{}", row.word, in(colon), in(row.title), row.syntax, row.section);
    if (row.support == Support::planned) write("; *{}*", planned(row.support));
    write("\n");
    operands(row.operands);
    write("\n```\n{}\n```\n", row.snippet);
}

void Writer::rows(std::span<const StatementRow> list, const Text& title) {
    heading(title);
    table({{"word", "mot", "palabra"}, meaning, syntax, example, section});
    for (const StatementRow& row : list)
        write("| {} | {} | {} | {} | {} |\n", code_cell(row.word), cell(in(row.title)), code_cell(row.syntax),
              code_cell(row.snippet), row.section);
}

void Writer::variables() {
    heading({"Variables", "Variables", "Variables"});
    write("\n{}\n",
          in({"`(X-C)` stands for an axis letter, `n` for an index. R: read, W: written by the part program; S: block "
              "preparation stops.",
              "`(X-C)` désigne une lettre d'axe, `n` un indice. R : lecture, W : écriture par le programme pièce ; S : "
              "la préparation de blocs s'arrête.",
              "`(X-C)` representa una letra de eje, `n` un índice. R: lectura, W: escritura por el programa pieza; S: "
              "se detiene la preparación de bloques."}));
    table({{"name", "nom", "nombre"},
           {"index", "indice", "índice"},
           {"access", "accès", "acceso"},
           meaning,
           {"known from", "connu par", "se conoce por"},
           section,
           {"state", "état", "estado"}});
    for (const control::Variable& v : dialect.variables) {
        const bool indexed = v.index == control::IndexForm::required || v.index == control::IndexForm::optional;
        const std::string index = v.index == control::IndexForm::label_and_program ? "N P"
                                  : indexed ? fmt::format("{} .. {}", v.least_index, v.most_index)
                                            : std::string();
        write("| `{}{}` | {} | {}{}{} | {} | {} | {} | {} |\n", v.name, v.per_axis ? "(X-C)" : "", index,
              v.readable ? "R" : "", v.writable ? "W" : "", v.stops_preparation ? "S" : "", cell(in(v.title)),
              in(describe(v.knowledge)), v.section, planned(v.support));
    }
}

void Writer::parameters() {
    heading({"Parameters and limits", "Paramètres et limites", "Parámetros y límites"});
    write("\n");
    for (const control::ParameterRange& r : dialect.parameters)
        write("- P{} .. P{}{}{}\n", r.first, r.last, in(colon), in(describe(r.scope)));
    const control::Limits& l = dialect.limits;
    const std::pair<Text, std::int64_t> limits[] = {
        {{"levels of subroutines", "niveaux de sous-routines", "niveles de subrutinas"}, l.subroutine_levels},
        {{"levels of local parameters", "niveaux de paramètres locaux", "niveles de parámetros locales"},
         l.parameter_levels},
        {{"M codes in a block", "fonctions M par bloc", "funciones M por bloque"}, l.misc_per_block},
        {{"assignments in a block", "affectations par bloc", "asignaciones por bloque"}, l.assignments_per_block},
        {{"highest label", "étiquette maximale", "etiqueta máxima"}, l.label},
        {{"repetitions of a block", "répétitions d'un bloc", "repeticiones de un bloque"}, l.repetitions},
        {{"highest subroutine", "sous-routine maximale", "subrutina máxima"}, l.subroutine},
        {{"characters of a message", "caractères d'un message", "caracteres de un mensaje"},
         static_cast<std::int64_t>(l.text_length)}};
    for (const auto& [text, value] : limits) write("- {}{}{}\n", in(text), in(colon), value);
}

void Writer::sister_codes() {
    if (dialect.sister_codes.empty()) return;
    write("\n## {} {}\n\n", in({"Codes and words of the", "Fonctions et mots du", "Funciones y palabras del"}),
          dialect.sister_model);
    write("{}\n\n", in({"Unknown to this model and refused by name.", "Inconnus de ce modèle et refusés par leur nom.",
                        "Desconocidos en este modelo; se rechazan por su nombre."}));
    for (const control::SisterCode& c : dialect.sister_codes)
        write("- {}{:02}{}{}\n", c.letter, c.number, in(colon), in(c.title));
    for (const control::SisterWord& w : dialect.sister_words) write("- {}{}{}\n", w.word, in(colon), in(w.title));
}

}  // namespace

std::string reference(const Dialect& dialect, Language language) {
    Writer w{dialect, language};
    w.introduction();
    w.constructs('G', {"G codes", "Fonctions G", "Funciones G"});
    w.constructs('M', {"M codes", "Fonctions M", "Funciones M"});
    w.rows(dialect.addresses, {"Addresses", "Adresses", "Direcciones"});
    w.heading({"Statements", "Instructions", "Sentencias"});
    for (const StatementRow& row : dialect.statements) w.statement(row);
    w.rows(dialect.operators, {"Operators and functions", "Opérateurs et fonctions", "Operadores y funciones"});
    w.variables();
    w.parameters();
    w.sister_codes();
    return w.out;
}

}  // namespace fagorc::docgen
