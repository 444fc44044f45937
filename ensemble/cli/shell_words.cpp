#include "cli/shell_words.hpp"

#include <cstdlib>

namespace floes {

std::string quoted(const std::string& word) {
    const bool plain = !word.empty() && word.find_first_not_of(
                                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                            "0123456789_-+=.,/:@%") == std::string::npos;
    if (plain) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

std::string typed_program(const std::string& program) {
    const char* launcher = std::getenv("FLOES_LAUNCHER");
    if (launcher != nullptr) return quoted(launcher);
    return program.empty() ? "floes" : quoted(program);
}

}  // namespace floes
