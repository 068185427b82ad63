// Names of the enumerators of the tables in the reader's language, for the reference, hover and explain.
#pragma once

#include "ir/base/text.hpp"
#include "ir/control/construct.hpp"
#include "ir/control/dialect.hpp"
#include "ir/control/variable.hpp"

namespace fagorc::control {

/// What a value of this role is and its unit: "length, mm or inch".
Text describe(Role role);
/// The name of a modal group; empty for none.
Text describe(program::Group group);
/// What else may stand in the block; empty for any.
Text describe(Company company);
/// When an operand must be written; empty where it is optional.
Text describe(Need need);
/// Where the value of a variable comes from.
Text describe(Knowledge knowledge);
/// How far a range of parameters reaches.
Text describe(ParameterRange::Scope scope);

}  // namespace fagorc::control
