// The arithmetic parameters: six levels of locals and the globals (8055 T 11.2.1, language sheet 2 and 12.1).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "ir/control/dialect.hpp"

namespace fagorc::passes {

class Parameters {
  public:
    /// Start values by number; all others are 0.
    Parameters(const control::Dialect& dialect, const std::map<std::uint32_t, double>& start);

    /// The cell of parameter `number`; null for a number in no range (alarm 1052) or an OEM one outside an OEM program.
    double* find(std::uint32_t number) {
        if (number < local_count) return &locals_.back()[number];
        return find_global(number);
    }
    static constexpr std::uint32_t local_count = 26;
    bool oem_allowed = false;

    /// A new level of local parameters, all 0; false when the control's levels are used up (alarm 1054).
    bool enter();
    void leave();

  private:
    double* find_global(std::uint32_t number);

    const control::Dialect& dialect_;
    std::vector<std::array<double, local_count>> locals_;
    std::vector<double> globals_;    ///< all non-local ranges, one after the other
};

}  // namespace fagorc::passes
