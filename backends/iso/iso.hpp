// Neutral ISO (RS-274) as LinuxCNC's lathe takes it (docs/iso.md): absolute, millimetres, radius mode, flat.
#pragma once

#include <memory>

#include "backends/backend.hpp"
#include "backends/output.hpp"

namespace fagorc::backends {

struct IsoOptions {
    bool map = false;     ///< a comment on each block names the line of the program that made it
    bool events = false;  ///< tool changes, coolant and stops as functions instead of comments
};

/// What the form cannot say is reported as output_cannot_say, once a kind, at its first place.
std::unique_ptr<operation::Sink> make_iso_writer(const Job& job, Output& output, const IsoOptions& options);

}  // namespace fagorc::backends
