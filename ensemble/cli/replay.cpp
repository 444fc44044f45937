// floes replay: a member computed again, to be watched: as a page, pictures, a film, in ParaView, or as a recording.

#include "campaign_file/read.hpp"
#include "cli/commands.hpp"
#include "draw/replay_output.hpp"
#include "member/run_member.hpp"
#include "replay/replay_member.hpp"
#include "run/signals.hpp"
#include "store/file_calls.hpp"

namespace floes {

namespace {

struct ReplayOptions {
    std::string file;
    MemberChoice member;
    TimeChoice times;
    std::vector<std::string> outputs;
    ReplayLook look;
    std::string of;                   ///< empty: the load of a step
    std::optional<double> averaging;  ///< s; none: 1

    Asked asked() const {
        if (of.empty()) return {};
        return {*asked_of(of), averaging.value_or(1)};
    }
};

ProgressLine progress_of(const ReplaySubject& subject, const std::string& does) {
    return ProgressLine(fmt::format("{} member {} (case {}, arrangement {})", does, subject.about.member,
                                    subject.about.case_name, subject.about.arrangement));
}

/// Shows how far the member is, and stops it on a signal.
ReplayProgress progress_on(ProgressLine& line, const ReplaySubject& subject, const StopSignals& signals,
                           std::stop_source& stop) {
    const double end = subject.about.scenario.general.time_step * subject.about.scenario.step_count();
    return [&line, &signals, &stop, end](double time) {
        if (signals.received() != 0) stop.request_stop();
        line.show(time / end);
    };
}

MemberResult compute(const ReplaySubject& subject, const FrameSteps& steps, const std::filesystem::path& path,
                     const StopSignals& signals) {
    std::stop_source stop;
    ProgressLine line = progress_of(subject, "computing");
    return replay(subject, steps, path, stop.get_token(), progress_on(line, subject, signals, stop));
}

/// A member of the file, and which of its times.
std::pair<ReplaySubject, FrameTimes> chosen(const ReplayOptions& options, const StopSignals& signals) {
    const CampaignFile file(options.file);
    const CampaignTable table = read_campaign_file(file);
    const Asked asked = options.asked();
    const bool any = options.member.worst && !options.member.number;
    const std::vector<double> values =
        any ? largest_values(file, table, asked, options.member.case_name) : std::vector<double>{};
    ReplaySubject subject = replay_subject(file, table, chosen_member(table, options.member, values, asked));
    subject.about.asked = asked;
    TimeChoice times = options.times;
    if (times.worst && asked.of == AskedOf::tension && subject.stored.status != RowStatus::missing) {
        std::stop_source stop;
        ProgressLine line = progress_of(subject, "looking for the largest tension of");
        times.worst_at = time_of_largest_tension(subject, stop.get_token(), progress_on(line, subject, signals, stop));
    }
    const FrameTimes found = chosen_times(subject, times);
    if (times.worst && !options.of.empty())
        note("member {} (case {}, arrangement {}) has the largest {} at {:.2f} s", subject.about.member,
             subject.about.case_name, subject.about.arrangement, asked.words(), found.through);
    return {std::move(subject), found};
}

/// Computes the member and writes its recording. Returns whether it equals the member of the file; prints what differs.
bool record_member(const ReplayOptions& options, const std::filesystem::path& path, const StopSignals& signals) {
    expect_campaign_file(options.file);
    const auto [subject, times] = chosen(options, signals);
    const FrameSteps steps = frame_steps(times, subject.about.scenario);
    const double step = subject.about.scenario.general.time_step;
    check_time(options.look, step * steps.first, step * steps.last, step * steps.stride);
    const bool is_new = subject.stored.status == RowStatus::missing;
    if (is_new)
        note("member {} is not in {} yet; it is computed here for the first time, with nothing to be compared with",
             subject.about.member, options.file);
    const MemberResult result = compute(subject, steps, path, signals);
    if (result.status == MemberStatus::failed) note("{}", result.reason);
    if (is_new) return true;
    const std::vector<std::string> found = differences(subject, result);
    if (found.empty()) return true;
    note("member {} as computed now is not the one in {}, which another version or another machine may have computed:",
         subject.about.member, options.file);
    for (const std::string& sentence : found) note("  {}", sentence);
    return false;
}

void write_outputs(const std::filesystem::path& record_path, const ReplayOptions& options, const StopSignals& signals) {
    const Recording recording(record_path);
    const double last = recording.time(recording.frames() - 1);
    check_time(options.look, recording.time(0), last, (last - recording.time(0)) / std::max(1, recording.frames() - 1));
    for (const std::string& output : options.outputs) {
        ProgressLine line("drawing a film");
        const auto go_on = [&](double done) {
            if (signals.received() != 0) throw Interrupted("stopped on request");
            line.show(done);
        };
        if (kind_of(output) != ReplayOutput::recording) write_replay_output(output, recording, options.look, go_on);
        std::printf("%s\n", output.c_str());
    }
}

/// Refuses to overwrite a campaign file with a recording.
void check_place(const std::filesystem::path& path) {
    if (std::filesystem::exists(path) && !is_recording(path))
        throw InputError(
            fmt::format("{} is there and is no recording; give the recording another name.", path.string()));
}

bool run(const ReplayOptions& options, const StopSignals& signals) {
    check(options.look);
    if (options.averaging && options.of.empty())
        throw InputError("--averaging-s is of what --of names; without it --worst takes the load of a step.");
    const bool has_record = is_recording(options.file);
    std::vector<std::string> recordings;
    for (const std::string& output : options.outputs)
        if (kind_of(output) == ReplayOutput::recording) recordings.push_back(output);
    if (recordings.size() > (has_record ? 0 : 1))
        throw InputError(has_record
                             ? fmt::format("{} is a recording already; make something else of it.", options.file)
                             : fmt::format("Two recordings of one member, {} and {}, would be the same; give one.",
                                           recordings[0], recordings[1]));
    if (has_record) {
        if (options.member.given() || options.times.given() || !options.of.empty())
            throw InputError(fmt::format(
                "{} is the recording of one member and one stretch of time already; choose those when it is made.",
                options.file));
        write_outputs(options.file, options, signals);
        return true;
    }
    std::optional<AsideFile> passing;  // a recording beside the files that are made of it
    if (recordings.empty()) recordings.push_back(passing.emplace(options.outputs.front() + ".record.h5").path());
    const std::filesystem::path path = recordings.front();
    check_place(path);
    const bool same = record_member(options, path, signals);
    write_outputs(path, options, signals);
    return same;
}

int exit_status_of(const ReplayOptions& options) {
    const StopSignals signals;
    try {
        return run(options, signals) ? 0 : 1;
    } catch (const Interrupted&) {
        return exit_stopped;
    }
}

void add_choices(Verb& verb, ReplayOptions& options) {
    verb.option("file", options.file, "The campaign file (CAMPAIGN.h5), or a recording that floes replay made")
        .required();
    verb.option("member", options.member.number, "The member's number").not_negative();
    verb.option("--case", options.member.case_name, "The member of this case ...");
    verb.option("--arrangement", options.member.arrangement, "... and this arrangement").not_negative();
    verb.flag(
        "--worst", options.member.worst,
        "The 20 s round the largest load, or what --of says: of that member or, if none is named, of the one with the "
        "largest of that case or of all");
    verb.option(
            "--of", options.of,
            "What is largest: load or mooring_force, both over --averaging-s; offset; tension of a line, whose moment "
            "is found by computing the member once more; default: the load of a step")
        .one_of({asked_names.begin(), asked_names.end()});
    verb.option("--averaging-s", options.averaging, "Time that load and mooring force are averaged over, s; default: 1")
        .within(0.0, 1000.0);
    verb.option("--from", options.times.from, "First frame, s; default: the start");
    verb.option("--to", options.times.to, "Last frame, s; default: the end");
    verb.option("--every", options.times.every,
                "Time from frame to frame, s; default: 0.1 s, over more than a minute 0.25 s")
        .positive();
}

void add_looks(Verb& verb, ReplayOptions& options) {
    verb.option("-o,--output", options.outputs,
                "What to make, by its ending; may be repeated: .html a page that plays, .png or .svg a picture, "
                ".mp4, .webm, .webp, .gif or .apng a film, .xdmf2 a series for ParaView, "
                ".h5 the recording")
        .one_each()
        .writes_file()
        .required();
    verb.option("--at", options.look.at,
                "Time of pictures, and at which pages open, s; default: the largest load among the frames");
    verb.option("--view", options.look.view,
                "Of pictures and films: perspective (Fig. 5), above, side, below the water, or plan (Fig. 3)")
        .one_of({"perspective", "above", "side", "below", "plan"})
        .shows_default();
    verb.option("--colours", options.look.colours,
                "What they tell of the floes: ice (broken ones are marked), piece, speed or utilisation")
        .one_of({"ice", "piece", "speed", "utilisation"})
        .shows_default();
    verb.option("--size", options.look.size,
                "Of pictures and films, pixels; of --view plan only the width, the height is what the channel needs")
        .shows_default();
    verb.option("--rate", options.look.rate,
                "Frames of films a second; with 25, frames 0.1 s apart run 2.5 times as "
                "fast as the tank")
        .within(1, 100)
        .shows_default();
}

}  // namespace

void add_replay(CommandLine& line) {
    auto options = std::make_shared<ReplayOptions>();
    Verb verb = line.verb("replay", "Watch a member: compute it again and show how it went");
    add_choices(verb, *options);
    add_looks(verb, *options);
    verb.footer(
        "The member is computed again and compared with the file to the bit; exit status 1 says that it differs.\n\n"
        "  floes replay my.h5 --worst -o worst.html                the 20 s round the largest load, in a browser\n"
        "  floes replay my.h5 --worst --of mooring_force -o force.html\n"
        "  floes replay my.h5 12 -o whole.html                     all of member 12\n"
        "  floes replay my.h5 --worst --case E60 -o e60.h5         a recording, to make several things of it:\n"
        "  floes replay e60.h5 -o e60.png -o e60.svg               Fig. 5 at the largest load\n"
        "  floes replay e60.h5 -o plan.png --view plan --at 235\n"
        "  floes replay e60.h5 -o below.mp4 --view below\n"
        "  floes replay e60.h5 -o e60.xdmf2                        for ParaView, with a state: paraview "
        "--state=e60.py");
    verb.runs([options] {
        options->times.worst = options->look.worst = options->member.worst;
        if (!options->of.empty() && !options->member.worst && !is_recording(options->file))
            throw InputError(
                fmt::format("--of {} says what --worst is the largest of; give --worst too.", options->of));
        return exit_status_of(*options);
    });
}

}  // namespace floes
