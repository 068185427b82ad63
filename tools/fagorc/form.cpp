#include "tools/fagorc/form.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>

#include "backends/iso/iso.hpp"
#include "backends/table/csv.hpp"
#include "backends/table/json.hpp"
#include "backends/trajectory/writer.hpp"

namespace fagorc::tool {
namespace {

using backends::Job;
using backends::Output;

constexpr std::array<Form, 4> rows = {{
    {"ftj", ".ftj", "trajectory file",
     [](const Job& j, Output& o, const FormOptions&) { return backends::make_trajectory_writer(j, o); }},
    {"iso", ".iso.nc.ngc.tap", "neutral RS-274",
     [](const Job& j, Output& o, const FormOptions& p) {
         return backends::make_iso_writer(j, o, {.map = p.map, .events = p.events});
     }},
    {"csv", ".csv", "table",
     [](const Job& j, Output& o, const FormOptions& p) {
         return backends::make_csv_writer(j, o, {.part_frame = p.frame == "part", .events = p.events});
     }},
    {"json", ".json.jsonl", "lines of objects",
     [](const Job& j, Output& o, const FormOptions&) { return backends::make_json_writer(j, o); }},
}};

/// Whether a list such as ".iso.nc" holds a suffix.
bool holds(std::string_view suffixes, std::string_view suffix) {
    const std::size_t at = suffixes.find(suffix);
    if (at == suffixes.npos) return false;
    const std::size_t end = at + suffix.size();
    return end == suffixes.size() || suffixes[end] == '.' || holds(suffixes.substr(end), suffix);
}

}  // namespace

std::span<const Form> forms() {
    return rows;
}

const Form* form_named(std::string_view name) {
    const auto at = std::find_if(rows.begin(), rows.end(), [&](const Form& f) { return f.name == name; });
    return at == rows.end() ? nullptr : &*at;
}

const Form* form_of_file(std::string_view path) {
    const std::size_t dot = path.find_last_of("./");
    if (dot == path.npos || path[dot] == '/' || dot + 1 == path.size()) return rows.data();
    const std::string_view suffix = path.substr(dot);
    const auto at = std::find_if(rows.begin(), rows.end(), [&](const Form& f) { return holds(f.suffixes, suffix); });
    return at == rows.end() ? nullptr : &*at;
}

void add_form_options(CLI::App& command, FormOptions& options, std::span<const Form> to) {
    std::vector<std::string> names;
    std::string what;
    for (const Form& f : to) {
        names.emplace_back(f.name);
        ((((what += what.empty() ? "" : ", ") += f.name) += " (") += f.title) += ')';
    }
    command.add_option("--to", options.form, "form: " + what)->check(CLI::IsMember(names));
    command.add_option("--frame", options.frame, "csv: coordinates from the machine zero or the active part zero")
        ->check(CLI::IsMember({"machine", "part"}));
    command.add_flag("--events", options.events, "csv, iso: tools, M functions and messages too, not only motion");
    command.add_flag("--map", options.map, "iso: comments that name line and label of the source block");
}

}  // namespace fagorc::tool
