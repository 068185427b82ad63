// Runs a fuzz target over files, and over cut and bent copies of them: what the CI does without a fuzzing compiler.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void run(const std::string& bytes) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

/// The file itself, its beginnings, and copies with one byte changed, at most some hundred in all.
void run_variants(const std::string& bytes) {
    run(bytes);
    const std::size_t step = std::max<std::size_t>(1, bytes.size() / 64);
    for (std::size_t at = 0; at < bytes.size(); at += step) {
        run(bytes.substr(0, at));
        for (const char c : {'\0', '(', 'G', '9', ' ', '\n', '\xA0'}) {
            std::string bent = bytes;
            bent[at] = c;
            run(bent);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::filesystem::path> files;
    for (int i = 1; i < argc; ++i) {
        if (!std::filesystem::is_directory(argv[i]))
            files.emplace_back(argv[i]);
        else
            for (const auto& entry : std::filesystem::directory_iterator(argv[i])) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
        std::ifstream in(file, std::ios::binary);
        run_variants(std::string(std::istreambuf_iterator<char>(in), {}));
    }
    std::printf("%zu files replayed\n", files.size());
    return files.empty() ? 1 : 0;
}
