#include "backends/names.hpp"

namespace fagorc::backends {

std::string_view name(operation::Event::Kind kind) {
    using Kind = operation::Event::Kind;
    switch (kind) {
        case Kind::misc:
            return "misc";
        case Kind::spindle_angle:
            return "spindle_angle";
        case Kind::live_tool:
            return "live_tool";
        case Kind::tool:
            return "tool";
        case Kind::offset:
            return "offset";
        case Kind::message:
            return "message";
        case Kind::error:
            return "error";
        case Kind::home:
            return "home";
        case Kind::graphic_zone:
            return "graphic_zone";
        case Kind::program_end:
            return "program_end";
    }
    return {};
}

std::string_view name(operation::Barrier::Why why) {
    using Why = operation::Barrier::Why;
    switch (why) {
        case Why::preparation:
            return "stop";
        case Why::live:
            return "live_stop";
        case Why::position:
            return "position_stop";
    }
    return {};
}

}  // namespace fagorc::backends
