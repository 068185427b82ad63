// The programs that the measurements read.
#pragma once

#include <string>

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

}  // namespace fagorc::bench
