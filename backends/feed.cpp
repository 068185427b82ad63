#include "backends/feed.hpp"

#include <algorithm>
#include <limits>

namespace fagorc::backends {

double highest_feed(const Job& job, const operation::Position& before, const operation::Operation& o) {
    AxisSet moving;
    if (const auto* line = std::get_if<operation::Line>(&o.what)) {
        operation::Position after = before;
        after.move(o, line->end);
        for (Axis a : all_axes)
            if (after.axes()[a] != before.axes()[a]) moving.add(a);
    }
    if (moving.empty()) {  // an arc moves both axes of its plane
        moving = o.moved;
        moving.add(before.plane().u);
        moving.add(before.plane().v);
    }
    double feed = std::numeric_limits<double>::infinity();
    for (Axis a : all_axes)
        if (moving.has(a)) feed = std::min(feed, job.machine.axes[a].max_feed);
    return feed;
}

}  // namespace fagorc::backends
