#include "frontend/controls/fagor8055/statements.hpp"

#include <vector>

#include "frontend/controls/fagor8055/fagor8055.hpp"

namespace fagorc::frontend::fagor8055 {

std::span<const control::StatementRow> statements() {
    static const std::vector<control::StatementRow> all = [] {
        std::vector<control::StatementRow> joined;
        for (const auto family : {flow_statements(), program_statements(), probe_statements(), screen_statements()})
            joined.insert(joined.end(), family.begin(), family.end());
        return joined;
    }();
    return all;
}

}  // namespace fagorc::frontend::fagor8055
