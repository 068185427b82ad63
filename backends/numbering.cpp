#include "backends/numbering.hpp"

#include <algorithm>

namespace fagorc::backends {
namespace {

/// The cell of an index; cells that do not exist yet hold no number.
std::uint32_t& cell(std::vector<std::uint32_t>& numbers, std::uint32_t index) {
    if (index >= numbers.size()) numbers.resize(std::size_t{index} + 1, no_number);
    return numbers[index];
}

}  // namespace

std::uint32_t NumberingSink::program_number(diag::FileId file) {
    if (file == diag::FileId::none) return no_number;
    const auto at = std::find(used_programs_.begin(), used_programs_.end(), file);
    const auto number = static_cast<std::uint32_t>(at - used_programs_.begin());
    if (at == used_programs_.end()) {
        used_programs_.push_back(file);
        new_program(number, file);
    }
    return number;
}

std::uint32_t NumberingSink::find_chain(operation::ChainId id) {
    const auto index = static_cast<std::uint32_t>(id);
    std::uint32_t number = cell(chain_numbers_, index);
    if (number == no_number) {
        const operation::Chain chain = job_.tables.chains[id];
        const std::uint32_t program = program_number(chain.program);
        const std::uint32_t caller = chain.caller_line == 0 ? no_number : find_chain(chain.caller);
        number = cell(chain_numbers_, index) = chains_++;
        new_chain(number, program, caller, chain.caller_line);
    }
    last_chain_ = id;
    return last_chain_number_ = number;
}

std::uint32_t NumberingSink::find_state(const Situation& wanted) {
    const auto begin = recent_.begin(), end = begin + static_cast<std::ptrdiff_t>(recent_count_);
    auto at = std::find_if(begin, end, [&](const Recent& r) { return r.situation == wanted; });
    // G00, G01 and arcs take turns: what stands near the front is found soon enough where it is.
    if (at - begin < near_front && at != end) return at->number;
    if (at == end) {
        if (recent_count_ < recent_states)
            ++recent_count_;
        else
            --at;
        *at = {wanted, states_++};
        new_state(at->number, wanted);
    }
    std::rotate(begin, at, at + 1);
    return recent_[0].number;
}

std::uint32_t NumberingSink::text_number(std::uint32_t index) {
    if (index == 0) return no_number;
    std::uint32_t& number = cell(text_numbers_, index);
    if (number == no_number) {
        number = texts_++;
        new_text(number, job_.texts[index]);
    }
    return number;
}

}  // namespace fagorc::backends
