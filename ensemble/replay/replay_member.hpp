#pragma once
// Computes a member of a campaign file again and keeps frames of it.
//
//   const Subject subject(path, member)  ->  replay(subject, frames, recording)  ->  a recording, and what differs from
//   the file

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "campaign_file/campaign_table.hpp"
#include "campaign_file/read.hpp"
#include "member/result.hpp"
#include "replay/recording.hpp"

namespace floes {

/// The steps of a run of which frames are kept: every `stride`-th one from `first` to `last`.
struct FrameSteps {
    int first = 0;
    int last = 0;
    int stride = 1;

    bool has(int step) const { return step >= first && step <= last && (step - first) % stride == 0; }
    int count() const { return (last - first) / stride + 1; }
};

/// Which times are wanted, s.
struct FrameTimes {
    double from = 0;
    double to = 0;
    double every = 0;
    double through = 0;  ///< a time that a frame must have, if it lies between the two
};

/// The steps nearest to these times; the stride is at least one. Throws InputError where there are none in the run.
FrameSteps frame_steps(const FrameTimes& times, const Scenario& scenario);

/// A member of a campaign file, with all that is needed to compute it again.
struct ReplaySubject {
    RecordingSubject about;
    MemberRow stored;        ///< as the file has it
    std::uint64_t seed = 0;  ///< of the streams that its arrangement is drawn from
    std::filesystem::path file;
};

/// Throws InputError when the file has no such member, or its configuration is not that of its members.
ReplaySubject replay_subject(const CampaignFile& file, const CampaignTable& table, int member);

/// Called after each step with the time, s, that the run has come to.
using ReplayProgress = std::function<void(double time)>;

/// When what is asked of the subject is largest in its window, s: in the histories of the file, in the middle of what
/// is averaged. NaN where it keeps none, as of every tension.
double time_of_largest(const ReplaySubject& subject);

/// When the tension of a mooring line is largest in the run, s: the member is computed for it. NaN without lines.
/// Throws Interrupted on a stop.
double time_of_largest_tension(const ReplaySubject& subject, const std::stop_token& stop = {},
                               const ReplayProgress& progress = {});

/// The largest value of what is asked, of each member; NaN where there is none. Of load and mooring force over some
/// time, and of offsets, from the histories of the file, of this case alone if one is named; of tensions over the run,
/// else in the window of the case. Throws InputError as averaging_refusal() says.
std::vector<double> largest_values(const CampaignFile& file, const CampaignTable& table, const Asked& asked,
                                   const std::string& case_name = {});

/// What differs between the result and what the file has of the member, a sentence each: quantities, breaks and load
/// history, to the bit. Empty for the same member.
std::vector<std::string> differences(const ReplaySubject& subject, const MemberResult& result);

/// Computes the member, writes frames of `steps` and what is known at the end to a recording at `path`, and returns the
/// result. Costs the member's time and that of the frames. A member that fails has a recording up to there. Throws
/// Interrupted on a stop, and then leaves no recording.
MemberResult replay(const ReplaySubject& subject, const FrameSteps& steps, const std::filesystem::path& path,
                    const std::stop_token& stop = {}, const ReplayProgress& progress = {});

/// What a report shows of a member, in memory.
struct KeyFrames {
    Frame start;
    Frame worst;  ///< of the worst moment
    Frame end;
    LoadHistory history;  ///< of every step
    HullHistory hull;     ///< likewise
    MemberResult result;
    RecordingSubject about;          ///< the member's, with the floes that these frames show
    std::vector<BreakEvent> breaks;  ///< of these floes
};

/// Computes the member and keeps these frames; may run in many threads at once. `worst_at`: s, as time_of_largest();
/// NaN: where the surge load of a step is largest in the window. Throws Interrupted on a stop.
KeyFrames key_frames(const ReplaySubject& subject, double worst_at, const std::stop_token& stop = {});

// Which member of a campaign file is to be replayed, and from when to when.

/// How a member may be named. `worst`: the one with the largest value of what is asked, of those that the others leave.
struct MemberChoice {
    std::optional<int> number = {};
    std::string case_name = {};  ///< empty: any
    std::optional<int> arrangement = {};
    bool worst = false;

    bool given() const { return number || !case_name.empty() || arrangement || worst; }
    /// Whether it is one of the done members that case and arrangement leave.
    bool leaves(const CampaignTable& table, int member) const;
};

/// Throws InputError when no member, or more than one, is meant. `values`: as largest_values(), of what is asked.
int chosen_member(const CampaignTable& table, const MemberChoice& choice, std::span<const double> values,
                  const Asked& asked = {});

/// Which times of a run are wanted, s; what is not given is the whole run or, of the worst moment, the 20 s round it.
struct TimeChoice {
    bool worst = false;
    std::optional<double> worst_at = {};  ///< s, where it is known; not given: the file's histories say it
    std::optional<double> from = {};
    std::optional<double> to = {};
    std::optional<double> every = {};  ///< not given: 0.1 s, over more than a minute 0.25 s

    bool given() const { return worst || from || to || every; }
};

/// Throws InputError for the worst moment of a member whose history the file does not keep.
FrameTimes chosen_times(const ReplaySubject& subject, const TimeChoice& choice);

}  // namespace floes
