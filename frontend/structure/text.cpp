#include "frontend/structure/text.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace fagorc::frontend {
namespace {

class MemoryText final : public Text {
  public:
    explicit MemoryText(std::string bytes) : bytes_(std::move(bytes)) {
        bytes_.resize(without_tail(bytes_));
        ready_ = bytes_.size();
        bytes_ += '\n';
        data_ = bytes_.data();
    }

  private:
    std::string bytes_;
};

/// Reads a descriptor to its end; an error number, or 0.
int read_all(int fd, std::string& bytes) {
    for (;;) {
        const std::size_t have = bytes.size();
        const std::size_t room = std::max<std::size_t>(std::size_t{1} << 16, bytes.capacity() - have - 1);
        bytes.resize(have + room);
        const ssize_t n = ::read(fd, bytes.data() + have, room);
        bytes.resize(have + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
        if (n == 0) return 0;
        if (n < 0 && errno != EINTR) return errno;
    }
}

}  // namespace

std::size_t Text::without_tail(std::string_view text) {
    // SUB, EOT, ETX and ESC end a file on the wire (8055 T 1.3); NUL fills up paper tape and old disks.
    const std::size_t last = text.find_last_not_of(std::string_view("\0\x1a\x04\x03\x1b", 5));
    return last == std::string_view::npos ? 0 : last + 1;
}

bool is_program_text(std::string_view head, diag::Sink& out) {
    if (head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF")) {
        out.report(diag::Id::utf16_file, diag::Place{});
        return false;
    }
    const auto strange = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 &&
               std::string_view("\0\t\n\v\f\r\x1a\x1b\x03\x04", 10).find(c) == std::string_view::npos;
    };
    const std::string_view sample = head.substr(0, 4096);
    if (std::count_if(sample.begin(), sample.end(), strange) * 20 <= static_cast<std::ptrdiff_t>(sample.size()))
        return true;
    const std::size_t first =
        static_cast<std::size_t>(std::find_if(sample.begin(), sample.end(), strange) - sample.begin());
    out.report(diag::Id::binary_file, diag::Place{}, first + 1,
               static_cast<int>(static_cast<unsigned char>(sample[first])));
    return false;
}

std::unique_ptr<Text> text_of(std::string bytes) {
    return std::make_unique<MemoryText>(std::move(bytes));
}

std::unique_ptr<Text> text_of_file(const std::string& path, diag::Sink& out) {
    const auto fail = [&](int error) {
        out.report(diag::Id::cannot_read, diag::Place{}, path, std::strerror(error));
        return nullptr;
    };
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd < 0) return fail(errno);
    struct stat status {};
    ::fstat(fd, &status);
    if (S_ISDIR(status.st_mode)) {
        ::close(fd);
        out.report(diag::Id::is_a_directory, diag::Place{}, path);
        return nullptr;
    }
    if (!S_ISREG(status.st_mode)) return text_of_stream(fd, out);
    std::string bytes;
    bytes.reserve(static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)) + (std::size_t{1} << 16) + 2);
    const int error = read_all(fd, bytes);
    ::close(fd);
    if (error) return fail(error);
    if (!is_program_text(bytes, out)) return nullptr;
    return text_of(std::move(bytes));
}

}  // namespace fagorc::frontend
