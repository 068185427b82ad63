// G180 to G189, G380 to G399: calls of the global subroutine of the same number (8055 T 12.5.1).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

template <int number>
constexpr std::array<char, 4> spelling = {'G', char('0' + number / 100), char('0' + number / 10 % 10),
                                          char('0' + number % 10)};

template <int number>
constexpr Construct call() {
    constexpr std::string_view code(spelling<number>.data(), spelling<number>.size());
    return {.number = number,
            .code = code,
            .company = Company::alone,
            .takes = Takes::arguments,
            .syntax = "G180..G189, G380..G399 [P0..P25=value] [A..Z[=]value]",
            .snippet = "G180 A12.3 B=P100 P10=6",
            .section = "8055 T 12.5.1",
            .title = {"call of the global subroutine of this number", "appel de la sous-routine globale de ce numéro",
                      "llamada a la subrutina global de ese número"}};
}

template <int first, int... i>
constexpr std::array<Construct, sizeof...(i)> calls(std::integer_sequence<int, i...>) {
    return {call<first + i>()...};
}

}  // namespace

constexpr std::array<Construct, 10> g180_g189 = calls<180>(std::make_integer_sequence<int, 10>());
constexpr std::array<Construct, 20> g380_g399 = calls<380>(std::make_integer_sequence<int, 20>());

static_assert(well_formed(g180_g189[0]) && well_formed(g380_g399[19]));

}  // namespace fagorc::frontend::fagor8055
