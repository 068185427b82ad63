// G16 to G19: the active plane (8055 T 3.2).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using program::PlaneCode;

constexpr Operand operands[] = {{.address = any_axis,
                                 .role = Role::axis_name,
                                 .need = Need::required,
                                 .slot = at<&program::PlaneByAxes::axes>,
                                 .text = {"abscissa axis, then ordinate axis", "axe d'abscisses, puis axe d'ordonnées",
                                          "eje de abscisas y eje de ordenadas"}}};

}  // namespace

constexpr Construct g16{.number = 16,
                        .code = "G16",
                        .group = Group::plane,
                        .setting = setting(PlaneCode::by_axes),
                        .company = Company::alone,
                        .takes = Takes::listed,
                        .syntax = "G16 axis1 axis2",
                        .snippet = "G16 WX",
                        .section = "8055 T 3.2",
                        .title = {"plane by two axes", "plan défini par deux axes", "plano definido por dos ejes"},
                        .operands = operands,
                        .make = makes<program::PlaneByAxes>,
                        .target = target_of<program::PlaneByAxes>,
                        .least_axes = 2,
                        .most_axes = 2,
                        .misuse = diag::Id::plane_axes};

constexpr Construct g17{.number = 17,
                        .code = "G17",
                        .group = Group::plane,
                        .setting = setting(PlaneCode::xy),
                        .syntax = "G17",
                        .snippet = "G17",
                        .section = "8055 T 3.2",
                        .title = {"plane XY", "plan XY", "plano XY"}};

constexpr Construct g18{.number = 18,
                        .code = "G18",
                        .group = Group::plane,
                        .setting = setting(PlaneCode::zx),
                        .syntax = "G18",
                        .snippet = "G18",
                        .section = "8055 T 3.2",
                        .title = {"plane ZX", "plan ZX", "plano ZX"}};

constexpr Construct g19{.number = 19,
                        .code = "G19",
                        .group = Group::plane,
                        .setting = setting(PlaneCode::yz),
                        .syntax = "G19",
                        .snippet = "G19",
                        .section = "8055 T 3.2",
                        .title = {"plane YZ", "plan YZ", "plano YZ"}};

static_assert(well_formed(g16) && well_formed(g17) && well_formed(g18) && well_formed(g19));

}  // namespace fagorc::frontend::fagor8055
