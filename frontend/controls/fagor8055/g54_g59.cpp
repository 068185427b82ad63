// G54 to G59, G158, G159: zero offsets (8055 T 4.4.2).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using program::AbsoluteOrigin;
using program::IncrementalOrigin;

/// A code that stands for row `row` of the zero-offset table.
template <class Origin, int row>
constexpr auto row_of_table = +[]() -> program::Function { return Origin{double{row}}; };

constexpr Construct absolute(std::uint16_t number, std::string_view code, Text title, program::Function (*make)()) {
    return {.number = number,
            .code = code,
            .group = Group::origin,
            .company = Company::alone,
            .syntax = code,
            .snippet = code,
            .section = "8055 T 4.4.2",
            .title = title,
            .make = make,
            .target = target_of<AbsoluteOrigin>};
}

constexpr Construct incremental(std::uint16_t number, std::string_view code, Text title, program::Function (*make)()) {
    return {.number = number,
            .code = code,
            .group = Group::shift,
            .company = Company::alone,
            .syntax = code,
            .snippet = code,
            .section = "8055 T 4.4.2",
            .title = title,
            .make = make,
            .target = target_of<IncrementalOrigin>};
}

constexpr Operand shift_operands[] = {
    {.address = any_axis,
     .role = Role::coordinate,
     .slot = at<&program::OriginShift::axes>,
     .text = {"offset of the axis; 0 cancels it", "décalage de l'axe ; 0 l'annule", "decalaje del eje; 0 lo anula"}}};

constexpr Operand row_operands[] = {
    {.address = 'N',
     .role = Role::row,
     .need = Need::required,
     .range = {.least = 1, .most = 20, .whole = true},
     .slot = at<&AbsoluteOrigin::row>,
     .text = {"row of the zero-offset table", "ligne de la table de décalages d'origine",
              "número de decalaje en la tabla de orígenes"}}};

}  // namespace

constexpr Construct g54 =
    absolute(54, "G54", {"absolute zero offset 1", "décalage d'origine absolu 1", "decalaje de origen absoluto 1"},
             row_of_table<AbsoluteOrigin, 1>);
constexpr Construct g55 =
    absolute(55, "G55", {"absolute zero offset 2", "décalage d'origine absolu 2", "decalaje de origen absoluto 2"},
             row_of_table<AbsoluteOrigin, 2>);
constexpr Construct g56 =
    absolute(56, "G56", {"absolute zero offset 3", "décalage d'origine absolu 3", "decalaje de origen absoluto 3"},
             row_of_table<AbsoluteOrigin, 3>);
constexpr Construct g57 =
    absolute(57, "G57", {"absolute zero offset 4", "décalage d'origine absolu 4", "decalaje de origen absoluto 4"},
             row_of_table<AbsoluteOrigin, 4>);
constexpr Construct g58 = incremental(
    58, "G58", {"incremental zero offset 1", "décalage d'origine incrémental 1", "decalaje de origen incremental 1"},
    row_of_table<IncrementalOrigin, 5>);
constexpr Construct g59 = incremental(
    59, "G59", {"incremental zero offset 2", "décalage d'origine incrémental 2", "decalaje de origen incremental 2"},
    row_of_table<IncrementalOrigin, 6>);

constexpr Construct g158{.number = 158,
                         .code = "G158",
                         .group = Group::shift,
                         .company = Company::alone_expected,
                         .takes = Takes::listed,
                         .syntax = "G158 [X..C5.5]",
                         .snippet = "G158 Z-90",
                         .section = "8055 T 4.4.2",
                         .title = {"incremental zero offset by program", "décalage d'origine incrémental programmé",
                                   "decalaje de origen incremental programado"},
                         .operands = shift_operands,
                         .make = makes<program::OriginShift>,
                         .target = target_of<program::OriginShift>};

constexpr Construct g159{.number = 159,
                         .code = "G159",
                         .group = Group::origin,
                         .company = Company::alone,
                         .takes = Takes::listed,
                         .syntax = "G159 N1..20",
                         .snippet = "G159 N7",
                         .section = "8055 T 4.4.2",
                         .title = {"absolute zero offset by number", "décalage d'origine absolu par numéro",
                                   "decalaje de origen absoluto por número"},
                         .operands = row_operands,
                         .make = makes<AbsoluteOrigin>,
                         .target = target_of<AbsoluteOrigin>};

static_assert(well_formed(g54) && well_formed(g55) && well_formed(g56) && well_formed(g57) && well_formed(g58) &&
              well_formed(g59) && well_formed(g158) && well_formed(g159));

}  // namespace fagorc::frontend::fagor8055
