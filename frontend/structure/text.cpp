#include "frontend/structure/text.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>

namespace fagorc::frontend {
namespace {

/// Bytes as they come from a file. A large block starts on a large page and asks for such: touching and filling it costs
/// a fraction then.
class Buffer {
  public:
    explicit Buffer(std::size_t room) { grow(room); }

    char* end() { return bytes_.get() + size_; }
    std::size_t size() const { return size_; }
    std::size_t room() const { return room_ - size_; }
    void add(std::size_t size) { size_ += size; }
    void cut(std::size_t size) { size_ = size; }
    void append(std::string_view text) {
        if (text.empty()) return;
        std::memcpy(end(), text.data(), text.size());
        size_ += text.size();
    }
    void grow(std::size_t room) {
        std::unique_ptr<char[], Free> larger(static_cast<char*>(std::aligned_alloc(page(room), rounded(room))));
        if (!larger) throw std::bad_alloc();
        if (page(room) == large_page) ::madvise(larger.get(), rounded(room), MADV_HUGEPAGE);
        if (size_) std::memcpy(larger.get(), bytes_.get(), size_);
        bytes_ = std::move(larger);
        room_ = room;
    }
    std::string_view text() const { return {bytes_.get(), size_}; }

  private:
    struct Free {
        void operator()(char* bytes) const { std::free(bytes); }
    };
    static constexpr std::size_t large_page = std::size_t{2} << 20;
    static std::size_t page(std::size_t room) { return room < large_page ? 64 : large_page; }
    static std::size_t rounded(std::size_t room) { return (room + page(room) - 1) / page(room) * page(room); }

    std::unique_ptr<char[], Free> bytes_;
    std::size_t size_ = 0, room_ = 0;
};

class MemoryText final : public Text {
  public:
    /// Takes a buffer that has room for a line end.
    explicit MemoryText(Buffer bytes) : bytes_(std::move(bytes)) {
        bytes_.cut(without_tail(bytes_.text()));
        ready_ = bytes_.size();
        bytes_.append("\n");
        data_ = bytes_.text().data();
    }

  private:
    Buffer bytes_;
};

/// Reads a descriptor to its end and leaves room for a line end; an error number, or 0.
int read_all(int fd, Buffer& bytes) {
    for (;;) {
        if (bytes.room() < 2) bytes.grow(2 * bytes.size());
        const ssize_t n = ::read(fd, bytes.end(), bytes.room() - 1);
        if (n == 0) return 0;
        if (n < 0 && errno != EINTR) return errno;
        if (n > 0) bytes.add(static_cast<std::size_t>(n));
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

std::unique_ptr<Text> text_of(std::string_view text) {
    Buffer bytes(text.size() + 1);
    bytes.append(text);
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
    if (!S_ISREG(status.st_mode)) return text_of_stream(fd, path, out);
    // Two bytes more than there are: the second read finds the end without growing.
    Buffer bytes(static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)) + 2);
    const int error = read_all(fd, bytes);
    ::close(fd);
    if (error) return fail(error);
    if (!is_program_text(bytes.text(), out)) return nullptr;
    return std::make_unique<MemoryText>(std::move(bytes));
}

}  // namespace fagorc::frontend
