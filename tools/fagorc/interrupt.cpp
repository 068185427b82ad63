#include "tools/fagorc/interrupt.hpp"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <climits>

namespace fagorc::tool {
namespace {

constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP};

/// A signal handler can be handed nothing, so the path stands here.
std::array<char, PATH_MAX> path_to_remove;

/// Only calls that are safe in a handler. The handler has been reset: the signal raised again ends the process as it
/// would have done, so that a shell sees why.
void remove_and_end(int signal) {
    ::unlink(path_to_remove.data());
    ::raise(signal);
}

void handle(void (*handler)(int), int flags) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    for (int s : signals) {
        struct sigaction before {};
        // What the parent made ignored (nohup) stays so.
        if (::sigaction(s, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) ::sigaction(s, &action, nullptr);
    }
}

}  // namespace

RemovedOnInterrupt::RemovedOnInterrupt(std::string_view path) {
    if (path.empty() || path.size() >= path_to_remove.size()) return;
    path_to_remove[path.copy(path_to_remove.data(), path_to_remove.size() - 1)] = '\0';
    handle(remove_and_end, static_cast<int>(SA_RESETHAND | SA_NODEFER));
}

RemovedOnInterrupt::~RemovedOnInterrupt() {
    handle(SIG_DFL, 0);
}

}  // namespace fagorc::tool
