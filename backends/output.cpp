#include "backends/output.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "backends/descriptor.hpp"

namespace fagorc::backends {
namespace {

/// A device or a named pipe: there is nothing to replace.
class Device final : public Descriptor {
  public:
    explicit Device(const std::string& path) : Descriptor(path, ::open(path.c_str(), O_WRONLY | O_CLOEXEC)) {
        ::signal(SIGPIPE, SIG_IGN);
    }

  protected:
    bool close() override { return close_descriptor(); }
};

class File final : public Descriptor {
  public:
    explicit File(const std::string& path) : File(path, path + ".XXXXXX") {}
    ~File() override {
        if (!temporary_.empty()) ::unlink(temporary_.c_str());
    }

    std::string_view temporary() const override { return temporary_; }

  protected:
    /// Collects whole pages: a file system takes them in half the time of others.
    bool put(Bytes bytes) override {
        while (!bytes.empty()) {
            const Bytes part = bytes.first(std::min(bytes.size(), room_size - waiting_));
            std::memcpy(room_ + waiting_, part.data(), part.size());
            waiting_ += part.size();
            bytes = bytes.subspan(part.size());
            if (waiting_ == room_size && !pass_on()) return false;
        }
        return true;
    }
    bool close() override {
        if (!pass_on() || !close_descriptor()) return false;
        if (::rename(temporary_.c_str(), name().c_str()) != 0) return fail(name(), errno);
        temporary_.clear();
        return true;
    }

  private:
    File(const std::string& path, std::string temporary)
        : Descriptor(path, ::mkostemp(temporary.data(), O_CLOEXEC)), temporary_(std::move(temporary)) {
        if (descriptor() < 0) {
            temporary_.clear();
            return;
        }
        const mode_t mask = ::umask(0);
        ::umask(mask);
        ::fchmod(descriptor(), 0666 & ~mask);
    }

    bool pass_on() { return Descriptor::put(Bytes(room_, std::exchange(waiting_, 0))); }

    static constexpr std::size_t room_size = std::size_t{1} << 16;
    std::string temporary_;  ///< empty once it is gone
    std::size_t waiting_ = 0;
    alignas(4096) std::byte room_[room_size];
};

}  // namespace

Descriptor::Descriptor(std::string name, int descriptor) : name_(std::move(name)), descriptor_(descriptor) {
    if (descriptor < 0) fail(name_, errno);
}

bool Descriptor::put(Bytes bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return fail(name_, errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

bool Descriptor::close_descriptor() {
    const int descriptor = std::exchange(descriptor_, -1);
    return descriptor < 0 || ::close(descriptor) == 0 || fail(name_, errno);
}

bool Output::fail(std::string_view name, int error) {
    diag::Diagnostic d;
    if (error == EPIPE) {
        d.id = diag::Id::pipe_closed;
    } else if (error == ENOSPC || error == EDQUOT) {
        d.id = diag::Id::disk_full;
        d.arguments = {name};
    } else {
        d.id = diag::Id::cannot_write;
        d.arguments = {name, std::generic_category().message(error)};
    }
    return fail(std::move(d));
}

bool Output::fail(diag::Diagnostic why) {
    failure_ = std::move(why);
    return false;
}

std::unique_ptr<Output> open_file(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return std::make_unique<File>(path);
    if (!S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) return std::make_unique<Device>(path);
    // A symbolic link stays a link: what it names is replaced. (A folder is left to rename, which says what is wrong.)
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(path, error);
    return std::make_unique<File>(error ? path : real.string());
}

bool MemoryOutput::put(Bytes bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return true;
}

}  // namespace fagorc::backends
