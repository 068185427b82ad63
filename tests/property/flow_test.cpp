// Random programs of plain blocks, loops, repeated sections and calls make the moves that unrolling them by hand makes,
// with the shape cache and the cache of decoded blocks on and off.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "tests/unit/passes/run_program.hpp"

namespace fagorc {
namespace {

/// A program and what it must do: where Z stands after each of its moves, which are increments of whole millimetres.
class Generator {
  public:
    explicit Generator(std::uint32_t seed) : random_(seed) {}

    std::string program() {
        std::string main = "G91 G01 F100\n";
        for (int n = 0; n < 8; ++n) main += piece(0);
        return main + "M30\n" + subroutines_;
    }
    /// Z after each move.
    std::vector<std::string> moves() const {
        std::vector<std::string> out;
        long at = 0;
        for (int step : steps_) out.push_back("0 " + std::to_string(at += step));
        return out;
    }

  private:
    unsigned below(unsigned n) { return static_cast<unsigned>(random_() % n); }
    std::string label() { return "N" + std::to_string(next_label_++); }

    /// Text that makes some moves; they are added to `steps_` in the order in which the control makes them.
    std::string piece(int depth) {
        switch (depth < 3 ? below(6) : 0) {
            case 1:
                return counted_loop(depth);
            case 2:
                return repeated_section(depth);
            case 3:
                return call(depth);
            case 4:
                return call_with_parameters();
            case 5:
                return alternative(depth);
            default:
                return move();
        }
    }

    std::string move() {
        const int step = static_cast<int>(below(19)) - 9;
        steps_.push_back(step == 0 ? 1 : step);
        static const char* const before[] = {"", "G1", "G01 ", "N5 "};
        return before[below(4)] + ("Z" + std::to_string(steps_.back())) + (below(2) ? " F200\n" : " ; a move\n");
    }

    /// Repeats the moves that were added since `first` until they are there `times` times.
    void unroll(std::size_t first, unsigned times) {
        const std::vector<int> once(steps_.begin() + static_cast<std::ptrdiff_t>(first), steps_.end());
        for (unsigned n = 1; n < times; ++n) steps_.insert(steps_.end(), once.begin(), once.end());
    }

    std::string counted_loop(int depth) {
        const std::string counter = "P" + std::to_string(next_counter_++), start = label();
        const unsigned times = 1 + below(4);
        const std::size_t first = steps_.size();
        std::string text =
            "(" + counter + "=0)\n" + start + " (" + counter + "=" + counter + "+1)\n" + piece(depth + 1);
        unroll(first, times);
        return text + "(IF " + counter + " LT " + std::to_string(times) + " GOTO " + start + ")\n";
    }

    /// In line once and then `times` times more.
    std::string repeated_section(int depth) {
        const std::string from = label(), to = label();
        const unsigned times = 1 + below(3);
        const std::size_t first = steps_.size();
        std::string text = from + " (MSG \"section\")\n" + piece(depth + 1) + to + " (P299=P299+1)\n";
        unroll(first, times + 1);
        return text + "(RPT " + from + ", " + to + ") N" + std::to_string(times) + "\n";
    }

    std::string call(int depth) {
        const unsigned number = next_subroutine_++, times = 1 + below(3);
        const std::size_t first = steps_.size();
        const std::string body = piece(depth + 1);
        unroll(first, times);
        subroutines_ += "(SUB " + std::to_string(number) + ")\n" + body + "(RET)\n";
        return "(CALL " + std::to_string(number) + ") N" + std::to_string(times) + "\n";
    }

    std::string call_with_parameters() {
        const unsigned number = next_subroutine_++;
        const int a = 1 + static_cast<int>(below(9)), b = 1 + static_cast<int>(below(9));
        steps_.push_back(a * b);
        steps_.push_back(-b);
        subroutines_ += "(SUB " + std::to_string(number) + ")\n(P2=P0*P1)\nZP2\nZ-P1\n(RET)\n";
        return "(PCALL " + std::to_string(number) + ", A" + std::to_string(a) + ", P1=" + std::to_string(b) + ")\n";
    }

    /// One side of a condition is jumped over.
    std::string alternative(int depth) {
        const std::string end = label();
        const std::size_t first = steps_.size();
        const std::string skipped = piece(depth + 1);
        steps_.resize(first);
        return "(IF 2 GT 1 GOTO " + end + ")\n" + skipped + end + " (P299=0)\n" + piece(depth + 1);
    }

    std::mt19937 random_;
    std::vector<int> steps_;
    std::string subroutines_;
    unsigned next_label_ = 100, next_counter_ = 100, next_subroutine_ = 1;
};

TEST(Flow, IsTheUnrolledProgramWithAnyCaches) {
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        Generator generator(seed);
        const std::string program = generator.program();
        for (const bool shapes : {false, true})
            for (const bool loops : {false, true}) {
                passes::RunOptions options;
                options.caches = {shapes, loops};
                const passes::ProgramRun run = passes::run_program(program, options);
                ASSERT_EQ(run.errors(), "") << program;
                ASSERT_EQ(run.moves(), generator.moves())
                    << program << "shape cache " << shapes << ", loop cache " << loops;
                EXPECT_TRUE(run.result.completed) << program;
                EXPECT_EQ(run.statistics.shapes, run.statistics.parser_calls) << program;
            }
    }
}

TEST(Flow, OneParseAShape) {
    // Four shapes: the first block, the move, M30, and the move without F.
    std::string program = "G91 G01 F100\n";
    for (int n = 1; n < 1000; ++n) program += "N" + std::to_string(n) + " Z" + std::to_string(n) + " F200\nZ-1\n";
    const passes::ProgramRun run = passes::run_program(program + "M30\n");
    EXPECT_EQ(run.statistics.shapes, 4u);
    EXPECT_EQ(run.statistics.parser_calls, 4u);
}

}  // namespace
}  // namespace fagorc
