// The programs that the measurements read; tests/bench/end_to_end.py has the same ones.
#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

namespace fagorc::bench {

/// `N.. G1 X.. Z.. F..`, one line a block.
inline std::string lines(int blocks) {
    std::string text;
    for (int i = 0; i < blocks; ++i)
        text += fmt::format("N{} G1 X{:.4f} Z-{:.4f} F{:.1f}\n", i, 20 + i % 997 * 0.0101, i % 991 * 0.1007,
                            100 + i % 7 * 12.5);
    return text;
}

/// In turn: a line, a quarter to the right, a line, a quarter to the left.
inline std::string arcs(int blocks) {
    std::string text;
    for (int i = 0; i < blocks; ++i) {
        const double d = i / 4 % 1000 / 1000.0, x = 20 + d, z = -20 - d;
        switch (i % 4) {
            case 0:
                text += fmt::format("N{} G1 X{:.3f} Z{:.3f} F{}\n", i, x, z, 100 + i % 7);
                break;
            case 1:
                text += fmt::format("N{} G2 X{:.3f} Z{:.3f} I2.000 K0.000\n", i, x + 2, z - 2);
                break;
            case 2:
                text += fmt::format("N{} G1 X{:.3f} Z{:.3f} F{}\n", i, x + 4, z - 5, 200 + i % 7);
                break;
            default:
                text += fmt::format("N{} G3 X{:.3f} Z{:.3f} I0.000 K-2.000\n", i, x + 6, z - 7);
        }
    }
    return text;
}

/// The assignments of a point of `loop`, in one block.
inline constexpr std::string_view assignments = "P1=P0*0.1,P2=SIN P1,P3=P2*10,P4=20+P3,P5=0-P0/1000,P0=P0+1";

/// Per point six assignments, each a block of its own or all in one, a move and a jump.
inline std::string loop(int points, bool joined) {
    std::string body(assignments);
    if (!joined)
        for (std::size_t at = 0; (at = body.find(',', at)) != std::string::npos; at += 3) body.replace(at, 1, ")\n(");
    return fmt::format("(P0=0)\nN10 ({})\nG1 XP4 ZP5 F200\n(IF P0 LT {} GOTO N10)\n", body, points);
}

/// A program that can be executed: radii and a place to start from, the blocks, the end.
inline std::string whole(const std::string& blocks) {
    return "G152\nG18 G90 G94 G1 X20 Z0 F100\n" + blocks + "M30\n";
}

}  // namespace fagorc::bench
