#include "backends/output.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace fagorc::backends {
namespace {

/// Bytes to an open descriptor, which the derived class owns.
class Descriptor : public Output {
  protected:
    Descriptor(std::string name, int descriptor) : name_(std::move(name)), descriptor_(descriptor) {}

    bool put(Bytes bytes) override {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) return fail(name_, errno);
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
        return true;
    }
    /// Closing may still fail: a network file system reports a full disk then.
    bool close_descriptor() {
        const int descriptor = std::exchange(descriptor_, -1);
        return descriptor < 0 || ::close(descriptor) == 0 || fail(name_, errno);
    }

    std::string name_;
    int descriptor_;
};

class Stream final : public Descriptor {
  public:
    Stream() : Descriptor("-", STDOUT_FILENO) { ::signal(SIGPIPE, SIG_IGN); }

  protected:
    bool close() override { return true; }
};

/// A device or a named pipe: there is nothing to replace.
class Device final : public Descriptor {
  public:
    explicit Device(const std::string& path) : Descriptor(path, ::open(path.c_str(), O_WRONLY | O_CLOEXEC)) {
        if (descriptor_ < 0)
            fail(path, errno);
        else
            ::signal(SIGPIPE, SIG_IGN);
    }
    ~Device() override { close_descriptor(); }

  protected:
    bool close() override { return close_descriptor(); }
};

class File final : public Descriptor {
  public:
    explicit File(std::string path) : Descriptor(path, -1), target_(std::move(path)), temporary_(target_ + ".XXXXXX") {
        descriptor_ = ::mkostemp(temporary_.data(), O_CLOEXEC);
        if (descriptor_ < 0) {
            fail(name_, errno);
            temporary_.clear();
            return;
        }
        const mode_t mask = ::umask(0);
        ::umask(mask);
        ::fchmod(descriptor_, 0666 & ~mask);
    }
    ~File() override {
        close_descriptor();
        if (!temporary_.empty()) ::unlink(temporary_.c_str());
    }

  protected:
    bool close() override {
        if (!close_descriptor()) return false;
        if (::rename(temporary_.c_str(), target_.c_str()) != 0) return fail(name_, errno);
        temporary_.clear();
        return true;
    }

  private:
    std::string target_, temporary_;
};

}  // namespace

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
    failure_ = std::move(d);
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

std::unique_ptr<Output> open_standard_output() {
    return std::make_unique<Stream>();
}

bool MemoryOutput::put(Bytes bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return true;
}

}  // namespace fagorc::backends
