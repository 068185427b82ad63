// Where a backend's bytes go: a file that appears whole or not at all, standard output, or memory.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/diag/diagnostic.hpp"

namespace fagorc::backends {

using Bytes = std::span<const std::byte>;

/// Takes bytes one after the other. The first failure is kept; after it nothing more is written. An output that is
/// destroyed before `finish` leaves nothing behind, as far as its kind allows (a pipe has passed its bytes on).
class Output {
  public:
    virtual ~Output() = default;

    /// False once something has failed.
    bool write(Bytes bytes) { return !failure_ && put(bytes); }
    bool write(std::string_view text) { return write(std::as_bytes(std::span(text))); }
    /// All bytes have come: the result becomes visible. False where it, or a write before it, has failed.
    bool finish() { return !failure_ && close(); }
    /// What has failed, for the user: disk_full, pipe_closed or cannot_write.
    const std::optional<diag::Diagnostic>& failure() const { return failure_; }
    /// The name of the file that `finish` renames, for whoever must remove it when the process is ended by a signal;
    /// empty where there is none.
    virtual std::string_view temporary() const { return {}; }

  protected:
    virtual bool put(Bytes bytes) = 0;
    virtual bool close() = 0;
    /// Keeps the failure of a system call by its `errno` value; returns false.
    bool fail(std::string_view name, int error);
    bool fail(diag::Diagnostic why);

  private:
    std::optional<diag::Diagnostic> failure_;
};

/// A file. A regular or new file is written to a temporary in its folder that replaces it at `finish`; a device or a
/// named pipe is written directly. The mode of the file follows the umask.
std::unique_ptr<Output> open_file(const std::string& path);

/// Standard output. A reader that has gone is a failure, not the signal SIGPIPE, which this call switches off.
std::unique_ptr<Output> open_standard_output();

/// Standard output that stays empty when it is not finished: the bytes wait in a nameless temporary file. A reader that
/// has gone meanwhile is a failure. Once more than `limit` bytes wait, they and all that follow are passed on.
std::unique_ptr<Output> open_held_standard_output(std::uint64_t limit);

/// Memory, for tests and for tools that go on with the bytes.
class MemoryOutput final : public Output {
  public:
    const std::vector<std::byte>& bytes() const { return bytes_; }
    std::string_view text() const { return {reinterpret_cast<const char*>(bytes_.data()), bytes_.size()}; }

  protected:
    bool put(Bytes bytes) override;
    bool close() override { return true; }

  private:
    std::vector<std::byte> bytes_;
};

}  // namespace fagorc::backends
