// Between the passes and the output: how far the run is, and whether it is worth going on.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>

#include "backends/output.hpp"
#include "ir/operation/operation.hpp"

namespace fagorc::tool {

/// Counts operations on their way. When the run takes seconds and `shown` (standard error is a terminal), it tells how
/// many moves there are. When the output has failed, it asks for a stop.
class Progress final : public operation::Sink {
  public:
    /// `output`: where `next` writes; null where nothing is written.
    Progress(operation::Sink& next, const backends::Output* output, bool shown)
        : next_(next), output_(output), shown_(shown) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() override {
        if (visible_) std::fputs("\033[K", stderr);
    }
    void push(const operation::Operation& o) override {
        moves_ += operation::is_motion(o.what);
        next_.push(o);
        if ((++operations_ & mask) == 0) look();
    }
    void finish() override { next_.finish(); }

    std::uint64_t moves() const { return moves_; }
    /// Becomes true when the output has failed (passes::ExecuteOptions::stop).
    const bool* stop() const { return &stop_; }

  private:
    static constexpr std::uint64_t mask = (std::uint64_t{1} << 12) - 1;
    void look() {
        stop_ = output_ && output_->failure();
        const auto now = std::chrono::steady_clock::now();
        if (!shown_ || now < next_show_) return;
        next_show_ = now + std::chrono::milliseconds(200);
        visible_ = true;
        // The cursor goes back to the start of the line, so that a finding is written over it.
        std::fprintf(stderr, "%llu moves ...\033[K\r", static_cast<unsigned long long>(moves_));
    }

    operation::Sink& next_;
    const backends::Output* output_;
    bool shown_, visible_ = false, stop_ = false;
    std::uint64_t moves_ = 0, operations_ = 0;
    std::chrono::steady_clock::time_point next_show_ = std::chrono::steady_clock::now() + std::chrono::seconds(2);
};

}  // namespace fagorc::tool
