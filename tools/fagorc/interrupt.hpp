// What an interrupted run leaves behind: nothing.
#pragma once

#include <string_view>

namespace fagorc::tool {

/// While it lives, SIGINT, SIGTERM and SIGHUP remove a file before they end the process. One at a time.
class RemovedOnInterrupt {
  public:
    /// An empty path: nothing to remove.
    explicit RemovedOnInterrupt(std::string_view path);
    RemovedOnInterrupt(const RemovedOnInterrupt&) = delete;
    RemovedOnInterrupt& operator=(const RemovedOnInterrupt&) = delete;
    ~RemovedOnInterrupt();
};

}  // namespace fagorc::tool
