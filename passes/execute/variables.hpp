// Reads and writes the variables of the control (8055 T 11.2): tables, the program's own state, and what only the
// running machine knows.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "passes/execute/iso.hpp"
#include "passes/execute/session.hpp"
#include "passes/execute/tables.hpp"

namespace fagorc::passes {

class Variables {
  public:
    Variables(Session& session, IsoRunner& iso);

    /// The value in active units; unknown where `check` goes on without a live value. Reports what is refused.
    /// `payload` is that of the variable's token, `index` its element where it has one.
    double read(std::uint16_t payload, std::optional<double> index, std::uint16_t token);
    /// Stores a value given in active units.
    void write(std::uint16_t payload, std::optional<double> index, double value, std::uint16_t token);
    /// GPOS: the coordinate programmed in a labelled block of a program (8055 T 11.2.7).
    double position(std::uint16_t payload, double label, double program, std::uint16_t token);
    /// IBn: the value that an operator gave.
    double entry(double number, std::uint16_t token);

    /// CALLP: bit n is set when the call in force gave a value to Pn (8055 T 11.2.14).
    std::uint32_t call_parameters = 0;
    /// Reads and writes so far: a loop in which it stands still goes on for ever.
    std::uint64_t uses = 0;

  private:
    struct Access {
        const control::Variable* row = nullptr;
        int axis = -1;
        std::optional<long> index;
        const TableColumn* column = nullptr;
        bool unknown_index = false;
    };
    std::optional<Access> open(std::uint16_t payload, std::optional<double> index, std::uint16_t token);
    bool check_index(Access& access, double index, std::uint16_t token);
    std::string name(const Access& access) const;
    double live(std::string full_name, std::uint16_t token);
    bool fits(const Access& access, double value, std::uint16_t token);
    static Axis axis_or_x(const Access& access);
    /// Millimetres (or degrees) of one unit in which the program reads and writes.
    double unit(const Access& access) const;
    double unsupported(const Access& access, std::uint16_t token);

    Session& session_;
    IsoRunner& iso_;
    std::vector<const TableColumn*> columns_;             ///< by row of the control's table
    std::map<std::string, double, std::less<>> written_;  ///< what the program wrote, where no table holds it
};

}  // namespace fagorc::passes
