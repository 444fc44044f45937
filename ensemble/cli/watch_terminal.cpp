// The terminal of floes status --watch: plain escape codes, as every terminal and ssh has them.

#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <fstream>

#include "cli/commands.hpp"
#include "cli/watch.hpp"
#include "run/signals.hpp"
#include "store/session.hpp"

namespace floes {

namespace {

/// The other screen of the terminal, without a cursor, and keys at once; all as before at the end of its lifetime.
class FullScreen {
  public:
    FullScreen() {
        has_keys_ = ::tcgetattr(STDIN_FILENO, &former_keys_) == 0;
        if (has_keys_) {
            termios keys = former_keys_;
            keys.c_lflag &= static_cast<tcflag_t>(~(ICANON | ECHO));
            keys.c_cc[VSUSP] = _POSIX_VDISABLE;  // Ctrl-Z would leave the screen as it is
            ::tcsetattr(STDIN_FILENO, TCSANOW, &keys);
        }
        struct sigaction woken {};
        woken.sa_handler = [](int) {};  // a change of size ends the wait for keys, which is all
        ::sigaction(SIGWINCH, &woken, &former_action_);
        put("\033[?1049h\033[?25l");
    }
    FullScreen(const FullScreen&) = delete;
    FullScreen& operator=(const FullScreen&) = delete;
    ~FullScreen() {
        put("\033[?25h\033[?1049l");
        ::sigaction(SIGWINCH, &former_action_, nullptr);
        if (has_keys_) ::tcsetattr(STDIN_FILENO, TCSANOW, &former_keys_);
    }

    void show(const std::vector<std::string>& lines) const {
        std::string all = "\033[H";
        for (std::size_t k = 0; k < lines.size(); ++k) all += (k == 0 ? "" : "\r\n") + lines[k] + "\033[K";
        put(all + "\033[J");
    }

    bool has_keys() const { return has_keys_; }

  private:
    static void put(const std::string& text) {
        std::fputs(text.c_str(), stdout);
        std::fflush(stdout);
    }

    bool has_keys_ = false;
    termios former_keys_{};
    struct sigaction former_action_ {};
};

Screen screen_now() {
    Screen screen{.letters = letters_of_terminal()};
    winsize window{};
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 0 && window.ws_row > 0) {
        screen.columns = window.ws_col;
        screen.rows = window.ws_row;
    }
    return screen;
}

/// Resident bytes of the processes in the group of `process`, which has all of a run but the ranks of other hosts.
double memory_of(std::int64_t process) {
    const pid_t group = ::getpgid(static_cast<pid_t>(process));
    const double page = static_cast<double>(::sysconf(_SC_PAGESIZE));
    double bytes = 0;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
        const std::string name = entry.path().filename();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        const auto one = static_cast<pid_t>(std::stol(name));
        if (one != process && (group < 0 || ::getpgid(one) != group)) continue;
        double whole = 0;
        double resident = 0;
        if (std::ifstream(entry.path() / "statm") >> whole >> resident) bytes += resident * page;
    }
    return bytes;
}

/// What the machine can still give, bytes.
std::optional<double> memory_at_hand() {
    std::ifstream file("/proc/meminfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("MemAvailable:")) return 1024 * std::stod(line.substr(line.find(':') + 1));
    return {};
}

WatchedRun read_run(std::span<const std::filesystem::path> files) {
    WatchedRun run = watched(read_snapshot(files));
    const auto& heartbeat = run.status.heartbeat;
    if (run.status.at_work && heartbeat && heartbeat->host == host_name()) {
        run.memory = memory_of(heartbeat->process);
        run.at_hand = memory_at_hand();
    }
    return run;
}

/// Waits for a key, a change of size or the time. Whether q or Ctrl-C was pressed.
bool asked_to_end(const FullScreen& full, const StopSignals& signals, std::chrono::milliseconds longest) {
    pollfd keys{.fd = full.has_keys() ? STDIN_FILENO : -1, .events = POLLIN, .revents = 0};
    if (::poll(&keys, 1, static_cast<int>(longest.count())) > 0) {
        char key = 0;
        if (::read(STDIN_FILENO, &key, 1) <= 0 || key == 'q' || key == 'Q') return true;
    }
    return signals.received() != 0;
}

}  // namespace

void watch_on_terminal(std::span<const std::filesystem::path> campaign_files) {
    using Clock = std::chrono::steady_clock;
    WatchedRun run = read_run(campaign_files);
    const StopSignals signals;
    const FullScreen full;
    while (run.status.at_work) {
        const auto begin = Clock::now();
        run = read_run(campaign_files);
        const auto next =
            Clock::now() + std::max<Clock::duration>(watch_interval, least_pause_per_look * (Clock::now() - begin));
        do {
            full.show(watch_frame(run, screen_now()));
            const auto left = std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now());
            if (asked_to_end(full, signals, std::max(left, std::chrono::milliseconds(1)))) return;
        } while (Clock::now() < next);
    }
}

}  // namespace floes
