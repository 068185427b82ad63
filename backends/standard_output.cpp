// Standard output: passed on at once, or held back until the run is known to be good.
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "backends/descriptor.hpp"
#include "ir/base/temporary_file.hpp"

namespace fagorc::backends {
namespace {

class Stream final : public Descriptor {
  public:
    Stream() : Descriptor("-", STDOUT_FILENO) { ::signal(SIGPIPE, SIG_IGN); }
    ~Stream() override { release(); }

  protected:
    bool close() override { return true; }
};

/// Bytes wait in a temporary file; `Stream` takes them when they are asked for or become too many.
class HeldStream final : public Output {
  public:
    explicit HeldStream(std::uint64_t limit)
        : limit_(limit), file_(temporary_folder(), open_temporary_file()), waiting_(true) {}

  protected:
    bool put(Bytes bytes) override {
        if (!waiting_) return to(stream_, bytes);
        if (reader_gone()) return fail("-", EPIPE);
        size_ += bytes.size();
        return to(file_, bytes) && (size_ <= limit_ || pass_on());
    }
    bool close() override { return !waiting_ || pass_on(); }

  private:
    /// The temporary file, as an output like any other.
    class Waiting final : public Descriptor {
      public:
        using Descriptor::descriptor;
        using Descriptor::Descriptor;

      protected:
        bool close() override { return true; }
    };

    bool to(Output& out, Bytes bytes) { return out.write(bytes) || fail(*out.failure()); }

    bool pass_on() {
        waiting_ = false;
        std::array<std::byte, 1 << 16> piece;
        for (off_t at = 0;;) {
            const ssize_t got = ::pread(file_.descriptor(), piece.data(), piece.size(), at);
            if (got < 0 && errno == EINTR) continue;
            if (got < 0) return fail(temporary_folder(), errno);
            if (got == 0) return true;
            if (!to(stream_, Bytes(piece).first(static_cast<std::size_t>(got)))) return false;
            at += got;
        }
    }

    /// A pipe tells its writer that nobody reads any more before something is written.
    static bool reader_gone() {
        pollfd out{STDOUT_FILENO, 0, 0};
        return ::poll(&out, 1, 0) == 1 && (out.revents & POLLERR) != 0;
    }

    Stream stream_;
    std::uint64_t limit_, size_ = 0;
    Waiting file_;
    bool waiting_;
};

}  // namespace

std::unique_ptr<Output> open_standard_output() {
    return std::make_unique<Stream>();
}

std::unique_ptr<Output> open_held_standard_output(std::uint64_t limit) {
    return std::make_unique<HeldStream>(limit);
}

}  // namespace fagorc::backends
