// A program that arrives through a pipe: blocks as they come, spooled to a temporary file only when one can be read
// again.
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "frontend/structure/text.hpp"
#include "ir/base/temporary_file.hpp"

namespace fagorc::frontend {
namespace {

using diag::Id;

/// Address space for the text: only what has been read takes memory, and that can be given back.
constexpr std::size_t reserved = std::size_t{1} << 38;
constexpr std::size_t chunk = std::size_t{1} << 18;
/// Pages so far behind the reader are given back to the file.
constexpr std::size_t kept_behind = std::size_t{4} << 20;
/// More of one block is not kept: no control has blocks like that.
constexpr std::size_t most_of_a_block = std::size_t{1} << 20;
/// An input that goes on for so long without a line end is no program, and might never end.
constexpr std::size_t most_skipped = std::size_t{256} << 20;

/// Standard input as one growing text: what is read is appended to a file, and the file is what is scanned.
class StreamText final : public Text {
  public:
    StreamText(int input, std::string name, int file, char* map, diag::Sink& out)
        : input_(input), name_(std::move(name)), file_(file), map_(map), out_(out) {
        data_ = map;
        complete_ = false;
    }
    StreamText(const StreamText&) = delete;
    StreamText& operator=(const StreamText&) = delete;
    ~StreamText() override {
        ::munmap(map_, reserved);
        ::close(file_);
        ::close(input_);
    }

  private:
    bool more(std::size_t offset) override {
        while (!complete_ && offset >= ready_) fill();
        return offset < ready_;
    }

    /// Takes what the input has, at least one byte.
    void fill() {
        char buffer[chunk];
        const ssize_t n = ::read(input_, buffer, sizeof buffer);
        if (n < 0 && (errno == EINTR || errno == EAGAIN)) {
            pollfd wait{input_, POLLIN, 0};
            ::poll(&wait, 1, -1);
            return;
        }
        if (n == 0) return end();
        if (n < 0) return fail(Id::cannot_read, name_, std::strerror(errno));
        const std::string_view fresh = without_excess({buffer, static_cast<std::size_t>(n)});
        if (skipped_ > most_skipped) return fail(Id::no_line_end, most_skipped >> 20);
        if (size_ + fresh.size() + 1 > reserved) return fail(Id::cannot_spool, std::strerror(EFBIG));
        if (size_ == 0 && !is_program_text(fresh, out_)) return end();
        const std::size_t before = size_ ? size_ - 1 : 0;
        if (!keep(fresh)) return fail(Id::cannot_spool, std::strerror(errno));
        if (!fresh.empty()) find_blocks(before);
    }

    /// The fresh bytes without those of a block that is far too long already: its end is all that matters of it.
    std::string_view without_excess(std::string_view fresh) {
        if (size_ - ready_ < most_of_a_block || map_[size_ - 1] == '\r') return fresh;
        const std::size_t end = std::min(fresh.find_first_of("\r\n"), fresh.size());
        skipped_ = end < fresh.size() ? 0 : skipped_ + end;
        return fresh.substr(end);
    }

    /// Moves `ready_` behind the last whole block, looking from `before` on.
    void find_blocks(std::size_t before) {
        // A CR at the very end waits: an LF may follow that belongs to it.
        const std::string_view fresh(map_ + before, size_ - before);
        const std::size_t whole = fresh.substr(0, fresh.size() - 1).find_last_of("\r\n");
        if (fresh.back() == '\n')
            ready_ = size_;
        else if (whole != std::string_view::npos)
            ready_ = std::max(ready_, before + whole + 1);
        give_back();
    }

    bool keep(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t n = ::write(file_, bytes.data(), bytes.size());
            if (n < 0 && errno != EINTR) return false;
            bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
            size_ += static_cast<std::size_t>(std::max<ssize_t>(n, 0));
        }
        return true;
    }

    void end() {
        const std::size_t text = without_tail({map_, size_});
        if (::pwrite(file_, "\n", 1, static_cast<off_t>(text)) != 1)
            return fail(Id::cannot_spool, std::strerror(errno));
        complete_ = true;
        ready_ = std::max(ready_, text);
    }

    /// The input ends before its end; the block at hand is not whole and is left out.
    template <class... Arguments>
    void fail(Id id, Arguments&&... arguments) {
        complete_ = true;
        failure_.emplace(diag::Diagnostic{id, {}, {diag::Argument(std::forward<Arguments>(arguments))...}, {}});
    }

    /// Pages that have been scanned go back to the file; a jump back reads them again.
    void give_back() {
        if (ready_ < given_back_ + 2 * kept_behind) return;
        ::madvise(map_ + given_back_, kept_behind, MADV_DONTNEED);
        given_back_ += kept_behind;
    }

    void leave(std::size_t offset) override {
        if (const std::size_t behind = offset / kept_behind * kept_behind) ::madvise(map_, behind, MADV_DONTNEED);
    }

    int input_;
    std::string name_;
    int file_;
    char* map_;
    diag::Sink& out_;
    std::size_t size_ = 0;        ///< bytes in the file
    std::size_t skipped_ = 0;     ///< bytes of the block at hand that are not in the file
    std::size_t given_back_ = 0;  ///< a multiple of the page size
};

}  // namespace

std::unique_ptr<Text> text_of_stream(int descriptor, std::string name, diag::Sink& out) {
    const int file = open_temporary_file();
    void* map = file < 0 ? MAP_FAILED : ::mmap(nullptr, reserved, PROT_READ, MAP_SHARED | MAP_NORESERVE, file, 0);
    if (map == MAP_FAILED) {
        out.report(diag::Id::cannot_spool, diag::Place{}, std::strerror(errno));
        if (file >= 0) ::close(file);
        ::close(descriptor);
        return nullptr;
    }
    return std::make_unique<StreamText>(descriptor, std::move(name), file, static_cast<char*>(map), out);
}

}  // namespace fagorc::frontend
