// Reading numbers: correctly rounded, blanks without meaning, digits counted for format checks (8055 T 2, 11.3).
#include "frontend/scan/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

namespace fagorc::frontend {
namespace {

struct Read {
    program::Quantity q;
    std::size_t length = 0;
};

Read read(const std::string& text, bool negative = false) {
    Read r;
    r.length = static_cast<std::size_t>(read_quantity(text.c_str(), negative, r.q) - text.c_str());
    return r;
}

TEST(Quantity, CountsDigitsAroundThePoint) {
    struct Case {
        const char* text;
        double value;
        int integer, decimals;
        std::size_t length;
    };
    const Case cases[] = {
        {"30\n", 30, 2, 0, 2},
        {"100.\n", 100, 3, 0, 4},
        {".5\n", .5, 0, 1, 2},
        {"0012.50\n", 12.5, 2, 2, 7},
        {"0\n", 0, 0, 0, 1},
        {"000\n", 0, 0, 0, 3},
        {"0.0001\n", 0.0001, 0, 4, 6},
        {"1.2.3\n", 1.2, 1, 1, 3},
        {"12X\n", 12, 2, 0, 2},
        {"2.20\n", 2.2, 1, 2, 4},
        {"99999999\n", 99999999, 8, 0, 8},
    };
    for (const Case& c : cases) {
        const Read r = read(c.text);
        EXPECT_EQ(r.q.value, c.value) << c.text;
        EXPECT_EQ(r.q.integer_digits, c.integer) << c.text;
        EXPECT_EQ(r.q.decimals, c.decimals) << c.text;
        EXPECT_EQ(r.length, c.length) << c.text;
    }
}

TEST(Quantity, BlanksInsideMeanNothingAndBlanksBehindAreLeft) {
    EXPECT_EQ(read("3 0 X\n").q.value, 30);
    EXPECT_EQ(read("3 0 X\n").length, 3u);
    EXPECT_EQ(read("1\t. 2 5;\n").q.value, 1.25);
    EXPECT_EQ(read("1\t. 2 5;\n").q.decimals, 2);
    EXPECT_EQ(read(". 5\n").q.value, 0.5);
    EXPECT_EQ(read("7.5 .2\n").length, 3u) << "a second point begins something else";
}

TEST(Quantity, APointAloneIsNoNumber) {
    EXPECT_EQ(read(".\n").length, 0u);
    EXPECT_EQ(read(". X\n").length, 0u);
    EXPECT_EQ(read("X\n").length, 0u);
}

TEST(Quantity, TakesTheSignThatItIsTold) {
    EXPECT_EQ(read("45.678\n", true).q.value, -45.678);
    EXPECT_FALSE(std::signbit(read("0.00\n", true).q.value)) << "minus nothing is nothing";
}

TEST(Quantity, CountsSaturate) {
    const Read r = read(std::string(300, '9') + "." + std::string(200, '1') + "\n");
    EXPECT_EQ(r.q.integer_digits, 255);
    EXPECT_EQ(r.q.decimals, 127);
    EXPECT_EQ(r.length, 501u);
}

// The C library rounds correctly, so strtod of the digits without blanks is the truth for any number.
TEST(Quantity, RoundsAsTheCLibrary) {
    std::mt19937 random(8055);
    const auto below = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
    for (int i = 0; i < 50'000; ++i) {
        std::string digits, spaced;
        const unsigned integer = below(12), decimals = below(12);
        for (unsigned k = 0; k < integer; ++k) digits += static_cast<char>('0' + below(10));
        if (below(4)) digits += '.';
        const bool point = !digits.empty() && digits.back() == '.';
        if (point || digits.empty())
            for (unsigned k = 0; k < decimals; ++k) digits += static_cast<char>('0' + below(10));
        if (digits.find_first_of("0123456789") == std::string::npos) continue;
        for (char c : digits) {
            spaced += c;
            if (below(16) == 0) spaced += ' ';
        }
        const std::size_t length = spaced.find_last_not_of(' ') + 1;
        const Read r = read(spaced + "F1\n");
        ASSERT_EQ(r.q.value, std::strtod(digits.c_str(), nullptr)) << spaced;
        ASSERT_EQ(r.length, length) << spaced;
    }
}

}  // namespace
}  // namespace fagorc::frontend
