// G10 to G14: mirror image (8055 T 7.5).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using program::Mirror;

template <Axis axis>
constexpr auto mirror_of = +[]() -> program::Function {
    Mirror m;
    m.axes.set(axis, 0);
    return m;
};

constexpr Operand operands[] = {
    {.address = any_axis,
     .role = Role::axis_name,
     .need = Need::required,
     .slot = at<&Mirror::axes>,
     .text = {"axes to mirror", "axes à inverser", "ejes a los que se aplica la imagen espejo"}}};

constexpr Construct of_axis(std::uint16_t number, std::string_view code, Text title, program::Function (*make)()) {
    return {.number = number,
            .code = code,
            .lasts = true,
            .support = Support::planned,
            .syntax = code,
            .snippet = code,
            .section = "8055 T 7.5",
            .title = title,
            .make = make,
            .target = target_of<Mirror>};
}

}  // namespace

constexpr Construct g10 = of_axis(
    10, "G10", {"mirror image off", "annulation de l'image miroir", "anulación de imagen espejo"},
    +[]() -> program::Function { return Mirror{.axes = {}, .off = true}; });
constexpr Construct g11 =
    of_axis(11, "G11", {"mirror image on X", "image miroir sur X", "imagen espejo en X"}, mirror_of<Axis::X>);
constexpr Construct g12 =
    of_axis(12, "G12", {"mirror image on Y", "image miroir sur Y", "imagen espejo en Y"}, mirror_of<Axis::Y>);
constexpr Construct g13 =
    of_axis(13, "G13", {"mirror image on Z", "image miroir sur Z", "imagen espejo en Z"}, mirror_of<Axis::Z>);

constexpr Construct g14{.number = 14,
                        .code = "G14",
                        .lasts = true,
                        .support = Support::planned,
                        .company = Company::alone,
                        .takes = Takes::listed,
                        .syntax = "G14 axis...",
                        .snippet = "G14 X Z",
                        .section = "8055 T 7.5",
                        .title = {"mirror image on the axes named", "image miroir dans les directions programmées",
                                  "imagen espejo en las direcciones programadas"},
                        .operands = operands,
                        .make = makes<Mirror>,
                        .target = target_of<Mirror>,
                        .least_axes = 1};

static_assert(well_formed(g10) && well_formed(g11) && well_formed(g12) && well_formed(g13) && well_formed(g14));

}  // namespace fagorc::frontend::fagor8055
