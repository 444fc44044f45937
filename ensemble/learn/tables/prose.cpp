#include "tables/prose.hpp"

#include <algorithm>

#include "tables/table.hpp"

namespace floes {
namespace {

constexpr int widest_prose = 110;

void wrap_line(std::string_view line, std::size_t width, std::string& out) {
    std::size_t taken = 0;
    while (!line.empty()) {
        const std::size_t end = std::min(line.find(' '), line.size());
        const std::string_view word = line.substr(0, end);
        const std::size_t length = text_width(word);
        if (taken > 0 && taken + 1 + length > width) {
            out += '\n';
            taken = 0;
        }
        if (taken > 0) {
            out += ' ';
            ++taken;
        }
        out += word;
        taken += length;
        line.remove_prefix(std::min(end + 1, line.size()));
    }
}

/// A command, and behind two spaces or more what it does.
void add_command(std::string_view line, std::size_t width, std::string& out) {
    const std::size_t command = line.find_first_not_of(' ');
    const std::size_t gap = command == std::string_view::npos ? command : line.find("  ", command);
    if (text_width(line) <= width || gap == std::string_view::npos) {
        out += line;
        return;
    }
    out += line.substr(0, gap);
    out += "\n" + std::string(command + 2, ' ');
    out += line.substr(std::min(line.find_first_not_of(' ', gap), line.size()));
}

}  // namespace

std::string wrapped(std::string_view text, int width) {
    const auto room = static_cast<std::size_t>(std::clamp(width, 1, widest_prose));
    std::string out;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        if (line.starts_with(' ')) {
            add_command(line, room, out);
        } else {
            wrap_line(line, room, out);
        }
        if (end == std::string_view::npos) break;
        out += '\n';
        text.remove_prefix(end + 1);
    }
    return out;
}

}  // namespace floes
