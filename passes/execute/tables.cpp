#include "passes/execute/tables.hpp"

namespace fagorc::passes {
namespace {

using machine::Machine;
using machine::Offset;
using machine::Tool;

const Offset& offset(const Machine& m, long row) {
    const auto at = m.offsets.find(static_cast<std::uint16_t>(row));
    return at == m.offsets.end() ? m.default_offset : at->second;
}

Offset& own_offset(Machine& m, long row) {
    return m.offsets.try_emplace(static_cast<std::uint16_t>(row), m.default_offset).first->second;
}

/// The tool's row as it reads: a tool that the tables do not list has its own number as offset and pocket.
Tool tool(const Machine& m, long number) {
    const auto n = static_cast<std::uint16_t>(number);
    if (const auto at = m.tools.find(n); at != m.tools.end()) return at->second;
    Tool t = m.default_tool;
    if (m.tool_takes_own_offset) t.offset = n;
    if (number <= m.tool_count) t.pocket = n;
    return t;
}

Tool& own_tool(Machine& m, long number) {
    return m.tools.try_emplace(static_cast<std::uint16_t>(number), tool(m, number)).first->second;
}

template <auto Member>
double get_offset(const Machine& m, long row, Axis) {
    return static_cast<double>(offset(m, row).*Member);
}
template <auto Member>
void set_offset(Machine& m, long row, Axis, double value) {
    Offset& o = own_offset(m, row);
    o.*Member = static_cast<std::decay_t<decltype(o.*Member)>>(value);
}
template <auto Member>
double get_tool(const Machine& m, long row, Axis) {
    return static_cast<double>(tool(m, row).*Member);
}
template <auto Member>
void set_tool(Machine& m, long row, Axis, double value) {
    Tool& t = own_tool(m, row);
    t.*Member = static_cast<std::decay_t<decltype(t.*Member)>>(value);
}

double pocket_of_tool(const Machine& m, long number, Axis) {
    const auto pocket = tool(m, number).pocket;
    return pocket ? *pocket : -1.0;
}

/// Content of a pocket: the tool, 0 when it is empty (8055 T 11.2.2 TMZT).
double tool_in_pocket(const Machine& m, long pocket, Axis) {
    for (const auto& [number, row] : m.tools)
        if (row.pocket == pocket) return number;
    const bool unlisted = pocket <= m.tool_count && !m.tools.contains(static_cast<std::uint16_t>(pocket));
    return unlisted ? static_cast<double>(pocket) : 0;
}

void put_in_pocket(Machine& m, long pocket, Axis, double number) {
    if (const double before = tool_in_pocket(m, pocket, Axis::X); before > 0)
        own_tool(m, static_cast<long>(before)).pocket.reset();
    if (number > 0) own_tool(m, static_cast<long>(number)).pocket = static_cast<std::uint16_t>(pocket);
}

double get_origin(const Machine& m, long index, Axis axis) {
    const auto at = m.origins.find(origin_row(index));
    return at == m.origins.end() ? 0 : at->second[axis];
}
void set_origin(Machine& m, long index, Axis axis, double value) {
    m.origins[origin_row(index)][axis] = value;
}

constexpr control::Range code{.least = 0, .most = 9, .whole = true};
constexpr control::Range offset_number{.least = 0, .most = 255, .whole = true};
constexpr control::Range family{.least = 0, .most = 255, .whole = true};
constexpr control::Range pocket_content{.least = -1, .most = 255, .whole = true};

constexpr TableColumn columns[] = {
    {"TOX", get_offset<&Offset::x>, set_offset<&Offset::x>},
    {"TOZ", get_offset<&Offset::z>, set_offset<&Offset::z>},
    {"TOF", get_offset<&Offset::tip>, set_offset<&Offset::tip>, code},
    {"TOR", get_offset<&Offset::nose>, set_offset<&Offset::nose>},
    {"TOI", get_offset<&Offset::wear_x>, set_offset<&Offset::wear_x>},
    {"TOK", get_offset<&Offset::wear_z>, set_offset<&Offset::wear_z>},
    {"NOSEA", get_tool<&Tool::insert_angle>, set_tool<&Tool::insert_angle>},
    {"NOSEW", get_tool<&Tool::insert_width>, set_tool<&Tool::insert_width>},
    {"CUTA", get_tool<&Tool::cutting_angle>, set_tool<&Tool::cutting_angle>},
    {"TLFD", get_tool<&Tool::offset>, set_tool<&Tool::offset>, offset_number},
    {"TLFF", get_tool<&Tool::family>, set_tool<&Tool::family>, family},
    {"TMZP", pocket_of_tool, nullptr},
    {"TMZT", tool_in_pocket, put_in_pocket, pocket_content},
    {"ORG", get_origin, set_origin},
};

}  // namespace

const TableColumn* find_column(std::string_view name) {
    for (const TableColumn& c : columns)
        if (c.name == name) return &c;
    return nullptr;
}

int origin_row(long index) {
    if (index >= 1 && index <= 20) return static_cast<int>(index);
    return index >= 54 && index <= 59 ? static_cast<int>(index - 53) : 0;
}

}  // namespace fagorc::passes
