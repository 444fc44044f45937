#include "cli/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace floes {

int terminal_width() {
    int width = 100;
    winsize window{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 0) {
        width = window.ws_col;
    } else if (const char* columns = std::getenv("COLUMNS")) {
        const int wished = std::atoi(columns);
        if (wished > 0) width = wished;
    }
    return std::max(width, 40);
}

std::string written(const std::vector<Section>& sections, const std::string& format) {
    if (format == "json") return json(sections);
    return format == "csv" ? csv(sections) : text(sections, terminal_width());
}

}  // namespace floes
