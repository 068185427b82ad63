#include "ir/diag/explain.hpp"

#include <algorithm>
#include <iterator>

#include "ir/diag/catalogue.hpp"

namespace fagorc::diag {
namespace {

struct Page {
    std::string_view code, text;
};

constexpr Page pages[] = {
#include "explain_pages.inc"
};

std::string_view text_of(Id id) {
    const auto* at = std::lower_bound(std::begin(pages), std::end(pages), row(id).code,
                                      [](const Page& p, std::string_view code) { return p.code < code; });
    return at != std::end(pages) && at->code == row(id).code ? at->text : std::string_view{};
}

/// What stands under the heading `## name`, up to the next one.
std::string_view section(std::string_view page, std::string_view name) {
    constexpr std::string_view mark = "## ";
    for (std::size_t at = page.find(mark); at != page.npos; at = page.find(mark, at + 1)) {
        const std::size_t line_end = page.find('\n', at);
        if (line_end == page.npos || page.substr(at + mark.size(), line_end - at - mark.size()) != name) continue;
        const std::size_t next = page.find("\n## ", line_end);
        return page.substr(line_end + 1, next == page.npos ? page.npos : next - line_end);
    }
    return {};
}

constexpr std::string_view examples_heading = "examples";

}  // namespace

std::string_view explain_page(Id id, Language language) {
    static constexpr Text headings{"en", "fr", "es"};
    return section(text_of(id), headings.in(language));
}

Examples explain_examples_kind(Id id) {
    const std::string_view text = section(text_of(id), examples_heading);
    if (text.find("example: none") != text.npos) return Examples::none;
    return text.find("example: planned") != text.npos ? Examples::planned : Examples::shown;
}

std::vector<std::string_view> explain_examples(Id id) {
    constexpr std::string_view fence = "```\n";
    std::vector<std::string_view> programs;
    std::string_view text = section(text_of(id), examples_heading);
    for (std::size_t open = text.find(fence); open != text.npos; open = text.find(fence)) {
        text.remove_prefix(open + fence.size());
        const std::size_t close = text.find(fence);
        programs.push_back(text.substr(0, close));
        if (close == text.npos) break;
        text.remove_prefix(close + fence.size());
    }
    return programs;
}

}  // namespace fagorc::diag
