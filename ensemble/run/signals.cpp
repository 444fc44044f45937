#include "run/signals.hpp"

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdint>
#include <cstdlib>

#include <fmt/format.h>

#include "core/text.hpp"

namespace floes {

namespace {

// A handler can only use globals. These belong to the outermost StopSignals that exists.
std::atomic<int> first_signal{0};
std::atomic<std::int64_t> first_time{0};  // ms, monotonic
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free);

std::atomic<int> stop_signals_alive = 0;

// timeout(1), or a batch system together with mpirun, may deliver one request twice within microseconds.
constexpr std::int64_t same_request_ms = 250;

std::int64_t now_ms() {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

void on_signal(int signal) {
    int none = 0;
    // The system repeats SIGXCPU for each second of processor time above the limit, which many threads soon have.
    if (signal == SIGXCPU && first_signal != none) return;
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
        if (!is_to_be_outlived(stop_signals[i])) ::sigaction(stop_signals[i], &action, nullptr);
    }
}

void give_back(const Former& former) {
    for (std::size_t i = 0; i < stop_signals.size(); ++i) ::sigaction(stop_signals[i], &former[i], nullptr);
}

std::optional<int> number(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < 0) return std::nullopt;
    return value;
}

}  // namespace

bool is_to_be_outlived(int signal) {
    struct sigaction now {};
    ::sigaction(signal, nullptr, &now);
    return (signal == SIGHUP || signal == SIGUSR2) && now.sa_handler == SIG_IGN;
}

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

std::string signal_name(int signal) {
    const char* name = ::sigabbrev_np(signal);
    return name != nullptr ? fmt::format("SIG{}", name) : "a signal";
}

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

JobTimeLeft find_time_left(double asked, Seconds longest_wait) {
    if (asked > 0) return {asked, {}};
    const char* job = std::getenv("SLURM_JOB_ID");
    if (job == nullptr || !number(job)) return {};
    const char* array = std::getenv("SLURM_ARRAY_JOB_ID");
    const char* task = std::getenv("SLURM_ARRAY_TASK_ID");
    // One task of an array has the number of the whole array, of which squeue tells of all tasks.
    const bool of_array = array != nullptr && task != nullptr && number(array) && number(task);
    const std::string asked_of = of_array ? fmt::format("{}_{}", array, task) : job;
    const ProgramAnswer answer = answer_of({"squeue", "-h", "-j", asked_of, "-o", "%L"}, longest_wait);
    if (answer.good() && answer.output.starts_with("UNLIMITED")) return {};
    if (const auto seconds = parse_time_left(answer.output); answer.good() && seconds) return {seconds, {}};
    const std::string why =
        !answer.fault.empty() ? fmt::format("cannot be started ({})", answer.fault)
        : !answer.status
            ? fmt::format("did not answer within {}", duration_in_figures(longest_wait.count()))
            : fmt::format("answers \"{}\" and ends with status {}",
                          beginning(answer.output.substr(0, answer.output.find('\n')), 40), *answer.status);
    return {{},
            fmt::format("squeue {}, so it is not known when job {} ends: the run stops when Slurm signals it (sbatch "
                        "--signal=B:USR1@120), or give --time-left SECONDS",
                        why, job)};
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
