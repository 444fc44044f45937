// floes replay: a member computed again, to be watched: as a record, a page, pictures, a film, or in ParaView.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "campaign_file/read_campaign_file.hpp"
#include "cli/commands.hpp"
#include "cli/progress_line.hpp"
#include "core/error.hpp"
#include "driver/signals.hpp"
#include "replay/replay_member.hpp"
#include "view/film.hpp"
#include "view/replay_page.hpp"
#include "view/vtk_series.hpp"

namespace floes {
namespace {

constexpr double round_worst = 10;   // s of frames before and after the largest load
constexpr double long_span = 60;     // s; of longer ones fewer frames are kept
constexpr double short_every = 0.1;  // s
constexpr double long_every = 0.2;   // s
constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

struct ReplayOptions {
    std::string file;
    int member = -1;
    std::string case_name;
    int arrangement = -1;
    bool worst = false;
    double from = not_given;
    double to = not_given;
    double every = not_given;
    std::vector<std::string> outputs;
    double at = not_given;
    std::string view = "perspective";
    std::string colours = "ice";
    std::string size = "1280x800";
};

/// What is made, by the ending of its name.
enum class Output { record, page, picture, film, vtk };

Output kind_of(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".h5") return Output::record;
    if (ending == ".html") return Output::page;
    if (ending == ".pvd") return Output::vtk;
    if (ending == ".png" || ending == ".svg") return Output::picture;
    for (const char* film : {".mp4", ".webm", ".webp", ".gif", ".apng"})
        if (ending == film) return Output::film;
    throw InputError(fmt::format(
        "What is {} to be? Its ending says: .html a page that plays, .png or .svg a picture, .mp4, .webm, .webp, .gif "
        "or .apng a film, .pvd a series for ParaView, .h5 the record itself.",
        path.string()));
}

bool done(const MemberRow& row) {
    return row.status == RowStatus::done;
}

/// The member with the largest load of those that `options` leaves; -1 if there is none.
int worst_of(const CampaignTable& table, const std::vector<int>& members) {
    int worst = -1;
    for (const int number : members) {
        const MemberRow& row = table.members[static_cast<std::size_t>(number)];
        if (!done(row)) continue;
        if (worst < 0 || row.load.maximum > table.members[static_cast<std::size_t>(worst)].load.maximum) worst = number;
    }
    return worst;
}

std::string case_names(const CampaignTable& table) {
    std::string names;
    for (const CaseRow& one : table.cases) names += (names.empty() ? "" : ", ") + one.name;
    return names;
}

/// Members of the given case and arrangement, where these are given.
std::vector<int> members_left(const CampaignTable& table, const ReplayOptions& options) {
    const auto cases = static_cast<int>(table.cases.size());
    if (!options.case_name.empty() &&
        std::ranges::find(table.cases, options.case_name, &CaseRow::name) == table.cases.end())
        throw InputError(
            fmt::format("{} has no case {}; its cases are {}.", options.file, options.case_name, case_names(table)));
    std::vector<int> left;
    for (int number = 0; number < static_cast<int>(table.members.size()); ++number) {
        const std::string& name = table.cases[static_cast<std::size_t>(number % cases)].name;
        if (!options.case_name.empty() && name != options.case_name) continue;
        if (options.arrangement >= 0 && number / cases != options.arrangement) continue;
        left.push_back(number);
    }
    if (left.empty())
        throw InputError(fmt::format("{} has no arrangement {}; its arrangements are 0 to {}.", options.file,
                                     options.arrangement, static_cast<int>(table.members.size()) / cases - 1));
    return left;
}

int chosen_member(const CampaignTable& table, const ReplayOptions& options) {
    if (options.member >= 0) return options.member;
    const std::vector<int> left = members_left(table, options);
    if (options.worst) {
        const int worst = worst_of(table, left);
        if (worst < 0) throw InputError(fmt::format("{} has no member with a load there yet.", options.file));
        return worst;
    }
    if (left.size() == 1) return left.front();
    throw InputError(
        "Which member? Give its number, --case and --arrangement, or --worst for the one with the largest load.");
}

FrameTimes wanted_times(const ReplaySubject& subject, const ReplayOptions& options) {
    const Scenario& scenario = subject.about.scenario;
    const double end = scenario.general.time_step * scenario.step_count();
    FrameTimes times{.from = 0, .to = end, .every = options.every, .through = 0};
    if (options.worst) {
        times.through = time_of_largest_load(subject);
        if (std::isnan(times.through))
            throw InputError(
                fmt::format("{} keeps no load histories (analysis.keep_history), so it does not say when the largest "
                            "load of member {} came; give --from and --to instead of --worst.",
                            options.file, subject.about.member));
        times.from = std::max(0.0, times.through - round_worst);
        times.to = std::min(end, times.through + round_worst);
    }
    if (!std::isnan(options.from)) times.from = options.from;
    if (!std::isnan(options.to)) times.to = options.to;
    if (std::isnan(times.every)) times.every = times.to - times.from > long_span ? long_every : short_every;
    return times;
}

/// Computes the member and writes its record. Whether it is the member of the file.
bool compute(const ReplayOptions& options, const std::filesystem::path& path) {
    const CampaignTable table = read_campaign_file(options.file);
    const ReplaySubject subject = replay_subject(options.file, table, chosen_member(table, options));
    const FrameSteps steps = frame_steps(wanted_times(subject, options), subject.about.scenario);
    const double end = subject.about.scenario.general.time_step * subject.about.scenario.step_count();
    ProgressLine line(fmt::format("computing member {} (case {}, arrangement {})", subject.about.member,
                                  subject.about.case_name, subject.about.arrangement));
    const MemberResult result = replay(subject, steps, path, {}, [&](double time) { line.show(time / end); });
    if (result.status == MemberStatus::failed) std::fprintf(stderr, "floes: %s\n", result.reason.c_str());
    const std::vector<std::string> found = differences(subject, result);
    if (found.empty()) return true;
    std::fprintf(stderr,
                 "floes: member %d computed now is not the one in %s, which another version or another machine may "
                 "have computed:\n",
                 subject.about.member, options.file.c_str());
    for (const std::string& sentence : found) std::fprintf(stderr, "floes:   %s\n", sentence.c_str());
    return false;
}

template <class Kind, std::size_t count>
Kind kind_named(const std::array<std::string_view, count>& names, const std::string& name) {
    return static_cast<Kind>(std::ranges::find(names, name) - names.begin());
}

PictureStyle style_of(const ReplayOptions& options, const Record& record) {
    PictureStyle style;
    style.view = kind_named<View>(view_names, options.view);
    style.colouring = kind_named<Colouring>(colouring_names, options.colours);
    if (std::sscanf(options.size.c_str(), "%dx%d", &style.width, &style.height) != 2 || style.width < 200 ||
        style.height < 150 || style.width > 8000 || style.height > 8000)
        throw InputError(
            fmt::format("--size {} is no size; give width x height in pixels, as 1280x800.", options.size));
    style.width += style.width % 2;
    style.from = record.time(0);
    style.to = record.time(record.frames() - 1);
    return style;
}

/// The frame of a picture: the one nearest to --at, else the one with the largest surge load.
int pictured_frame(const ReplayOptions& options, const Record& record) {
    if (!std::isnan(options.at)) return record.nearest(options.at);
    const std::vector<double>& surge = record.outcome().history.surge;
    const double step = record.subject().scenario.general.time_step;
    int largest = 0;
    double load = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < record.frames(); ++k) {
        const auto end = static_cast<std::size_t>(std::llround(record.time(k) / step));
        if (end == 0 || end > surge.size() || surge[end - 1] <= load) continue;
        load = surge[end - 1];
        largest = k;
    }
    return largest;
}

void write_picture(const std::filesystem::path& path, const Record& record, const ReplayOptions& options) {
    const PictureStyle style = style_of(options, record);
    const Stage stage(record.subject(), record.outcome(), record.floes());
    const Frame frame = record.read(pictured_frame(options, record));
    const int height = picture_height(style, record.subject());
    const bool vectors = path.extension() == ".svg";
    Canvas canvas = vectors ? Canvas(path, style.width, height) : Canvas(style.width, height);
    draw_picture(canvas, stage, frame, style);
    if (vectors) {
        canvas.finish();
    } else {
        canvas.write_png(path);
    }
}

void write_output(const std::filesystem::path& path, const Record& record, const ReplayOptions& options) {
    if (kind_of(path) == Output::page) write_replay_page(path, record);
    if (kind_of(path) == Output::vtk) write_vtk_series(path, record);
    if (kind_of(path) == Output::picture) write_picture(path, record, options);
    if (kind_of(path) == Output::film) {
        ProgressLine line(fmt::format("drawing {}", path.string()));
        write_film(path, record, style_of(options, record), [&](double done) { line.show(done); });
    }
    std::printf("%s\n", path.c_str());
}

/// A record for the time of the program, beside what is made of it.
class PassingRecord {
  public:
    explicit PassingRecord(const std::filesystem::path& beside) : path_(beside.string() + ".record.h5") {}
    PassingRecord(const PassingRecord&) = delete;
    PassingRecord& operator=(const PassingRecord&) = delete;
    ~PassingRecord() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

void write_outputs(const std::filesystem::path& record_path, const ReplayOptions& options) {
    const Record record(record_path);
    for (const std::string& output : options.outputs)
        if (output != record_path) write_output(output, record, options);
}

/// Whether the member computed is the one in the file.
bool run(const ReplayOptions& options) {
    for (const std::string& output : options.outputs) kind_of(output);
    if (is_record(options.file)) {
        write_outputs(options.file, options);
        return true;
    }
    const auto kept = std::ranges::find(options.outputs, Output::record, kind_of);
    if (kept != options.outputs.end()) {
        const bool same = compute(options, *kept);
        std::printf("%s\n", kept->c_str());
        write_outputs(*kept, options);
        return same;
    }
    const PassingRecord passing(options.outputs.front());
    const bool same = compute(options, passing.path());
    write_outputs(passing.path(), options);
    return same;
}

}  // namespace

void add_replay(CLI::App& program, int& exit_status) {
    auto options = std::make_shared<ReplayOptions>();
    CLI::App* verb = program.add_subcommand("replay", "Watch a member: computes it again and shows how it went");
    verb->add_option("file", options->file, "The campaign file (CAMPAIGN.h5), or a record that floes replay wrote")
        ->required();
    verb->add_option("member", options->member, "The member's number")->check(CLI::NonNegativeNumber);
    verb->callback([options, &exit_status] {
        const LeaveOnSignals leave;
        exit_status = run(*options) ? 0 : 1;
    });
    verb->add_option("--case", options->case_name, "The member of this case ...");
    verb->add_option("--arrangement", options->arrangement, "... and of this arrangement")
        ->check(CLI::NonNegativeNumber);
    verb->add_flag("--worst", options->worst,
                   "The member with the largest load (of that case), 10 s before it and 10 s after it");
    verb->add_option("--from", options->from, "First frame, s");
    verb->add_option("--to", options->to, "Last frame, s");
    verb->add_option("--every", options->every,
                     "Time from frame to frame, s; default: 0.1 s, over more than a minute 0.2 s")
        ->check(CLI::PositiveNumber);
    verb->add_option("-o,--output", options->outputs,
                     "What to make, by its ending; may be repeated: .h5 the record, .html a page that plays it, .png "
                     "or .svg a picture, .mp4, "
                     ".webm, .webp, .gif or .apng a film")
        ->type_size(1)
        ->allow_extra_args(false)
        ->required();
    verb->add_option("--at", options->at, "Time of pictures, s; default: of the largest load among the frames");
    verb->add_option("--view", options->view, "Of pictures and films: perspective, above, below or plan")
        ->check(CLI::IsMember({"perspective", "above", "below", "plan"}))
        ->capture_default_str();
    verb->add_option("--colours", options->colours, "Of pictures and films: ice, piece, speed or utilisation")
        ->check(CLI::IsMember({"ice", "piece", "speed", "utilisation"}))
        ->capture_default_str();
    verb->add_option("--size", options->size, "Of pictures and films, pixels")->capture_default_str();
}

}  // namespace floes
