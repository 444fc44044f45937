#pragma once
// Progress on standard error while a campaign runs: one live line on a terminal, an occasional plain line elsewhere;
// and notes in between, which never break the live line.

#include <chrono>
#include <ostream>
#include <string>

namespace floes {

/// A campaign at one moment.
struct ProgressState {
    int total = 0;
    int done = 0;  ///< with a result, failed ones not included
    int failed = 0;
    int running = 0;
    int finished_now = 0;          ///< done or failed in this session
    double elapsed = 0;            ///< s, of this session
    double finished_cost = 0;      ///< expected cost of finished_now
    double remaining_cost = 0;     ///< expected cost of all unfinished members, same unit
    double half_width = 0;         ///< for the stop rule, a fraction; NaN while unknown
    double half_width_target = 0;  ///< 0: there is no stop rule
    int in_order = 0;              ///< arrangements evaluated by the rule
    std::string obstacle = {};     ///< why it is unknown, without a full stop; empty if that is plain

    /// Remaining cost over the measured rate, s; negative while nothing has finished.
    double time_left() const;
};

/// "3.1 members/s", "4.2 members/min", "0.5 members/h".
std::string rate_text(double per_second);

/// "12 of 36 done, 1 failed, 2 running, 4.2 members/min, 5 min left". With a stop rule the time left is unknown, and
/// "half-width 7.1 % after 20 arrangements, target 5 %" takes its place, or why it is not known.
std::string progress_text(const ProgressState& state);

class Progress {
  public:
    enum class Style { live, plain };
    using Time = std::chrono::steady_clock::time_point;

    Progress(std::ostream& out, Style style) : out_(out), style_(style) {}
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
    bool line_is_open_ = false;
    bool shown_ = false;
    Time last_time_{};
    int last_tenth_ = 0;
    std::string last_text_;
};

/// Live when standard error is a terminal.
Progress::Style style_of_standard_error();

}  // namespace floes
