// Bytes to an open descriptor: what files, devices and standard output share.
#pragma once

#include <string>

#include "backends/output.hpp"

namespace fagorc::backends {

class Descriptor : public Output {
  public:
    /// Takes a descriptor that the object closes; a negative one is the failure that `errno` tells.
    Descriptor(std::string name, int descriptor);
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() override { close_descriptor(); }

  protected:
    bool put(Bytes bytes) override;
    /// Closing may still fail: a network file system reports a full disk then.
    bool close_descriptor();
    /// Leaves the descriptor open: it is not this object's.
    void release() { descriptor_ = -1; }
    int descriptor() const { return descriptor_; }
    const std::string& name() const { return name_; }

  private:
    std::string name_;
    int descriptor_;
};

}  // namespace fagorc::backends
