// The variables of the 8055 T (8055 T 11.2): the rows of variables.tsv as an array.
#include "frontend/controls/fagor8055/fagor8055.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using control::IndexForm;
using control::Knowledge;
using control::Role;
using control::Support;

constexpr control::Variable table[] = {
#include "variables_8055.inc"
};

consteval bool well_formed() {
    for (const control::Variable& v : table) {
        if (v.name.empty() || !v.title.complete() || v.least_index > v.most_index) return false;
        for (const control::Variable& w : table)
            if (&v != &w && v.name == w.name && v.per_axis == w.per_axis) return false;
    }
    return true;
}
static_assert(well_formed());

}  // namespace

std::span<const control::Variable> variables() {
    return table;
}

}  // namespace fagorc::frontend::fagor8055
