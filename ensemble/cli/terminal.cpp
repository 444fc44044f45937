#include "cli/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "run/progress.hpp"

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

std::string written(const std::vector<Section>& sections, const std::string& format, const Units& units) {
    if (format == "json") return json(sections);
    return format == "csv" ? csv(sections) : text(sections, terminal_width(), units);
}

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)), live_(style_of_standard_error() == Progress::Style::live) {}

ProgressLine::~ProgressLine() {
    if (open_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(double done) {
    const Clock::time_point now = Clock::now();
    if (now - last_ < (live_ ? std::chrono::milliseconds(500) : std::chrono::seconds(10)) || !(done > 0)) return;
    last_ = now;
    const double passed = std::chrono::duration<double>(now - begin_).count();
    const std::string text =
        fmt::format("{}: {:.0f} %, {} left", what_, 100 * done, duration_text(passed * (1 - done) / done));
    std::fputs((live_ ? "\r\033[K" + text : text + "\n").c_str(), stderr);
    open_ = live_;
}

WaitingNote::WaitingNote(std::ostream& out, std::string doing, std::chrono::milliseconds patience)
    : waiting_([this, &out, doing = std::move(doing), patience](const std::stop_token& stop) {
          std::unique_lock lock(mutex_);
          over_.wait_for(lock, stop, patience, [] { return false; });
          if (!stop.stop_requested()) out << "floes: " + doing + "\n" << std::flush;
      }) {}

}  // namespace floes
