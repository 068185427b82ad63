// A whole file in memory: mapped where the system can, else read.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "ir/diag/diagnostic.hpp"

namespace fagorc::tool {

class FileBytes {
  public:
    FileBytes() = default;
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;
    ~FileBytes();

    /// Opens a file, or standard input for "-"; false where that fails, which `out` has been told.
    bool open(const std::string& path, diag::Sink& out);
    std::span<const std::byte> bytes() const { return bytes_; }

  private:
    bool read(int descriptor);

    std::span<const std::byte> bytes_;
    void* mapped_ = nullptr;
    std::vector<std::byte> buffer_;
};

}  // namespace fagorc::tool
