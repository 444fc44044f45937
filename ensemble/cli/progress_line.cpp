#include "cli/progress_line.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/wording.hpp"
#include "driver/progress.hpp"

namespace floes {

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

}  // namespace floes
