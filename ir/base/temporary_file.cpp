#include "ir/base/temporary_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>

namespace fagorc {

std::string temporary_folder() {
    const char* folder = std::getenv("TMPDIR");
    return folder && *folder ? folder : "/tmp";
}

int open_temporary_file() {
    std::string name = temporary_folder() + "/fagorc-XXXXXX";
    const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
    if (descriptor >= 0) ::unlink(name.c_str());
    return descriptor;
}

}  // namespace fagorc
