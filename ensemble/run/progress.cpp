#include "run/progress.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <span>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "core/text.hpp"
#include "store/file_calls.hpp"
#include "store/session.hpp"

namespace floes {

constexpr std::chrono::milliseconds live_interval{500};
constexpr std::chrono::milliseconds plain_interval{60'000};
constexpr const char* erase_line = "\r\033[K";

double time_left(double finished_cost, double remaining_cost, double elapsed) {
    if (finished_cost <= 0 || elapsed <= 0) return -1;
    return remaining_cost / (finished_cost / elapsed);
}

std::string rate_text(double per_second) {
    if (per_second >= 1) return fmt::format("{:.1f} members/s", per_second);
    if (per_second * 60 >= 1) return fmt::format("{:.1f} members/min", per_second * 60);
    return fmt::format("{:.1f} members/h", per_second * 3600);
}

namespace {

/// "0:07", "12:40", "3:05:00"
std::string clock_text(double seconds) {
    const auto s = static_cast<long long>(seconds);
    return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                    : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

std::string counts_text(const ProgressState& state) {
    std::string text =
        fmt::format("{} of {} done, {} failed, {} running", state.done, state.total, state.failed, state.running);
    if (state.elapsed >= 1) text += fmt::format(", {} elapsed", clock_text(state.elapsed));
    if (state.finished_now > 0 && state.elapsed > 0) text += ", " + rate_text(state.finished_now / state.elapsed);
    if (state.half_width_target > 0) {
        if (std::isfinite(state.half_width)) {
            text += fmt::format(", half-width {:.1f} % after {}, target {:g} %", 100 * state.half_width,
                                counted(state.in_order, "arrangement"), 100 * state.half_width_target);
        } else if (!state.obstacle.empty()) {
            text += fmt::format(", half-width not known after {} ({}), target {:g} %",
                                counted(state.in_order, "arrangement"), state.obstacle, 100 * state.half_width_target);
        }
        return text;
    }
    if (state.remaining_cost > 0 && state.time_left() >= 0) text += ", " + duration_text(state.time_left()) + " left";
    return text;
}

/// A reader finds the old text or the new one. It is not worth a sync.
void replace_text(const std::filesystem::path& path, const std::string& text, const System& system) {
    const std::filesystem::path aside = path.string() + ".tmp";
    try {
        write_all(open_file(aside, O_WRONLY | O_CREAT | O_TRUNC, system), std::as_bytes(std::span(text)));
        system.rename(aside, path);
    } catch (const std::exception&) {
        system.remove(aside);
    }
}

/// A label's value as the format has it.
std::string escaped(const std::string& label) {
    std::string text;
    for (const char letter : label) {
        if (letter == '\\' || letter == '"') text += '\\';
        text += letter == '\n' ? std::string("\\n") : std::string(1, letter);
    }
    return text;
}

}  // namespace

std::string come_text(double time, double end) {
    return fmt::format("{:.0f} % ({:.0f} of {:.0f} s)", 100 * time / end, time, end);
}

std::string progress_text(const ProgressState& state) {
    std::string text = counts_text(state);
    const char* before = "; ";
    for (const Heartbeat::UnderWay& one : state.longest) {
        text += fmt::format("{}member {} at {}", before, one.number, come_text(one.time, one.end));
        before = ", ";
    }
    return text;
}

Progress::~Progress() {
    if (line_is_open_) out_ << '\n' << std::flush;
}

void Progress::say(const std::string& text) {
    out_ << fmt::format("{}{}: {}\n", line_is_open_ ? erase_line : "", who_, text) << std::flush;
    line_is_open_ = false;
    if (style_ == Style::live) shown_ = false;  // redraws the live line at the next call
}

void Progress::show(const ProgressState& state, Time now) {
    const int tenth = state.total > 0 ? 10 * (state.done + state.failed) / state.total : 10;
    const bool due = !shown_ || now - last_time_ >= (style_ == Style::live ? live_interval : plain_interval) ||
                     (style_ == Style::plain && tenth > last_tenth_);
    if (!due) return;
    shown_ = true;
    last_time_ = now;
    last_tenth_ = tenth;
    write(state);
}

void Progress::show_last(const ProgressState& state) {
    if (style_ == Style::live || state.done + state.failed != last_finished_ || !shown_) write(state);
}

void Progress::write(const ProgressState& state) {
    last_finished_ = state.done + state.failed;
    if (style_ == Style::live) {
        ProgressState short_one = state;  // a line that breaks cannot be erased
        if (short_one.longest.size() > 1) short_one.longest.resize(1);
        out_ << fmt::format("{}{}: {}", erase_line, who_, progress_text(short_one)) << std::flush;
        line_is_open_ = true;
    } else {
        out_ << fmt::format("{}: {}\n", who_, progress_text(state)) << std::flush;
    }
}

Progress::Style style_of_standard_error() {
    const char* wanted = std::getenv("FLOES_PROGRESS");
    if (wanted != nullptr && std::string_view(wanted) == "live") return Progress::Style::live;
    return ::isatty(STDERR_FILENO) == 1 ? Progress::Style::live : Progress::Style::plain;
}

constexpr double longest_silence = 60;  // s; heartbeats come every few seconds, but publishing may delay one

std::filesystem::path heartbeat_path(const std::filesystem::path& campaign_file) {
    return target_of(campaign_file).replace_extension(".alive");
}

std::string metrics_text(const Metrics& metrics) {
    const std::string of = fmt::format("campaign=\"{}\"", escaped(metrics.campaign));
    std::string text = "# HELP floes_members Members of the campaign by their state.\n# TYPE floes_members gauge\n";
    for (const auto& [state, count] : {std::pair{"done", metrics.done}, std::pair{"failed", metrics.failed},
                                       std::pair{"running", metrics.running}, std::pair{"to_do", metrics.to_do}})
        text += fmt::format("floes_members{{{},state=\"{}\"}} {}\n", of, state, count);
    const auto add = [&](const char* name, const char* help, double value) {
        text += fmt::format("# HELP {0} {1}\n# TYPE {0} gauge\n{0}{{{2}}} {3}\n", name, help, of, value);
    };
    add("floes_run_active", "1 while the run is at work, 0 after its end.", metrics.at_work ? 1 : 0);
    add("floes_session_seconds", "Time since the session began.", metrics.elapsed);
    add("floes_session_members", "Members done or failed in the session.", metrics.finished);
    if (metrics.seconds_left >= 0)
        add("floes_left_seconds", "Time until the last member at the present rate.", metrics.seconds_left);
    return text;
}

void write_metrics(const std::filesystem::path& path, const Metrics& metrics, const System& system) {
    replace_text(path, metrics_text(metrics), system);
}

void write_heartbeat(const std::filesystem::path& path, Heartbeat heartbeat, const System& system) {
    std::string text = fmt::format("host {}\nprocess {}\ntime {}\n", host_name(), ::getpid(),
                                   static_cast<std::int64_t>(system.seconds_since_1970()));
    text += fmt::format("elapsed {}\nfinished {}\nfinished_cost {}\nremaining_cost {}\n", heartbeat.elapsed,
                        heartbeat.finished, heartbeat.finished_cost, heartbeat.remaining_cost);
    for (const Heartbeat::UnderWay& one : heartbeat.under_way)
        text += fmt::format("member {} {} {} {} {}\n", one.number, one.attempt, one.seconds, one.time, one.end);
    replace_text(path, text, system);
}

std::optional<Heartbeat> read_heartbeat(const std::filesystem::path& path) {
    std::ifstream in(path);
    Heartbeat heartbeat;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string name;
        words >> name;
        if (name == "host") words >> heartbeat.host;
        if (name == "process") words >> heartbeat.process;
        if (name == "time") words >> heartbeat.time;
        if (name == "elapsed") words >> heartbeat.elapsed;
        if (name == "finished") words >> heartbeat.finished;
        if (name == "finished_cost") words >> heartbeat.finished_cost;
        if (name == "remaining_cost") words >> heartbeat.remaining_cost;
        if (name == "member") {
            Heartbeat::UnderWay& one = heartbeat.under_way.emplace_back();
            words >> one.number >> one.attempt >> one.seconds;
            if (words && !(words >> one.time >> one.end)) words.clear();  // a run of an earlier version
        }
        if (words.fail()) return {};
    }
    if (heartbeat.host.empty() || heartbeat.process <= 0) return {};
    struct stat about {};
    heartbeat.written = ::stat(path.c_str(), &about) == 0 ? about.st_mtim.tv_sec : heartbeat.time;
    return heartbeat;
}

double age_of(const Heartbeat& heartbeat) {
    const auto now = static_cast<std::int64_t>(std::time(nullptr));
    const auto by_host = static_cast<double>(now - heartbeat.time);
    return std::abs(by_host) <= longest_silence ? by_host : static_cast<double>(now - heartbeat.written);
}

bool is_stale(const Heartbeat& heartbeat) {
    const bool gone =
        heartbeat.host == host_name() && ::kill(static_cast<pid_t>(heartbeat.process), 0) != 0 && errno == ESRCH;
    return gone || age_of(heartbeat) > longest_silence;
}

}  // namespace floes
