#include "tools/fagorc/report/language.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <utility>

namespace fagorc::report {

std::optional<Language> language_of(std::string_view name) {
    if (name == "en") return Language::english;
    if (name == "fr") return Language::french;
    if (name == "es") return Language::spanish;
    return std::nullopt;
}

Language language_of_environment(const Environment& environment) {
    for (const char* variable : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* value = environment(variable);
        if (!value || !*value) continue;
        const std::string_view locale = value;
        return language_of(locale.substr(0, locale.find_first_of("_.@"))).value_or(Language::english);
    }
    return Language::english;
}

std::optional<Color> color_of(std::string_view name) {
    static constexpr std::pair<std::string_view, Color> names[] = {
        {"auto", Color::automatic}, {"always", Color::always}, {"never", Color::never}};
    for (const auto& [known, choice] : names)
        if (known == name) return choice;
    return std::nullopt;
}

bool color_wanted(Color choice, bool on_terminal, const Environment& environment) {
    if (choice != Color::automatic) return choice == Color::always;
    const char* no_color = environment("NO_COLOR");
    const char* terminal = environment("TERM");
    return on_terminal && !(no_color && *no_color) && !(terminal && std::string_view(terminal) == "dumb");
}

bool is_terminal(std::FILE* file) {
    return isatty(fileno(file)) == 1;
}

std::optional<std::size_t> terminal_width(std::FILE* file) {
    winsize size{};
    if (ioctl(fileno(file), TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::nullopt;
    return size.ws_col;
}

}  // namespace fagorc::report
