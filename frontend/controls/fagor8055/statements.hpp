// The statements of the 8055 T by family; statements() of fagor8055.hpp joins them.
#pragma once

#include <span>

#include "ir/control/dialect.hpp"

namespace fagorc::frontend::fagor8055 {

std::span<const control::StatementRow> flow_statements();
std::span<const control::StatementRow> program_statements();
std::span<const control::StatementRow> probe_statements();
std::span<const control::StatementRow> screen_statements();

}  // namespace fagorc::frontend::fagor8055
