// The constructs of the 8055 T, each defined in the file of its family (g04.cpp, g16_g19.cpp ...).
#pragma once

#include <array>

#include "ir/control/construct.hpp"

namespace fagorc::frontend::fagor8055 {

using control::any_axis;
using control::at;
using control::Company;
using control::Construct;
using control::makes;
using control::named;
using control::Need;
using control::Operand;
using control::Role;
using control::Support;
using control::Takes;
using control::target_of;
using control::well_formed;
using program::Group;

/// `setting` of a row: an enumerator of program/modal.hpp.
template <class E>
constexpr std::uint8_t setting(E e) {
    return static_cast<std::uint8_t>(e);
}

extern const Construct g00, g01, g02, g03;                           // path
extern const Construct g04;                                          // dwell, stop of block preparation
extern const Construct g05, g07, g50, g51;                           // corners
extern const Construct g06, g08, g09;                                // other arcs
extern const Construct g10, g11, g12, g13, g14;                      // mirror image
extern const Construct g15;                                          // C axis
extern const Construct g16, g17, g18, g19;                           // planes
extern const Construct g20, g21, g22;                                // work zones
extern const Construct g28, g29, g30;                                // spindles, swapped axes
extern const Construct g32;                                          // inverse-time feed
extern const Construct g33, g34, g233;                               // threads
extern const Construct g36, g37, g38, g39;                           // corner functions
extern const Construct g40, g41, g42;                                // radius compensation
extern const Construct g45, g145;                                    // tangential control
extern const Construct g46;                                          // inclined axis
extern const Construct g52;                                          // hard stop
extern const Construct g53;                                          // machine coordinates
extern const Construct g54, g55, g56, g57, g58, g59, g158, g159;     // zero offsets
extern const Construct g60, g61, g62, g63;                           // cycles with a driven tool
extern const Construct g66, g68, g69;                                // profile cycles
extern const Construct g70, g71, g90, g91, g151, g152;               // how coordinates are written
extern const Construct g72;                                          // scale
extern const Construct g74;                                          // home search
extern const Construct g75, g76;                                     // probing
extern const Construct g77, g78;                                     // coupled axes
extern const Construct g81, g82, g83, g84, g85, g86, g87, g88, g89;  // turning cycles
extern const Construct g92, g93;                                     // preset, polar origin
extern const Construct g94, g95, g96, g97;                           // feed and speed
extern const std::array<Construct, 10> g180_g189;                    // subroutine calls
extern const std::array<Construct, 20> g380_g399;
extern const Construct m00, m01, m02, m30, m03, m04, m05, m06, m08, m09, m19, m41, m42, m43, m44, m45;

}  // namespace fagorc::frontend::fagor8055
