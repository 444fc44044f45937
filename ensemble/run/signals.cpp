#include "run/signals.hpp"

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

namespace floes {

namespace {

// A handler can only use globals. These belong to the outermost StopSignals that exists.
std::atomic<int> first_signal{0};
std::atomic<std::int64_t> first_time{0};  // ms, monotonic
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free);

int stop_signals_alive = 0;  // made and destroyed by the main thread

// timeout(1), or a batch system together with mpirun, may deliver one request twice within microseconds.
constexpr std::int64_t same_request_ms = 250;

std::int64_t now_ms() {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

void on_signal(int signal) {
    int none = 0;
    if (first_signal.compare_exchange_strong(none, signal)) {
        first_time = now_ms();
        return;
    }
    const std::int64_t first = first_time;
    if (first == 0 || now_ms() - first < same_request_ms) return;
    constexpr std::string_view parting =
        "\nfloes: ended immediately by a second signal; all results in the journal are kept\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, parting.data(), parting.size());
    ::_exit(exit_stopped);
}

void leave(int) {
    constexpr std::string_view parting = "\nfloes: stopped before the first member; the same command starts again\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, parting.data(), parting.size());
    ::_exit(exit_stopped);
}

using Former = std::array<struct sigaction, stop_signals.size()>;

void catch_all(void (*handler)(int), Former& former) {
    struct sigaction action {};
    action.sa_handler = handler;
    ::sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    for (std::size_t i = 0; i < stop_signals.size(); ++i) {
        ::sigaction(stop_signals[i], nullptr, &former[i]);
        const bool by_nohup = stop_signals[i] == SIGHUP && former[i].sa_handler == SIG_IGN;
        if (!by_nohup) ::sigaction(stop_signals[i], &action, nullptr);
    }
}

void give_back(const Former& former) {
    for (std::size_t i = 0; i < stop_signals.size(); ++i) ::sigaction(stop_signals[i], &former[i], nullptr);
}

}  // namespace

StopSignals::StopSignals() {
    if (stop_signals_alive++ == 0) {
        first_signal = 0;
        first_time = 0;
    }
    catch_all(on_signal, former_);
}

StopSignals::~StopSignals() {
    --stop_signals_alive;
    give_back(former_);
}

LeaveOnSignals::LeaveOnSignals() {
    catch_all(leave, former_);
}

LeaveOnSignals::~LeaveOnSignals() {
    give_back(former_);
}

int StopSignals::received() const {
    return first_signal;
}

void outlive_readers() {
    std::signal(SIGPIPE, SIG_IGN);
}

const char* signal_name(int signal) {
    switch (signal) {
        case SIGINT:
            return "SIGINT";
        case SIGTERM:
            return "SIGTERM";
        case SIGHUP:
            return "SIGHUP";
        case SIGUSR1:
            return "SIGUSR1";
        default:
            return "a signal";
    }
}

namespace {

std::optional<int> number(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < 0) return std::nullopt;
    return value;
}

std::string output_of(const std::string& command) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
    std::array<char, 64> text{};
    if (!pipe || std::fgets(text.data(), text.size(), pipe.get()) == nullptr) return {};
    return text.data();
}

}  // namespace

std::optional<double> parse_time_left(std::string_view text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.remove_suffix(1);
    std::optional<int> days = 0;
    if (const std::size_t dash = text.find('-'); dash != std::string_view::npos) {
        days = number(text.substr(0, dash));
        text.remove_prefix(dash + 1);
    }
    if (!days) return std::nullopt;
    double seconds = 0;
    int parts = 0;
    for (bool more = true; more; ++parts) {
        const std::size_t colon = text.find(':');
        more = colon != std::string_view::npos;
        const std::optional<int> part = number(text.substr(0, colon));
        if (!part) return std::nullopt;
        seconds = 60 * seconds + *part;
        if (more) text.remove_prefix(colon + 1);
    }
    if (parts > 3) return std::nullopt;
    return *days * 86400.0 + seconds;
}

std::optional<double> find_time_left(double asked) {
    if (asked > 0) return asked;
    const char* job = std::getenv("SLURM_JOB_ID");
    if (job == nullptr || !number(job)) return std::nullopt;
    return parse_time_left(output_of(std::string("squeue -h -j ") + job + " -o %L 2>/dev/null"));
}

Walltime::Walltime(std::optional<double> seconds_left, Time now) {
    if (!seconds_left) return;
    const std::chrono::duration<double> usable(*seconds_left - std::min(60.0, 0.1 * *seconds_left));
    end_ = now + std::chrono::duration_cast<Time::duration>(usable);
}

std::optional<double> Walltime::left(Time now) const {
    if (!end_) return std::nullopt;
    return std::chrono::duration<double>(*end_ - now).count();
}

}  // namespace floes
