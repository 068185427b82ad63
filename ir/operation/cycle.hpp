// Canned cycles as neutral operations: one struct a kind of cycle, whatever letters a control spells it with.
#pragma once

namespace fagorc::operation {

struct ContourRepeat {};
struct StockRemoval {};
struct Turning {};
struct PeckDrilling {};
struct Threading {};
struct Grooving {};
struct LiveDrilling {};
struct Keyway {};

}  // namespace fagorc::operation
