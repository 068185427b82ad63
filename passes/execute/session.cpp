// The parameters that a block names.
#include "passes/execute/session.hpp"

namespace fagorc::passes {

void Session::parameter_missing(double number, std::uint32_t first, std::uint32_t end) {
    const auto whole = whole_number(number);
    if (whole && parameters.is_oem(*whole)) {
        report(diag::Id::oem_parameter, first, end, number);
    } else if (number != std::trunc(number)) {
        report(diag::Id::decimals_not_allowed, first, end, 'P', number);
    } else {
        report(diag::Id::parameter_does_not_exist, first, end, number);
    }
}

}  // namespace fagorc::passes
