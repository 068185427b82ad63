// The feed of a move as text outputs state it: F0 with the value that it stands for.
#pragma once

#include "backends/backend.hpp"
#include "ir/operation/position.hpp"

namespace fagorc::backends {

struct Feed {
    double value = 0;
    program::FeedMode unit{};
};

/// F0 is the highest feed of the machine (8055 T 5.2), in mm/min whatever the feed mode: the smallest MAXFEED of the
/// axes that the line or arc moves. `before`: where the tip stands before it.
double highest_feed(const Job& job, const operation::Position& before, const operation::Operation& o);

/// The feed of a line or an arc.
inline Feed feed_of(const Job& job, const operation::Position& before, const operation::Operation& o) {
    if (o.at.feed == 0) return {highest_feed(job, before, o), program::FeedMode::per_minute};
    return {o.at.feed, job.tables.states[o.at.state].modal.feed};
}

}  // namespace fagorc::backends
