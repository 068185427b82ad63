// The control's own text tables, as it sends them to a PC: one row a line, a letter and a number in each column.
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <vector>

#include "frontend/machine/machine.hpp"

namespace fagorc::frontend {
namespace {

using diag::Id;
using machine::Machine;

/// One column of a line: "Z-   0.01250", "T0001", "T    " (empty), or the bare number of GUP (letter 0).
struct Field {
    char letter = 0;
    std::optional<double> value;
    std::uint32_t column = 0, end = 0;  ///< bytes from 0
};

/// One line as the readers of the tables see it; they report about its fields.
struct Row {
    std::string_view table;
    std::vector<Field> fields;
    diag::Place place;
    diag::Sink* diagnostics = nullptr;
    bool good = true;

    const Field* find(char letter, std::size_t from = 0) const {
        for (std::size_t i = from; i < fields.size(); ++i)
            if (fields[i].letter == letter) return &fields[i];
        return nullptr;
    }
    double value(char letter, double otherwise = 0) const {
        const Field* f = find(letter, 1);
        return f && f->value ? *f->value : otherwise;
    }
    void wrong(std::uint32_t column, std::uint32_t end, const Text& why) {
        diag::Place p = place;
        p.column = column + 1;
        p.end_column = std::max(end, column + 1) + 1;
        diagnostics->report(Id::table_line_malformed, p, std::string(table), why);
        good = false;
    }
    /// The row's own number, the value of its first field, when that is `letter` with a whole number in range.
    std::optional<std::uint16_t> number(char letter, double least, double most);
    /// The whole number of a column; `otherwise` where the column is absent or empty.
    double whole(char letter, double most, double otherwise = 0);
};

constexpr Text no_number{"a number is expected", "un nombre est attendu", "se espera un número"};
constexpr Text no_row_number{"the row has no number of its own", "la ligne n'a pas son numéro",
                             "la fila no tiene su número"};
constexpr Text out_of_range{"the number is out of range", "le nombre est hors limites",
                            "el número está fuera de límites"};
constexpr Text not_a_column{"a letter with its value is expected", "une lettre avec sa valeur est attendue",
                            "se espera una letra con su valor"};

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_letter(char c) {
    return c >= 'A' && c <= 'Z';
}
bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

std::optional<std::uint16_t> Row::number(char letter, double least, double most) {
    const Field& f = fields.front();
    if (f.letter != letter || !f.value) {
        wrong(f.column, f.end, no_row_number);
        return std::nullopt;
    }
    if (*f.value != std::floor(*f.value) || *f.value < least || *f.value > most) {
        wrong(f.column, f.end, out_of_range);
        return std::nullopt;
    }
    return static_cast<std::uint16_t>(*f.value);
}

double Row::whole(char letter, double most, double otherwise) {
    const Field* f = find(letter, 1);
    if (!f || !f->value) return otherwise;
    if (*f->value >= 0 && *f->value <= most && *f->value == std::floor(*f->value)) return *f->value;
    wrong(f->column, f->end, out_of_range);
    return otherwise;
}

/// Cuts a line into its fields: a letter, then an optional sign and number with blanks between them.
void scan(std::string_view line, Row& row) {
    std::size_t i = 0;
    const auto blanks = [&] {
        while (i < line.size() && is_blank(line[i])) ++i;
    };
    for (blanks(); i < line.size(); blanks()) {
        Field f;
        f.column = static_cast<std::uint32_t>(i);
        if (is_letter(line[i])) f.letter = line[i++];
        const std::size_t after_letter = i;
        blanks();
        const bool minus = i < line.size() && line[i] == '-';
        if (minus || (i < line.size() && line[i] == '+')) ++i;
        blanks();
        double v = 0;
        if (i < line.size() && (is_digit(line[i]) || line[i] == '.')) {
            const auto [end, error] =
                std::from_chars(line.data() + i, line.data() + line.size(), v, std::chars_format::fixed);
            if (error == std::errc()) f.value = minus ? -v : v;
            i = static_cast<std::size_t>(end - line.data());
        }
        f.end = static_cast<std::uint32_t>(f.value ? i : after_letter);
        if (minus && !f.value) return row.wrong(f.column, static_cast<std::uint32_t>(i), no_number);
        if (!f.letter && !f.value) return row.wrong(f.column, f.column + 1, not_a_column);
        row.fields.push_back(f);
    }
}

/// Tables are in the control's own unit (INCHES).
double unit(const Machine& m) {
    return m.inches_parameter == program::LengthUnit::inch ? 25.4 : 1;
}

/// D001 X Z R F I K. A mill's table has the length L instead, along Z here, and its I is wear of the radius.
void offset_row(Row& row, Machine& m, const Machine&) {
    const auto d = row.number('D', 1, 255);
    if (!d) return;
    const double k = unit(m);
    machine::Offset o;
    o.x = k * row.value('X');
    o.z = k * row.value('Z', row.value('L'));
    o.nose = k * row.value('R');
    o.tip = static_cast<std::uint8_t>(row.whole('F', 9));
    o.wear_z = k * row.value('K');
    (row.find('L') ? o.nose : o.wear_x) += k * row.value('I');
    m.offsets[*d] = o;
    m.offset_count = std::max(m.offset_count, *d);
}

/// T0001 D001 F001, then life data, which no motion needs. A tool that the machine file lists keeps its insert.
void tool_row(Row& row, Machine& m, const Machine& before) {
    const auto t = row.number('T', 1, 9999);
    if (!t) return;
    const auto known = before.tools.find(*t);
    machine::Tool tool = known == before.tools.end() ? before.default_tool : known->second;
    tool.offset = static_cast<std::uint16_t>(row.whole('D', 255));
    tool.family = static_cast<std::uint16_t>(row.whole('F', 255));
    tool.pocket = *t;
    m.tools[*t] = tool;
}

/// P001 T0001, or an empty T: the pocket holds nothing.
void magazine_row(Row& row, Machine& m, const Machine&) {
    const auto pocket = row.number('P', 1, 255);
    const auto t = static_cast<std::uint16_t>(pocket ? row.whole('T', 9999) : 0);
    if (t == 0) return;
    machine::Tool tool = m.default_tool;
    tool.offset = m.tool_takes_own_offset ? t : tool.offset;
    m.tools.try_emplace(t, tool).first->second.pocket = *pocket;
}

/// G54 X Y Z: X as a radius (8055 T 4.4.2).
void origin_row(Row& row, Machine& m, const Machine&) {
    const auto g = row.number('G', 54, 59);
    if (!g) return;
    PerAxis<double>& origin = m.origins[*g - 53];
    origin = {};
    for (std::size_t i = 1; i < row.fields.size(); ++i) {
        const Field& f = row.fields[i];
        const auto axis = axis_of(f.letter);
        if (!axis || !f.value) return row.wrong(f.column, f.end, not_a_column);
        origin[*axis] = *f.value * (is_rotary(*axis) ? 1 : unit(m));
    }
}

/// P100 and its value.
void parameter_row(Row& row, Machine& m, const Machine&) {
    const auto p = row.number('P', 100, 9999);
    if (!p) return;
    if (row.fields.size() != 2 || row.fields[1].letter || !row.fields[1].value)
        return row.wrong(row.fields[0].column, row.fields.back().end, no_number);
    m.parameters[*p] = *row.fields[1].value;
}

/// Before a table is read: it is whole, so what it does not list is not there.
void forget_offsets(Machine& m) {
    m.offsets.clear();
    m.offset_count = 0;
}
void forget_tools(Machine& m) {
    m.tools.clear();
    m.tool_count = 0;
}
void empty_magazine(Machine& m) {
    for (std::uint16_t t = 1; t <= m.tool_count; ++t) {
        machine::Tool tool = m.default_tool;
        tool.offset = m.tool_takes_own_offset ? t : tool.offset;
        m.tools.try_emplace(t, tool);
    }
    for (auto& [number, tool] : m.tools) tool.pocket.reset();
}
void keep(Machine&) {}

struct Table {
    std::string_view name;
    void (*begin)(Machine&);
    void (*row)(Row&, Machine&, const Machine& before);
};

/// In the order in which they are read: the magazine speaks of tools.
constexpr Table tables[] = {{"TO", forget_offsets, offset_row},
                            {"TLF", forget_tools, tool_row},
                            {"TMZ", empty_magazine, magazine_row},
                            {"ORG", keep, origin_row},
                            {"GUP", keep, parameter_row}};

/// Reads one table; false when a line of it is wrong.
bool read(const Table& table, std::string_view text, diag::FileId file, Machine& m, const Machine& before,
          diag::Sink& diagnostics) {
    table.begin(m);
    bool good = true;
    std::uint32_t number = 0;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view line = text.substr(at, end - at);
        while (!line.empty() && (line.back() == '\r' || is_blank(line.back()))) line.remove_suffix(1);
        Row row{table.name, {}, {file, ++number, 1, 1, at}, &diagnostics};
        scan(line, row);
        if (row.good && !row.fields.empty()) table.row(row, m, before);
        good = good && row.good;
        at = end + 1;
    }
    return good;
}

}  // namespace

bool read_control_tables(const std::filesystem::path& folder, Machine& machine, const Register& add,
                         diag::Sink& diagnostics) {
    Machine filled = machine;
    bool good = true, any = false;
    for (const Table& table : tables) {
        const std::filesystem::path path = folder / table.name;
        std::ifstream in(path, std::ios::binary);
        if (!in) continue;
        any = true;
        std::ostringstream text;
        text << in.rdbuf();
        const std::string content = text.str();
        good = read(table, content, add(path.string(), content), filled, machine, diagnostics) && good;
    }
    if (!any)
        diagnostics.report(
            Id::cannot_read_folder, {}, folder.string(),
            Text{"it holds no table TO, TLF, TMZ, ORG or GUP", "il ne contient aucune table TO, TLF, TMZ, ORG ou GUP",
                 "no contiene ninguna tabla TO, TLF, TMZ, ORG o GUP"});
    if (!good || !any) return false;
    machine = std::move(filled);
    return true;
}

}  // namespace fagorc::frontend
