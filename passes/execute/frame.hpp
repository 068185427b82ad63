// What runs inside something else: subroutines, sections, called programs, and what they are called with.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "ir/operation/context.hpp"
#include "ir/program/program.hpp"
#include "passes/execute/parameters.hpp"

namespace fagorc::passes {

/// Something that runs inside something else and goes back when it is done.
struct Frame {
    enum class Kind : std::uint8_t {
        subroutine,  ///< ends at RET
        section,     ///< of RPT: ends behind its last block
        program      ///< of EXEC: ends at M30, M02 or the end of its text
    };
    Kind kind = Kind::subroutine;
    bool own_level = false;       ///< it has local parameters of its own
    bool modal = false;           ///< started by a modal call, which rests meanwhile
    bool local = false;           ///< a local subroutine
    bool of_function = false;     ///< of an M or T function, or of G74
    std::uint32_t number = 0;     ///< of the subroutine
    std::uint32_t more_runs = 0;  ///< after the present one
    program::Cursor begin{};      ///< first block of each run
    std::uint64_t end = 0;        ///< section: offset behind its last block
    // What is in force again when it is done:
    program::Program* program = nullptr;
    program::Cursor call{}, back{};  ///< the block that started it, the one after it
    operation::ChainId chain{};
    std::uint16_t pass = 0;
    std::uint32_t call_parameters = 0;
};

/// Values for the local parameters of a subroutine, evaluated in the level of the caller.
struct Arguments {
    std::array<double, Parameters::local_count> value{};
    std::uint32_t given = 0;  ///< bit n: Pn has a value
    void set(std::uint32_t number, double v) {
        value[number] = v;
        given |= 1u << number;
    }
};

/// What MCALL or MEXEC left active: it runs after every block that moves an axis (8055 T 12.5, 12.8).
struct ModalCall {
    program::Program* program = nullptr;
    std::optional<program::Subroutine> subroutine;  ///< none: the whole program
    Arguments arguments;
};

}  // namespace fagorc::passes
