#include "tools/fagorc/part.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "frontend/controls/controls.hpp"
#include "frontend/machine/machine.hpp"
#include "tools/fagorc/version.hpp"

namespace fagorc::tool {

Part::Part(const Settings& settings, Console& console) : settings_(settings), diagnostics_(console.sink_of(shown_)) {
    dialect_ = settings.control == "auto" ? frontend::dialects().front() : frontend::dialect(settings.control);
    workspace_ = std::make_unique<frontend::Workspace>(
        *dialect_, diagnostics_, frontend::Options{!settings.no_shape_cache, !settings.no_loop_cache});
    shown_ = workspace_.get();
}

Part::~Part() = default;

bool Part::load(const std::string& path) {
    if (!load_machine() || !live_.read(settings_.values, *dialect_, diagnostics_)) return false;
    for (const std::string& folder : settings_.libraries)
        if (!workspace_->add_library(folder)) return false;
    program_ = workspace_->open(path);
    return program_ != nullptr;
}

bool Part::load_machine() {
    machine_ = frontend::built_in_lathe(*dialect_);
    if (!settings_.machine_file.empty()) {
        std::ifstream file(settings_.machine_file, std::ios::binary);
        std::string text{std::istreambuf_iterator<char>(file), {}};
        if (!file.good() && !file.eof()) {
            diagnostics_.report(diag::Id::cannot_read, diag::Place{}, settings_.machine_file, std::strerror(errno));
            return false;
        }
        const diag::FileId id = workspace_->add_text(settings_.machine_file, text);
        auto read = frontend::read_machine_file(text, settings_.machine_file, id, machine_, diagnostics_);
        if (!read) return false;
        machine_ = std::move(*read);
    }
    const auto add = [this](std::string name, std::string text) {
        return workspace_->add_text(std::move(name), std::move(text));
    };
    return settings_.tables_folder.empty() ||
           frontend::read_control_tables(settings_.tables_folder, machine_, add, diagnostics_);
}

passes::ExecuteResult Part::run(operation::Sink& tail, const Run& run) {
    passes::Pipeline pipeline({machine_, tables_, diagnostics_, *this}, tail,
                              {run.stop_after, settings_.verify_passes});
    passes::ExecuteOptions options;
    for (int mark : settings_.skip)
        options.skip_marks = static_cast<std::uint8_t>(options.skip_marks | 1u << (mark - 1));
    options.max_blocks = settings_.max_blocks;
    options.live_may_be_unknown = run.checking;
    options.stop = run.stop;
    return passes::execute(*program_, workspace_->library(), *dialect_, machine_, live_, tables_, texts_, diagnostics_,
                           pipeline.head(), options);
}

backends::Job Part::job() {
    return {tables_, texts_.list, machine_, *this, diagnostics_, std::string("fagorc ") + version};
}

std::string Part::machine_name() const {
    return machine_.source.empty() ? "built-in lathe" : machine_.source;
}

diag::Place Part::place(const operation::Context& at) const {
    program::Program* p = workspace_->program(tables_.chains[at.chain].program);
    return p ? p->place_of_line(at.line) : diag::Place{};
}

std::optional<std::uint32_t> Part::label(const operation::Context& at) const {
    program::Program* p = workspace_->program(tables_.chains[at.chain].program);
    return p ? p->label_of_line(at.line) : std::nullopt;
}

std::string_view Part::text(diag::FileId file, std::size_t from) const {
    program::Program* p = workspace_->program(file);
    return p ? p->text(from) : std::string_view{};
}

}  // namespace fagorc::tool
