// The floor: how fast this machine maps a text and reads its letters and numbers, when nothing is done with them.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <charconv>
#include <cstdio>

int main(int argc, char** argv) {
    if (argc != 2) return std::fputs("usage: bench_floor FILE\n", stderr), 2;
    const int fd = ::open(argv[1], O_RDONLY | O_CLOEXEC);
    struct stat status {};
    if (fd < 0 || ::fstat(fd, &status) != 0) return std::perror(argv[1]), 2;
    const auto size = static_cast<std::size_t>(status.st_size);
    void* const map = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, fd, 0);
    if (map == MAP_FAILED) return std::perror(argv[1]), 2;

    const char* p = static_cast<const char*>(map);
    const char* const end = p + size;
    unsigned long letters = 0;
    double sum = 0;
    while (p < end) {
        if (*p >= 'A' && *p <= 'Z') {
            ++letters;
            ++p;
            double value = 0;
            const auto [behind, error] = std::from_chars(p, end, value);
            if (error == std::errc{}) {
                sum += value;
                p = behind;
            }
        } else {
            ++p;
        }
    }
    std::printf("%lu letters, sum %g\n", letters, sum);
}
