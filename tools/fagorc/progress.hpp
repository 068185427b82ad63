// A sign of life for long runs, on a terminal only.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>

#include "ir/operation/operation.hpp"

namespace fagorc::tool {

/// Counts operations on their way and, when the run takes seconds and standard error is a terminal, shows how many.
class Progress final : public operation::Sink {
  public:
    Progress(operation::Sink& next, bool shown) : next_(next), shown_(shown) {}
    void push(const operation::Operation& o) override {
        moves_ += operation::is_motion(o.what);
        next_.push(o);
        if ((++operations_ & mask) == 0 && shown_) show();
    }
    void finish() override {
        next_.finish();
        if (visible_) std::fputs("\r\033[K", stderr);
    }
    std::uint64_t moves() const { return moves_; }

  private:
    static constexpr std::uint64_t mask = (std::uint64_t{1} << 17) - 1;
    void show() {
        const auto now = std::chrono::steady_clock::now();
        if (now - start_ < std::chrono::seconds(2)) return;
        visible_ = true;
        std::fprintf(stderr, "\r%llu moves ...\033[K", static_cast<unsigned long long>(moves_));
    }

    operation::Sink& next_;
    bool shown_, visible_ = false;
    std::uint64_t moves_ = 0, operations_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace fagorc::tool
