// What every backend gets besides the operations. A backend is an operation::Sink behind the passes: its points are the
// tool tip's, counted from the machine zero. It writes to an Output and leaves `Output::finish` to its caller, who
// knows whether the program had errors.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/diag/diagnostic.hpp"
#include "ir/machine/machine.hpp"
#include "ir/operation/operation.hpp"

namespace fagorc::backends {

/// The programs that operations come from.
class Programs {
  public:
    virtual ~Programs() = default;
    /// File name; outputs show it without its folder, so that they do not depend on where the file lies.
    virtual std::string_view name(diag::FileId file) const = 0;
    /// The text from `from` to its end, as its bytes are; what lies before may leave the memory until it is asked for
    /// again. Asked for when all operations have come.
    virtual std::string_view text(diag::FileId file, std::size_t from = 0) const = 0;
    /// Where an operation was programmed, for findings about it.
    virtual diag::Place place(const operation::Context& at) const = 0;
    /// The label (N) of the block that made an operation; nothing where it has none.
    virtual std::optional<std::uint32_t> label(const operation::Context& at) const = 0;
};

/// One compilation; what it refers to outlives the backend.
struct Job {
    const operation::Tables& tables;
    const std::vector<std::string>& texts;  ///< of message events, by Event::text; grows while operations come
    const machine::Machine& machine;
    const Programs& programs;
    diag::Sink& diagnostics;
    std::string producer;  ///< name and version of the program that compiles: "fagorc 0.1.0"
};

/// The name of a file without its folder.
constexpr std::string_view base_name(std::string_view path) {
    return path.substr(path.find_last_of("/\\") + 1);
}

}  // namespace fagorc::backends
