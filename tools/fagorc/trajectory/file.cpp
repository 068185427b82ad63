#include "tools/fagorc/trajectory/file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace fagorc::tool {

FileBytes::~FileBytes() {
    if (mapped_) ::munmap(mapped_, bytes_.size());
}

bool FileBytes::open(const std::string& path, diag::Sink& out) {
    const bool standard_input = path == "-";
    const int descriptor = standard_input ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status {};
    bool good = descriptor >= 0 && ::fstat(descriptor, &status) == 0;
    if (good && S_ISDIR(status.st_mode)) {
        out.report(diag::Id::is_a_directory, {}, path);
        ::close(descriptor);
        return false;
    }
    const auto size = static_cast<std::size_t>(status.st_size);
    if (good && S_ISREG(status.st_mode) && size > 0) {
        void* address = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
        if (address != MAP_FAILED) {
            mapped_ = address;
            bytes_ = {static_cast<const std::byte*>(address), size};
        }
    }
    good = good && (mapped_ || read(descriptor));
    if (!good) out.report(diag::Id::cannot_read, {}, path, std::generic_category().message(errno));
    if (descriptor > STDIN_FILENO) ::close(descriptor);
    return good;
}

bool FileBytes::read(int descriptor) {
    constexpr std::size_t piece = 1 << 16;
    for (std::size_t used = 0;;) {
        buffer_.resize(used + piece);
        const ssize_t got = ::read(descriptor, buffer_.data() + used, piece);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return false;
        used += static_cast<std::size_t>(got);
        if (got == 0) {
            buffer_.resize(used);
            bytes_ = buffer_;
            return true;
        }
    }
}

}  // namespace fagorc::tool
