// docgen DOCS: writes, below the folder docs, the reference of each control in each language and the index of
// diagnostics. docgen --check DOCS: compares instead.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "frontend/controls/controls.hpp"
#include "tools/docgen/diagnostics.hpp"
#include "tools/docgen/reference.hpp"

namespace {

using namespace fagorc;
namespace fs = std::filesystem;

std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

bool write(const fs::path& path, const std::string& text) {
    std::ofstream out(path, std::ios::binary);
    return static_cast<bool>(out << text << std::flush);
}

/// True when the file is, or now is, what the tables say.
bool settle(const fs::path& path, const std::string& text, bool check) {
    if (!check) {
        if (write(path, text)) return true;
        fmt::print(stderr, "docgen: cannot write {}\n", path.string());
        return false;
    }
    if (read(path) == text) return true;
    fmt::print(stderr, "docgen: {} differs from the tables; run docgen docs\n", path.string());
    return false;
}

}  // namespace

int main(int argc, char** argv) {
    const bool check = argc == 3 && std::string_view(argv[1]) == "--check";
    if (argc != 2 && !check) {
        fmt::print(stderr, "usage: docgen [--check] DOCS\n");
        return 2;
    }
    constexpr std::pair<Language, std::string_view> languages[] = {
        {Language::english, "en"}, {Language::french, "fr"}, {Language::spanish, "es"}};
    const fs::path docs = argv[argc - 1];
    bool good = true;
    for (const control::Dialect* dialect : frontend::dialects())
        for (const auto& [language, suffix] : languages) {
            const fs::path file = docs / "reference" / fmt::format("{}.{}.md", dialect->name, suffix);
            good = settle(file, docgen::reference(*dialect, language), check) && good;
        }
    const fs::path index = docs / "diagnostics.md";
    good = settle(index, docgen::diagnostics(read(index)), check) && good;
    return good ? 0 : 1;
}
