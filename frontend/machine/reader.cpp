// Lays a machine file over a machine: walks the TOML tree by the key tables and reports whatever does not fit them.
#include <toml++/toml.h>

#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <vector>

#include "frontend/controls/controls.hpp"
#include "frontend/machine/findings.hpp"
#include "frontend/machine/key.hpp"
#include "frontend/machine/machine.hpp"
#include "ir/base/nearest.hpp"

namespace fagorc::frontend {
namespace machine_file {
namespace {

using diag::Id;
using machine::Machine;

constexpr double inch = 25.4;

constexpr Text a_number{"a number", "un nombre", "un número"};
constexpr Text a_whole_number{"a whole number", "un nombre entier", "un número entero"};
constexpr Text yes_or_no{"true or false", "true ou false", "true o false"};
constexpr Text a_table{"a table", "une table", "una tabla"};
constexpr Text rows{"rows in double brackets", "des lignes entre doubles crochets", "filas entre corchetes dobles"};

Spot spot(const toml::source_region& r) {
    return {r.begin.line, r.begin.column, r.end.line, r.end.column};
}

/// The digits of "P100" or "N7" after its letter; nothing for other names.
std::optional<std::uint32_t> number_after(char letter, std::string_view name) {
    std::uint32_t n = 0;
    if (name.size() < 2 || name[0] != letter) return std::nullopt;
    const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), n);
    if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
    return n;
}

/// Row of the zero-offset table that a key of [origins] names: G54..G59 are rows 1..6, N1..N20 all (8055 T 4.4.2).
std::optional<int> origin_row(std::string_view name) {
    if (const auto g = number_after('G', name); g && *g >= 54 && *g <= 59) return static_cast<int>(*g - 53);
    if (const auto n = number_after('N', name); n && *n >= 1 && *n <= 20) return static_cast<int>(*n);
    return std::nullopt;
}

class Reader {
  public:
    Reader(Machine& machine, Findings& findings) : machine_(machine), findings_(findings) {}

    void read(const toml::table& root);

  private:
    void general(const toml::table& table);
    void control(const toml::node& value);
    void axes(const toml::table& table);
    void start(const toml::table& table);
    void origins(const toml::table& table);
    void parameters(const toml::table& table);
    void modal(const toml::table& table) { keys(table, modal_keys(), &machine_); }
    void spindle(const toml::table& table) { keys(table, spindle_keys(), &machine_); }
    void policy(const toml::table& table) { keys(table, policy_keys(), &machine_); }
    void offset(const toml::table& row, std::uint16_t number);
    void tool(const toml::table& row, std::uint16_t number);
    void misc(const toml::table& row, std::uint16_t number);

    struct Section {
        std::string_view name;
        void (Reader::*read)(const toml::table&) = nullptr;
        void (Reader::*read_row)(const toml::table&, std::uint16_t number) = nullptr;  ///< of a [[name]] row
        double most = 0;                                                               ///< highest row number
    };
    static std::span<const Section> sections();
    void section(const Section& s, const toml::node& value);

    /// Applies a table's keys in the order of `known`; `also` are names that the caller has read itself.
    void keys(const toml::table& table, std::span<const Key> known, void* owner,
              std::span<const std::string_view> also = {}, bool rotary = false);
    void unknown(const toml::key& key, const std::vector<std::string_view>& names);
    void apply(const Key& key, const toml::node& value, void* owner, bool rotary);
    void wrong_type(std::string_view key, const toml::node& value, diag::Argument takes);
    std::optional<double> number(std::string_view key, const toml::node& value, bool whole);
    std::optional<double> boolean(const Key& key, const toml::node& value);
    std::optional<double> choice(const Key& key, const toml::node& value);
    bool in_range(std::string_view key, const toml::node& value, double v, const control::Range& range);
    const toml::table* table(std::string_view name, const toml::node& value);
    std::optional<std::uint16_t> row_number(std::string_view name, const toml::table& row, double most);
    double unit(bool rotary) const {
        return !rotary && machine_.inches_parameter == program::LengthUnit::inch ? inch : 1;
    }

    Machine& machine_;
    Findings& findings_;
};

/// In the order in which they are applied: what others depend on comes first, whatever the order in the file.
std::span<const Reader::Section> Reader::sections() {
    static constexpr std::array all = {Section{"machine", &Reader::general},
                                       Section{"modal", &Reader::modal},
                                       Section{"axes", &Reader::axes},
                                       Section{"spindle", &Reader::spindle},
                                       Section{"start", &Reader::start},
                                       Section{"offset", nullptr, &Reader::offset, 255},
                                       Section{"tool", nullptr, &Reader::tool, 9999},
                                       Section{"m", nullptr, &Reader::misc, 9999},
                                       Section{"origins", &Reader::origins},
                                       Section{"parameters", &Reader::parameters},
                                       Section{"policy", &Reader::policy}};
    return all;
}

void Reader::read(const toml::table& root) {
    std::vector<std::string_view> names;
    for (const Section& s : sections()) {
        names.push_back(s.name);
        if (const toml::node* value = root.get(s.name)) section(s, *value);
    }
    for (const auto& [key, value] : root)
        if (std::find(names.begin(), names.end(), key.str()) == names.end()) unknown(key, names);
}

void Reader::section(const Section& s, const toml::node& value) {
    if (s.read) {
        if (const toml::table* t = table(s.name, value)) (this->*s.read)(*t);
        return;
    }
    const toml::array* array = value.as_array();
    if (!array) return wrong_type(s.name, value, rows);
    std::set<std::uint16_t> seen;
    for (const toml::node& element : *array) {
        const toml::table* row = table(s.name, element);
        const auto n = row ? row_number(s.name, *row, s.most) : std::nullopt;
        if (!n) continue;
        if (!seen.insert(*n).second)
            findings_.report(Id::machine_row_repeated, spot(row->get("number")->source()),
                             std::string(s.name) + " " + std::to_string(*n));
        (this->*s.read_row)(*row, *n);
    }
}

void Reader::general(const toml::table& table) {
    std::vector<std::string_view> also(other_parameters().begin(), other_parameters().end());
    also.push_back("control");
    if (const toml::node* value = table.get("control")) control(*value);
    for (const auto& [key, value] : table) {
        const std::string_view name = key.str();
        if (!is_kept_by_name(name)) continue;
        also.push_back(name);
        const auto* truth = value.as_boolean();
        const auto v = truth ? std::optional(truth->get() ? 1.0 : 0.0) : number(name, value, false);
        if (v) machine_.other_parameters[std::string(name)] = *v;
    }
    keys(table, machine_keys(), &machine_, also);
}

void Reader::control(const toml::node& value) {
    std::vector<std::string_view> names;
    for (const control::Dialect* d : dialects()) names.push_back(d->name);
    const auto* name = value.as_string();
    if (!name) return wrong_type("control", value, choices_text(names));
    if (!dialect(name->get())) return wrong_type("control", value, choices_text(names));
    machine_.control = name->get();
}

void Reader::axes(const toml::table& table_of_axes) {
    if (table_of_axes.empty()) return;
    for (machine::AxisData& a : machine_.axes) a.exists = false;
    for (const auto& [key, value] : table_of_axes) {
        const auto axis = key.str().size() == 1 ? axis_of(key.str()[0]) : std::nullopt;
        if (!axis) {
            unknown(key, {"X", "Y", "Z", "U", "V", "W", "A", "B", "C"});
            continue;
        }
        machine::AxisData& data = machine_.axes[*axis];
        data.exists = true;
        const toml::table* t = table("axes." + std::string(key.str()), value);
        if (!t) continue;
        keys(*t, axis_keys(), &data, {}, is_rotary(*axis));
        if (data.min && data.max && *data.min > *data.max)
            findings_.report(Id::machine_value_out_of_range, spot(key.source()), "max", *data.max,
                             range_text({.least = *data.min}));
    }
}

void Reader::start(const toml::table& table) {
    std::vector<std::string_view> letters;
    for (const auto& [key, value] : table) {
        const std::string_view name = key.str();
        const auto axis = name.size() == 1 ? axis_of(name[0]) : std::nullopt;
        if (!axis) continue;
        letters.push_back(name);
        const bool diameter = *axis == Axis::X && machine_.power_on.x == program::XWord::diameter;
        if (const auto v = number(name, value, false))
            machine_.start[*axis] = *v * unit(is_rotary(*axis)) / (diameter ? 2 : 1);
    }
    keys(table, start_keys(), &machine_, letters);
}

void Reader::origins(const toml::table& origins) {
    for (const auto& [key, value] : origins) {
        const auto row = origin_row(key.str());
        if (!row) {
            unknown(key, {"G54", "G55", "G56", "G57", "G58", "G59", "N7", "N8", "N9", "N10", "N20"});
            continue;
        }
        const toml::table* values = table(key.str(), value);
        if (!values) continue;
        for (const auto& [letter, coordinate] : *values) {
            const auto axis = letter.str().size() == 1 ? axis_of(letter.str()[0]) : std::nullopt;
            if (!axis)
                unknown(letter, {});
            else if (const auto v = number(letter.str(), coordinate, false))
                machine_.origins[*row][*axis] = *v * unit(is_rotary(*axis));
        }
    }
}

void Reader::parameters(const toml::table& table) {
    const control::Dialect* language = dialect(machine_.control);
    for (const auto& [key, value] : table) {
        const auto n = number_after('P', key.str());
        const bool exists = n && language &&
                            std::any_of(language->parameters.begin(), language->parameters.end(),
                                        [n](const auto& r) { return *n >= r.first && *n <= r.last; });
        if (!exists)
            unknown(key, {});
        else if (const auto v = number(key.str(), value, false))
            machine_.parameters[*n] = *v;
    }
}

void Reader::offset(const toml::table& row, std::uint16_t number) {
    machine::Offset data = machine_.default_offset;
    keys(row, offset_keys(), &data, std::array<std::string_view, 1>{"number"});
    machine_.offsets[number] = data;
}

void Reader::tool(const toml::table& row, std::uint16_t number) {
    machine::Tool data = machine_.default_tool;
    if (machine_.tool_takes_own_offset && number <= machine_.offset_count) data.offset = number;
    if (number <= machine_.tool_count) data.pocket = number;
    keys(row, tool_keys(), &data, std::array<std::string_view, 1>{"number"});
    machine_.tools[number] = data;
}

void Reader::misc(const toml::table& row, std::uint16_t number) {
    machine::Misc data;
    keys(row, misc_keys(), &data, std::array<std::string_view, 1>{"number"});
    machine_.misc[number] = data;
}

std::optional<std::uint16_t> Reader::row_number(std::string_view name, const toml::table& row, double most) {
    const toml::node* value = row.get("number");
    if (!value) {
        findings_.report(Id::machine_key_missing, spot(row.source()), std::string(name), "number");
        return std::nullopt;
    }
    const auto n = number("number", *value, true);
    // D0 and T0 mean "none" and have no row (8055 T 5.6); M0 has one.
    const control::Range range{.least = name == "m" ? 0.0 : 1.0, .most = most};
    if (!n || !in_range("number", *value, *n, range)) return std::nullopt;
    return static_cast<std::uint16_t>(*n);
}

void Reader::keys(const toml::table& table, std::span<const Key> known, void* owner,
                  std::span<const std::string_view> also, bool rotary) {
    std::vector<std::string_view> names(also.begin(), also.end());
    for (const Key& k : known) {
        names.push_back(k.name);
        for (const auto& [key, value] : table)
            if (same_name(key.str(), k.name)) apply(k, value, owner, rotary);
    }
    for (const auto& [key, value] : table) {
        const std::string_view name = key.str();
        if (std::none_of(names.begin(), names.end(), [name](std::string_view n) { return same_name(n, name); }))
            unknown(key, names);
    }
}

void Reader::unknown(const toml::key& key, const std::vector<std::string_view>& names) {
    const std::string_view near = nearest(key.str(), names);
    if (near.empty())
        findings_.report(Id::machine_key_unknown, spot(key.source()), key.str());
    else
        findings_.report(Id::machine_key_unknown_near, spot(key.source()), key.str(), near);
}

void Reader::apply(const Key& key, const toml::node& value, void* owner, bool rotary) {
    std::optional<double> v;
    switch (key.kind) {
        case Kind::number:
        case Kind::whole:
            v = number(key.name, value, key.kind == Kind::whole);
            break;
        case Kind::boolean:
            v = boolean(key, value);
            break;
        case Kind::choice:
            v = choice(key, value);
            break;
    }
    if (!v || !in_range(key.name, value, *v, key.range)) return;
    if (key.measure != Measure::none) *v *= unit(rotary && key.measure == Measure::axis_length);
    key.set(owner, *v);
}

void Reader::wrong_type(std::string_view key, const toml::node& value, diag::Argument takes) {
    findings_.report(Id::machine_value_wrong_type, spot(value.source()), key, std::move(takes));
}

std::optional<double> Reader::number(std::string_view key, const toml::node& value, bool whole) {
    const auto v = value.is_number() ? value.value<double>() : std::nullopt;
    if (v && std::isfinite(*v) && (!whole || *v == std::floor(*v))) return v;
    wrong_type(key, value, whole ? a_whole_number : a_number);
    return std::nullopt;
}

std::optional<double> Reader::boolean(const Key& key, const toml::node& value) {
    if (const auto* b = value.as_boolean()) return b->get() ? 1 : 0;
    if (const auto* i = value.as_integer(); i && (i->get() == 0 || i->get() == 1)) return static_cast<double>(i->get());
    if (const auto* s = value.as_string(); s && (s->get() == "YES" || s->get() == "NO")) return s->get() == "YES";
    wrong_type(key.name, value, yes_or_no);
    return std::nullopt;
}

std::optional<double> Reader::choice(const Key& key, const toml::node& value) {
    for (std::size_t i = 0; i < key.choices.size(); ++i) {
        const auto* s = value.as_string();
        const auto* n = value.as_integer();
        if ((s && s->get() == key.choices[i]) || (n && n->get() == static_cast<std::int64_t>(i)))
            return static_cast<double>(i);
    }
    wrong_type(key.name, value, choices_text(key.choices));
    return std::nullopt;
}

bool Reader::in_range(std::string_view key, const toml::node& value, double v, const control::Range& range) {
    if (v >= range.least && v <= range.most && !(range.above && v == range.least)) return true;
    findings_.report(Id::machine_value_out_of_range, spot(value.source()), key, v, range_text(range));
    return false;
}

const toml::table* Reader::table(std::string_view name, const toml::node& value) {
    if (!value.is_table()) wrong_type(name, value, a_table);
    return value.as_table();
}

}  // namespace
}  // namespace machine_file

std::optional<machine::Machine> read_machine_file(std::string_view text, std::string_view name, diag::FileId file,
                                                  const machine::Machine& base, diag::Sink& diagnostics) {
    machine::Machine machine = base;
    machine.source = name;
    machine_file::Findings findings(text, file);
    try {
        const toml::table root = toml::parse(text, name);
        machine_file::Reader(machine, findings).read(root);
    } catch (const toml::parse_error& error) {
        findings.report(diag::Id::machine_file_syntax, machine_file::spot(error.source()), error.description());
    }
    findings.hand_on(diagnostics);
    if (findings.any()) return std::nullopt;
    return machine;
}

}  // namespace fagorc::frontend
