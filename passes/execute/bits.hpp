// Operators on the 32 bits of a number: NOT AND OR XOR, BCD, BIN (8055 T 11.4).
// Between conditions (`logical`) the same operators are logical with 1 and 0. An unknown operand gives an unknown
// result, but where the other one decides: 0 AND anything is 0.
#pragma once

#include <optional>

namespace fagorc::passes::bits {

double not_(double a, bool logical);
double and_(double a, double b, bool logical);
double or_(double a, double b, bool logical);
double xor_(double a, double b, bool logical);

/// The number that the decimal digits denote as hexadecimal ones: 234 -> $234. Nothing for a negative number or one of
/// more than 8 digits.
std::optional<double> bcd(double a);
/// The inverse where every nibble is a decimal digit, else the 32 bits unchanged (BIN $AB is 171 in the manual).
double bin(double a);

}  // namespace fagorc::passes::bits
