#pragma once
// Progress on standard error while a campaign runs: one live line on a terminal, an occasional plain line elsewhere;
// and notes in between, which never break the live line.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "store/system.hpp"

namespace floes {

/// Remaining cost over the measured rate, s; negative while nothing has finished.
double time_left(double finished_cost, double remaining_cost, double elapsed);

// A run in numbers for programs that collect such: a text file in the format of Prometheus, which its node exporter
// reads from a folder (--collector.textfile.directory), and others read too.

struct Metrics {
    std::string campaign = {};
    bool at_work = true;
    int done = 0;  ///< members with a result
    int failed = 0;
    int running = 0;
    int to_do = 0;
    double elapsed = 0;        ///< s, of the session
    int finished = 0;          ///< members done or failed in the session
    double seconds_left = -1;  ///< at the present rate; negative: not known
};

std::string metrics_text(const Metrics& metrics);

/// Replaces the file by renaming. Errors of the file system are ignored.
void write_metrics(const std::filesystem::path& path, const Metrics& metrics, const System& system = this_system());

// A small file beside the journal that shows other terminals and nodes what a run is doing. It is replaced every few
// seconds and removed at the end. It is for display only; no decision depends on it.

struct Heartbeat {
    /// A member that was handed out.
    struct UnderWay {
        int number = 0;
        int attempt = 1;
        double seconds = 0;  ///< since it was handed out
        double time = 0;     ///< simulated, s
        double end = 0;      ///< of its simulation, s; 0: it has not told yet
    };

    std::string host;                 ///< of rank 0
    std::int64_t process = 0;         ///< of rank 0
    std::int64_t time = 0;            ///< time of writing, s since 1970 by that host's clock
    std::int64_t written = 0;         ///< the same by the clock of the file system
    double elapsed = 0;               ///< s since the session began
    int finished = 0;                 ///< members done or failed in the session
    double finished_cost = 0;         ///< their expected cost
    double remaining_cost = 0;        ///< of all unfinished members, same unit
    std::vector<UnderWay> under_way;  ///< longest first, at most 20
};

/// A campaign at one moment.
struct ProgressState {
    int total = 0;
    int done = 0;  ///< with a result, failed ones not included
    int failed = 0;
    int running = 0;
    int finished_now = 0;                           ///< done or failed in this session
    double elapsed = 0;                             ///< s, of this session
    double finished_cost = 0;                       ///< expected cost of finished_now
    double remaining_cost = 0;                      ///< expected cost of all unfinished members, same unit
    double half_width = 0;                          ///< for the stop rule, a fraction; NaN while unknown
    double half_width_target = 0;                   ///< 0: there is no stop rule
    int in_order = 0;                               ///< arrangements evaluated by the rule
    std::string obstacle = {};                      ///< why it is unknown, without a full stop; empty if that is plain
    std::vector<Heartbeat::UnderWay> longest = {};  ///< members that have run longest, some that told how far they are

    double time_left() const { return floes::time_left(finished_cost, remaining_cost, elapsed); }  ///< s
};

/// "3.1 members/s", "4.2 members/min", "0.5 members/h".
std::string rate_text(double per_second);

/// "43 % (86 of 200 s)", of simulated seconds.
std::string come_text(double time, double end);

/// "12 of 36 done, 1 failed, 2 running, 2:51 elapsed, 4.2 members/min, 5 min left; member 7 at 43 % (86 of 200 s)" with
/// the members that have run longest. With a stop rule the time left is
/// unknown, and "half-width 7.1 % after 20 arrangements, target 5 %" takes its place, or why it is not known.
std::string progress_text(const ProgressState& state);

class Progress {
  public:
    enum class Style { live, plain };
    using Time = std::chrono::steady_clock::time_point;

    /// `who` begins every line.
    Progress(std::ostream& out, Style style, std::string who = "floes")
        : out_(out), style_(style), who_(std::move(who)) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();  // ends the live line

    /// Writes a note on a line of its own.
    void say(const std::string& text);

    /// Shows the state if it is due: live, twice a second; plain, after 60 s or a tenth of the members.
    void show(const ProgressState& state, Time now);

    /// Shows the state unless it was just shown.
    void show_last(const ProgressState& state);

  private:
    void write(const ProgressState& state);

    std::ostream& out_;
    Style style_;
    std::string who_;
    bool line_is_open_ = false;
    bool shown_ = false;
    Time last_time_{};
    int last_tenth_ = 0;
    int last_finished_ = 0;
};

/// Live when standard error is a terminal, or the environment has FLOES_PROGRESS=live: for programs that show the line.
Progress::Style style_of_standard_error();

/// `a.h5` -> `a.alive`, in the same folder.
std::filesystem::path heartbeat_path(const std::filesystem::path& campaign_file);

/// Sets host, process and time, and replaces the file by renaming. Errors of the file system are ignored.
void write_heartbeat(const std::filesystem::path& path, Heartbeat heartbeat, const System& system = this_system());

/// Empty if there is no such file or it cannot be parsed.
std::optional<Heartbeat> read_heartbeat(const std::filesystem::path& path);

/// Seconds since it was written: by the clock of its host, or by that of the file system where the former is off.
double age_of(const Heartbeat& heartbeat);

/// True if the run has certainly or probably died: its process does not exist on this host, or the heartbeat is more
/// than a minute old.
bool is_stale(const Heartbeat& heartbeat);

}  // namespace floes
