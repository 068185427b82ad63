// The list of G and M codes of the 8055 T, in the order in which they are looked up.
#include <algorithm>
#include <array>
#include <iterator>

#include "frontend/controls/fagor8055/fagor8055.hpp"
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

constexpr const Construct* g_codes[] = {
    &g00, &g01, &g02, &g03, &g04, &g05, &g06, &g07, &g08, &g09, &g10, &g11, &g12,  &g13,  &g14,  &g15,  &g16,
    &g17, &g18, &g19, &g20, &g21, &g22, &g28, &g29, &g30, &g32, &g33, &g34, &g36,  &g37,  &g38,  &g39,  &g40,
    &g41, &g42, &g45, &g46, &g50, &g51, &g52, &g53, &g54, &g55, &g56, &g57, &g58,  &g59,  &g60,  &g61,  &g62,
    &g63, &g66, &g68, &g69, &g70, &g71, &g72, &g74, &g75, &g76, &g77, &g78, &g81,  &g82,  &g83,  &g84,  &g85,
    &g86, &g87, &g88, &g89, &g90, &g91, &g92, &g93, &g94, &g95, &g96, &g97, &g145, &g151, &g152, &g158, &g159};

constexpr const Construct* m_codes[] = {&m00, &m01, &m02, &m03, &m04, &m05, &m06, &m08,
                                        &m09, &m19, &m30, &m41, &m42, &m43, &m44, &m45};

constexpr auto table = [] {
    std::array<const Construct*, std::size(g_codes) + g180_g189.size() + 1 + g380_g399.size() + std::size(m_codes)>
        all{};
    auto at = std::copy(std::begin(g_codes), std::end(g_codes), all.begin());
    for (std::size_t i = 0; i < g180_g189.size(); ++i) *at++ = &g180_g189[i];
    *at++ = &g233;
    for (std::size_t i = 0; i < g380_g399.size(); ++i) *at++ = &g380_g399[i];
    std::copy(std::begin(m_codes), std::end(m_codes), at);
    return all;
}();

}  // namespace

std::span<const Construct* const> constructs() {
    return table;
}

}  // namespace fagorc::frontend::fagor8055
