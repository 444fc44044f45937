#include "draw/replay_output.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "draw/film.hpp"
#include "draw/picture.hpp"
#include "draw/replay_page.hpp"
#include "draw/xdmf_series.hpp"
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

/// Of what the recording shows; of a run without it, the first one.
int frame_of_largest(const Recording& recording) {
    const double step = recording.subject().scenario.general.time_step;
    const RecordingOutcome& outcome = recording.outcome();
    const std::vector<double> asked = asked_history(recording.subject().asked, outcome.history, outcome.hull, step);
    int largest = 0;
    double value = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < recording.frames(); ++k) {
        const auto steps = static_cast<std::size_t>(std::llround(recording.time(k) / step));
        if (steps == 0 || steps > asked.size() || asked[steps - 1] <= value) continue;
        value = asked[steps - 1];
        largest = k;
    }
    return largest;
}

void write_picture(const std::filesystem::path& path, const Recording& recording, const ReplayLook& look) {
    const PictureStyle style = style_of(look, recording);
    const Stage stage(recording.subject(), recording.outcome());
    const Frame frame = recording.read(look.at ? recording.nearest(*look.at) : frame_of_largest(recording));
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
    return recording.time(frame_of_largest(recording));
}

void write(const std::filesystem::path& path, const Recording& recording, const ReplayLook& look,
           const std::function<void(double)>& go_on) {
    switch (kind_of(path)) {
        case ReplayOutput::page:
            return write_replay_page(path, recording, {.start = start_of_page(recording, look)});
        case ReplayOutput::picture:
            return write_picture(path, recording, look);
        case ReplayOutput::film:
            return write_film(path, recording, style_of(look, recording), look.rate, go_on);
        case ReplayOutput::series:
        case ReplayOutput::recording:
            break;
    }
}

}  // namespace

ReplayOutput kind_of(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".h5") return ReplayOutput::recording;
    if (ending == ".html") return ReplayOutput::page;
    if (ending == ".xdmf2") return ReplayOutput::series;
    if (ending == ".png" || ending == ".svg") return ReplayOutput::picture;
    for (const char* film : {".mp4", ".webm", ".webp", ".gif", ".apng"})
        if (ending == film) return ReplayOutput::film;
    throw InputError(fmt::format(
        "What is {} to be? Its ending says: .html a page that plays, .png or .svg a picture, .mp4, .webm, .webp, .gif "
        "or .apng a film, .xdmf2 a series for ParaView, .h5 the recording itself.",
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
                         const std::function<void(double)>& go_on) {
    if (kind_of(path) == ReplayOutput::series) return write_xdmf_series(path, recording);  // three files of its name
    // ffmpeg knows by the ending what to make.
    const AsideFile aside(std::filesystem::path(path).replace_extension(".part" + path.extension().string()));
    write(aside.path(), recording, look, go_on);
    rename_into_place(aside.path(), path);
}

}  // namespace floes
