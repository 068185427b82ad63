#include "ir/diag/diagnostic.hpp"

#include <fmt/format.h>

namespace fagorc::diag {

Argument::Argument(double value) : plain(fmt::format("{}", value)) {}

}  // namespace fagorc::diag
