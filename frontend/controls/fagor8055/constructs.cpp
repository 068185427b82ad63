// The list of G and M codes of the 8055 T, in the order in which they are looked up.
#include "frontend/controls/fagor8055/fagor8055.hpp"
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

constexpr const Construct* table[] = {&g00,  &g01,  &g02,  &g03,  &g04, &g05, &g06, &g07, &g08, &g09, &g16, &g17,
                                      &g18,  &g19,  &g33,  &g40,  &g50, &g51, &g53, &g54, &g55, &g56, &g57, &g58,
                                      &g59,  &g70,  &g71,  &g74,  &g90, &g91, &g92, &g93, &g94, &g95, &g96, &g97,
                                      &g151, &g152, &g158, &g159, &m00, &m01, &m02, &m03, &m04, &m05, &m06, &m08,
                                      &m09,  &m19,  &m30,  &m41,  &m42, &m43, &m44, &m45};

}  // namespace

std::span<const Construct* const> constructs() {
    return table;
}

}  // namespace fagorc::frontend::fagor8055
