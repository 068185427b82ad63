// A file without a name, for bytes that must wait: it is gone when its descriptor is closed, however the process ends.
#pragma once

#include <string>

namespace fagorc {

/// The folder of temporary files: TMPDIR, else /tmp.
std::string temporary_folder();
/// An empty file in that folder, open for reading and writing, already unlinked. Negative where none can be made:
/// errno.
int open_temporary_file();

}  // namespace fagorc
