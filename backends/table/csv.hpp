// The table of moves (docs/csv.md): a contract with the tools and tests that read it.
#pragma once

#include <memory>

#include "backends/backend.hpp"
#include "backends/output.hpp"

namespace fagorc::backends {

struct CsvOptions {
    bool part_frame = false;  ///< coordinates from the active part zero instead of the machine zero
    bool events = false;      ///< rows for events too
};

std::unique_ptr<operation::Sink> make_csv_writer(const Job& job, Output& output, const CsvOptions& options);

}  // namespace fagorc::backends
