// The arithmetic parameters: six levels of locals and the globals (8055 T 11.2.1, 12.5).
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
    double* find(std::uint32_t number) { return number < size_ ? cell_of_[number] : nullptr; }
    static constexpr std::uint32_t local_count = 26;
    /// The program being executed has the attribute O, or has it not.
    void allow_oem(bool allowed);
    /// True when `number` exists for programs with the attribute O.
    bool is_oem(std::uint32_t number) const;

    /// A new level of local parameters, all 0; false when the control's levels are used up (alarm 1054).
    bool enter();
    void leave();

  private:
    void place_locals();

    using Level = std::array<double, local_count>;
    const control::Dialect& dialect_;
    std::size_t most_levels_;
    bool oem_allowed_ = false;
    std::uint32_t size_ = 0;
    std::vector<double*> cell_of_;  ///< by number, null in the gaps: looking up is one step
    std::vector<Level> levels_;     ///< reserved: a level never moves
    std::vector<double> globals_;   ///< by number, gaps included
};

}  // namespace fagorc::passes
