// floes replay: a member computed again, to be watched: as a page, pictures, a film, in ParaView, or as a recording.

#include "cli/replay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "campaign_file/read.hpp"
#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/terminal.hpp"
#include "core/error.hpp"
#include "draw/picture.hpp"
#include "draw/replay_page.hpp"
#include "draw/vtk_series.hpp"
#include "member/run_member.hpp"
#include "replay/replay_member.hpp"
#include "run/signals.hpp"
#include "store/file_calls.hpp"

namespace floes {

namespace {

template <class Kind, std::size_t count>
Kind kind_named(const std::array<std::string_view, count>& names, const std::string& name) {
    return static_cast<Kind>(std::ranges::find(names, name) - names.begin());
}

/// The look of pictures and films, without the times.
PictureStyle style_of(const ReplayLook& look) {
    PictureStyle style;
    style.view = kind_named<View>(view_names, look.view);
    style.colouring = kind_named<Colouring>(colouring_names, look.colours);
    char rest = 0;
    if (std::sscanf(look.size.c_str(), "%dx%d%c", &style.width, &style.height, &rest) != 2 || style.width < 200 ||
        style.height < 150 || style.width > 8000 || style.height > 8000)
        throw InputError(fmt::format(
            "--size {} is no size; give width x height in pixels, as 1280x800, from 200x150 to 8000x8000.", look.size));
    style.width += style.width % 2;  // films want even numbers
    return style;
}

PictureStyle style_of(const ReplayLook& look, const Recording& recording) {
    PictureStyle style = style_of(look);
    style.from = recording.time(0);
    style.to = recording.time(recording.frames() - 1);
    return style;
}

int frame_of_largest_load(const Recording& recording) {
    const std::vector<double>& surge = recording.outcome().history.surge;
    const double step = recording.subject().scenario.general.time_step;
    int largest = 0;
    double load = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < recording.frames(); ++k) {
        const auto steps = static_cast<std::size_t>(std::llround(recording.time(k) / step));
        if (steps == 0 || steps > surge.size() || surge[steps - 1] <= load) continue;
        load = surge[steps - 1];
        largest = k;
    }
    return largest;
}

void write_picture(const std::filesystem::path& path, const Recording& recording, const ReplayLook& look) {
    const PictureStyle style = style_of(look, recording);
    const Stage stage(recording.subject(), recording.outcome());
    const Frame frame = recording.read(look.at ? recording.nearest(*look.at) : frame_of_largest_load(recording));
    const int height = picture_height(style, recording.subject());
    const bool vectors = path.extension() == ".svg";
    Canvas canvas = vectors ? Canvas(path, style.width, height) : Canvas(style.width, height);
    draw_picture(canvas, stage, frame, style);
    if (vectors) {
        canvas.finish();
    } else {
        canvas.write_png(path);
    }
}

/// Where a page opens: what was asked for or, of part of a run, its largest load, for which such parts are kept.
std::optional<double> start_of_page(const Recording& recording, const ReplayLook& look) {
    if (look.at) return look.at;
    const Scenario& scenario = recording.subject().scenario;
    const double run = scenario.general.time_step * scenario.step_count();
    const double span = recording.time(recording.frames() - 1) - recording.time(0);
    if (!look.worst && span > 0.999 * run) return {};
    return recording.time(frame_of_largest_load(recording));
}

void write(const std::filesystem::path& path, const Recording& recording, const ReplayLook& look,
           const std::function<void()>& go_on) {
    switch (kind_of(path)) {
        case ReplayOutput::page:
            return write_replay_page(path, recording, {.start = start_of_page(recording, look)});
        case ReplayOutput::picture:
            return write_picture(path, recording, look);
        case ReplayOutput::film: {
            ProgressLine line("drawing a film");
            return write_film(path, recording, style_of(look, recording), look.rate, [&](double done) {
                go_on();
                line.show(done);
            });
        }
        case ReplayOutput::vtk:
        case ReplayOutput::recording:
            break;
    }
}

}  // namespace

ReplayOutput kind_of(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".h5") return ReplayOutput::recording;
    if (ending == ".html") return ReplayOutput::page;
    if (ending == ".pvd") return ReplayOutput::vtk;
    if (ending == ".png" || ending == ".svg") return ReplayOutput::picture;
    for (const char* film : {".mp4", ".webm", ".webp", ".gif", ".apng"})
        if (ending == film) return ReplayOutput::film;
    throw InputError(fmt::format(
        "What is {} to be? Its ending says: .html a page that plays, .png or .svg a picture, .mp4, .webm, .webp, .gif "
        "or .apng a film, .pvd a series for ParaView, .h5 the recording itself.",
        path.string()));
}

void check(const ReplayLook& look) {
    style_of(look);
}

void check_time(const ReplayLook& look, double from, double to, double every) {
    if (!look.at || (*look.at >= from - every && *look.at <= to + every)) return;
    throw InputError(fmt::format("--at {:g}: there is no frame at that time; the frames go from {:g} s to {:g} s.",
                                 *look.at, from, to));
}

void write_replay_output(const std::filesystem::path& path, const Recording& recording, const ReplayLook& look,
                         const std::function<void()>& go_on) {
    if (kind_of(path) == ReplayOutput::vtk)
        return write_vtk_series(path, recording);  // a file and a folder of its name
    std::filesystem::path aside = path;
    aside.replace_extension(".part" + path.extension().string());  // by which ffmpeg knows what to make
    try {
        write(aside, recording, look, go_on);
        rename_into_place(aside, path);
    } catch (...) {
        std::error_code ignored;
        std::filesystem::remove(aside, ignored);
        throw;
    }
}

namespace {

struct ReplayOptions {
    std::string file;
    MemberChoice member;
    TimeChoice times;
    std::vector<std::string> outputs;
    ReplayLook look;
};

/// A temporary recording beside the files that are made of it; deleted at the end.
class PassingRecording {
  public:
    explicit PassingRecording(const std::filesystem::path& beside) : path_(beside.string() + ".record.h5") {}
    PassingRecording(const PassingRecording&) = delete;
    PassingRecording& operator=(const PassingRecording&) = delete;
    ~PassingRecording() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

MemberResult compute(const ReplaySubject& subject, const FrameSteps& steps, const std::filesystem::path& path,
                     const StopSignals& signals) {
    std::stop_source stop;
    const double end = subject.about.scenario.general.time_step * subject.about.scenario.step_count();
    ProgressLine line(fmt::format("computing member {} (case {}, arrangement {})", subject.about.member,
                                  subject.about.case_name, subject.about.arrangement));
    return replay(subject, steps, path, stop.get_token(), [&](double time) {
        if (signals.received() != 0) stop.request_stop();
        line.show(time / end);
    });
}

/// Computes the member and writes its recording. Returns whether it equals the member of the file; prints what differs.
bool record_member(const ReplayOptions& options, const std::filesystem::path& path, const StopSignals& signals) {
    expect_campaign_file(options.file);
    const CampaignFile file(options.file);
    const CampaignTable table = read_campaign_file(file);
    const ReplaySubject subject = replay_subject(file, table, chosen_member(table, options.member));
    const FrameSteps steps = frame_steps(chosen_times(subject, options.times), subject.about.scenario);
    const double step = subject.about.scenario.general.time_step;
    check_time(options.look, step * steps.first, step * steps.last, step * steps.stride);
    const bool is_new = subject.stored.status == RowStatus::missing;
    if (is_new)
        std::fprintf(stderr,
                     "floes: member %d is not in %s yet; it is computed here for the first time, with nothing to be "
                     "compared with\n",
                     subject.about.member, options.file.c_str());
    const MemberResult result = compute(subject, steps, path, signals);
    if (result.status == MemberStatus::failed) std::fprintf(stderr, "floes: %s\n", result.reason.c_str());
    if (is_new) return true;
    const std::vector<std::string> found = differences(subject, result);
    if (found.empty()) return true;
    std::fprintf(stderr,
                 "floes: member %d as computed now is not the one in %s, which another version or another machine may "
                 "have computed:\n",
                 subject.about.member, options.file.c_str());
    for (const std::string& sentence : found) std::fprintf(stderr, "floes:   %s\n", sentence.c_str());
    return false;
}

void write_outputs(const std::filesystem::path& record_path, const ReplayOptions& options, const StopSignals& signals) {
    const Recording recording(record_path);
    const double last = recording.time(recording.frames() - 1);
    check_time(options.look, recording.time(0), last, (last - recording.time(0)) / std::max(1, recording.frames() - 1));
    const auto go_on = [&signals] {
        if (signals.received() != 0) throw Interrupted("stopped on request");
    };
    for (const std::string& output : options.outputs) {
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
        if (options.member.given() || options.times.given())
            throw InputError(fmt::format(
                "{} is the recording of one member and one stretch of time already; choose those when it is made.",
                options.file));
        write_outputs(options.file, options, signals);
        return true;
    }
    std::optional<PassingRecording> passing;
    if (recordings.empty()) recordings.push_back(passing.emplace(options.outputs.front()).path());
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
        "The 20 s round the largest load: of that member or, if none is named, of the one with the largest load of "
        "that case or of all");
    verb.option("--from", options.times.from, "First frame, s; default: the start");
    verb.option("--to", options.times.to, "Last frame, s; default: the end");
    verb.option("--every", options.times.every,
                "Time from frame to frame, s; default: 0.1 s, over more than a minute 0.25 s")
        .positive();
}

void add_looks(Verb& verb, ReplayOptions& options) {
    verb.option("-o,--output", options.outputs,
                "What to make, by its ending; may be repeated: .html a page that plays, .png or .svg a picture, "
                ".mp4, .webm, .webp, .gif or .apng a film, .pvd a series for ParaView, .h5 "
                "the recording")
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
        "  floes replay my.h5 12 -o whole.html                     all of member 12\n"
        "  floes replay my.h5 --worst --case E60 -o e60.h5         a recording, to make several things of it:\n"
        "  floes replay e60.h5 -o e60.png -o e60.svg               Fig. 5 at the largest load\n"
        "  floes replay e60.h5 -o plan.png --view plan --at 235\n"
        "  floes replay e60.h5 -o below.mp4 --view below\n"
        "  floes replay e60.h5 -o e60.pvd                          for ParaView, with a state: paraview "
        "--state=e60.py");
    verb.runs([options] {
        options->times.worst = options->look.worst = options->member.worst;
        return exit_status_of(*options);
    });
}

}  // namespace floes
