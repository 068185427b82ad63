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
    /// A cell keeps its address until a level begins or ends.
    double* find(std::uint32_t number) {
        if (number < local_count) return &local_[number];
        if (number >= cells_.size()) return nullptr;
        const Access access = access_[number];
        return access == Access::open || (access == Access::oem && oem_allowed) ? &cells_[number] : nullptr;
    }
    static constexpr std::uint32_t local_count = 26;
    /// The program being executed has the attribute O.
    bool oem_allowed = false;
    /// True when `number` exists and only the attribute O is missing.
    bool is_oem(std::uint32_t number) const { return number < access_.size() && access_[number] == Access::oem; }

    /// A new level of local parameters, all 0; false when the control's levels are used up (alarm 1054).
    bool enter();
    void leave();

  private:
    enum class Access : std::uint8_t { none, open, oem };
    using Level = std::array<double, local_count>;
    std::size_t most_levels_;
    std::vector<Level> levels_;   ///< reserved: a level never moves
    double* local_;               ///< of the level in force
    std::vector<double> cells_;   ///< by number, gaps between the ranges included: looking up is one step
    std::vector<Access> access_;  ///< by number
};

}  // namespace fagorc::passes
