// What neutral ISO cannot say.
#pragma once

#include <array>
#include <cstdint>

#include "ir/base/text.hpp"

namespace fagorc::backends::iso {

enum class Refusal : std::uint8_t {
    arc_plane,
    arc_start,
    thread_angle,
    thread_without_spindle,
    no_speed,
    second_spindle,
    count_
};

inline constexpr std::size_t refusal_count = static_cast<std::size_t>(Refusal::count_);

inline constexpr std::array<Text, refusal_count> refusal_texts = {{
    {"an arc in a plane that is not XY, ZX or YZ", "un arc dans un plan autre que XY, ZX ou YZ",
     "un arco en un plano que no es XY, ZX ni YZ"},
    {"an arc right after the tool offset has moved its start",
     "un arc juste après que le correcteur a déplacé son départ",
     "un arco justo después de que el corrector ha movido su comienzo"},
    {"a thread that starts at a spindle angle", "un filetage qui commence à un angle de la broche",
     "una rosca que empieza en un ángulo del cabezal"},
    {"a thread while the spindle stands", "un filetage, broche arrêtée", "una rosca con el cabezal parado"},
    {"a feed per revolution while the spindle speed is 0", "une avance par tour, vitesse de broche nulle",
     "un avance por vuelta con velocidad de cabezal 0"},
    {"a feed or thread tied to the second spindle", "une avance ou un filetage lié à la seconde broche",
     "un avance o una rosca ligados al segundo cabezal"},
}};

}  // namespace fagorc::backends::iso
