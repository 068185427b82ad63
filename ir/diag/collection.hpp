// Sinks between those who find something and those who print it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <utility>
#include <vector>

#include "ir/diag/catalogue.hpp"
#include "ir/diag/diagnostic.hpp"

namespace fagorc::diag {

/// How many findings of each severity.
struct Counts {
    std::array<std::uint64_t, 3> by_severity{};
    std::uint64_t of(Severity s) const { return by_severity[static_cast<std::size_t>(s)]; }
    std::uint64_t errors() const { return of(Severity::error); }
    std::uint64_t warnings() const { return of(Severity::warning); }
};

/// Whether the findings make a run fail (exit code 1): errors do, warnings when they are denied.
constexpr bool fails(const Counts& counts, bool deny_warnings) {
    return counts.by_severity[static_cast<std::size_t>(Severity::error)] > 0 ||
           (deny_warnings && counts.by_severity[static_cast<std::size_t>(Severity::warning)] > 0);
}

/// Counts findings and passes each on once: a loop that runs into the same finding at the same place a thousand times
/// reports it once. Findings without a place are all passed on. It remembers the last 65,536 findings or more, so that
/// a program of millions of errors takes no more memory than one of a few.
class Once final : public Sink {
  public:
    /// After `limit` findings the rest is counted, repeats included, and not passed on; 0: no limit.
    explicit Once(Sink& next, std::size_t limit = 0) : next_(next), limit_(limit) {}

    using Sink::report;
    void report(Diagnostic diagnostic) override;

    const Counts& counts() const { return counts_; }
    /// Findings beyond the limit.
    std::uint64_t left_out() const { return left_out_; }

  private:
    struct Key {
        Id id{};
        Place place;
        friend bool operator==(const Key&, const Key&) = default;
    };
    struct Hash {
        std::size_t operator()(const Key& key) const;
    };

    Sink& next_;
    std::size_t limit_;
    std::size_t passed_ = 0;
    std::uint64_t left_out_ = 0;
    Counts counts_;
    bool is_new(const Key& key);

    static constexpr std::size_t remembered = 65'536;
    std::unordered_set<Key, Hash> seen_, seen_before_;  ///< the latest ones; up to `remembered` before those
};

/// Keeps findings in the order of discovery.
class Collection final : public Sink {
  public:
    using Sink::report;
    void report(Diagnostic diagnostic) override { list_.push_back(std::move(diagnostic)); }
    const std::vector<Diagnostic>& list() const { return list_; }

  private:
    std::vector<Diagnostic> list_;
};

}  // namespace fagorc::diag
