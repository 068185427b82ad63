#include "frontend/structure/header.hpp"

namespace fagorc::frontend {
namespace {

constexpr std::size_t longest_comment = 20;

std::string_view trimmed(std::string_view s) {
    const std::size_t first = s.find_first_not_of(" \t"), last = s.find_last_not_of(" \t");
    return first == s.npos ? std::string_view{} : s.substr(first, last - first + 1);
}

}  // namespace

program::Header read_header(std::string_view line, bool& well_formed) {
    program::Header header;
    header.present = true;
    line.remove_prefix(1);
    const std::size_t first = line.find(',');
    const std::string_view comment = line.substr(0, first);
    header.comment = comment;
    const std::size_t second = first == line.npos ? line.npos : line.find(',', first + 1);
    well_formed = second != line.npos && comment.size() <= longest_comment;
    if (!well_formed) return header;
    program::Header read = header;
    read.modifiable = read.executable = false;
    for (char c : trimmed(line.substr(first + 1, second - first - 1))) {
        switch (c) {
            case 'O':
                read.oem = true;
                break;
            case 'H':
                read.hidden = true;
                break;
            case 'M':
                read.modifiable = true;
                break;
            case 'X':
                read.executable = true;
                break;
            case '-':
            case ' ':
                break;  // an attribute that is not set, as the control writes it
            default:
                well_formed = false;
        }
    }
    return well_formed ? read : header;
}

}  // namespace fagorc::frontend
