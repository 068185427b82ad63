// Statements of the 8055 T high-level language (8055 T chapter 12).
#include "frontend/controls/fagor8055/fagor8055.hpp"

namespace fagorc::frontend::fagor8055 {

std::span<const control::StatementRow> statements() {
    return {};
}

}  // namespace fagorc::frontend::fagor8055
