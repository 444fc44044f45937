// Pictures and films: what is drawn where, in which colour.

#include "draw/picture.hpp"
#include "draw/film.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>

#include "core/error.hpp"
#include "draw/canvas.hpp"
#include "shapes/moorings.hpp"
#include "support/file_bytes.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace picture_test {

using testing::HasSubstr;

/// One floe of 3 x 3 elements ahead of the structure, which stands at x = 2 m.
RecordingSubject subject() {
    RecordingSubject made;
    made.campaign = "quiet";
    made.case_name = "one";
    made.scenario.field.floes = 1;
    made.scenario.elements.form = ElementForm::squares;
    made.floes = floes_of(made.scenario);
    return made;
}

RecordingOutcome outcome() {
    RecordingOutcome made;
    made.history.surge.assign(500, 10.0);
    made.history.sway.assign(500, 0.0);
    made.history.heave.assign(500, 5.0);
    made.breaks.push_back({.time = 4, .floe = 0, .joint = 0, .mode = FailureMode::bending});
    return made;
}

Frame frame(double time) {
    Frame made;
    made.step = static_cast<int>(std::lround(time / 0.02));
    made.time = time;
    made.structure.position.x() = 2;
    made.load = {-10, 5, 0};
    for (int k = 0; k < 9; ++k) {
        made.elements.push_back({.position = {3.5 + 0.2 * (k % 3), 0.0, 0.2 * (k / 3) - 0.2}});
        made.pieces.push_back(0);
        made.utilisation.push_back(k == 4 ? 1.0 : 0.0);
    }
    return made;
}

Colour pixel(const Canvas& canvas, const Vec2& at) {
    const auto first = 4 * (static_cast<std::size_t>(std::lround(at.y())) * static_cast<std::size_t>(canvas.width()) +
                            static_cast<std::size_t>(std::lround(at.x())));
    const auto bytes = canvas.pixels();
    return {bytes[first + 2] / 255.0, bytes[first + 1] / 255.0, bytes[first] / 255.0};
}

void expect_colour(const Colour& found, const Colour& wanted) {
    EXPECT_NEAR(found.red, wanted.red, 0.02);
    EXPECT_NEAR(found.green, wanted.green, 0.02);
    EXPECT_NEAR(found.blue, wanted.blue, 0.02);
}

// Ice comes from where the structure goes; a straight tow does not say so.
TEST(Stage, SaysFromWhereTheIceComes) {
    EXPECT_EQ(Stage(subject(), {}).ice_words(1), "");
    RecordingSubject turning = subject();
    turning.scenario.path.legs = {{.heading = 0, .speed = 0.4, .time = 4}, {.heading = 0.5, .speed = 0.2, .time = 2}};
    const Stage stage(turning, {});
    EXPECT_NEAR(stage.drift(), (4 * 0.4 + 2 * 0.2) / 6, 1e-9);
    EXPECT_EQ(stage.ice_words(1), "ice from 0° at 0.4 m/s");
    EXPECT_EQ(stage.ice_words(5), "ice from 29° at 0.2 m/s");
    EXPECT_EQ(stage.ice_words(7), "ice at rest");
}

TEST(Projection, PutsTheTargetInTheMiddleAndAMetreToScale) {
    for (const View view : {View::perspective, View::above, View::side, View::below, View::plan}) {
        const Camera seen = camera(view, subject(), 2);
        const Projection projection(seen, 800, 600);
        EXPECT_LT((projection.at(seen.target) - Vec2(400, 300)).norm(), 1e-9);
        const Vec3 forward = (seen.target - seen.eye).normalized();
        const Vec3 right = forward.cross(seen.up).normalized();
        EXPECT_NEAR(projection.at(seen.target + right).x() - 400, 600 / seen.height, 1e-9);
        EXPECT_LT(projection.at(seen.target + right.cross(forward)).y(), 300);
    }
}

// Half the height of the picture is tan(angle / 2) of the distance.
TEST(Projection, SeesItsAngleOfView) {
    const Camera seen = camera(View::above, subject(), 2);
    const double half = (seen.target - seen.eye).norm() * std::tan(seen.angle / 2);
    EXPECT_NEAR(Projection(seen, 100, 100).at(seen.target + half * seen.up).y(), 0, 1e-9);
}

TEST(Plan, ShowsTheChannelToScaleWithTheTowToTheRight) {
    const Channel channel = subject().channel();
    const Camera seen = camera(View::plan, subject(), 2);
    const Projection projection(seen, 1000, 200);
    const Vec2 a = projection.at({2, 0, 0});
    const Vec2 b = projection.at({3, 0, 1});
    EXPECT_NEAR(b.x() - a.x(), projection.scale(), 1e-9);
    EXPECT_NEAR(b.y() - a.y(), projection.scale(), 1e-9);
    EXPECT_NEAR(projection.scale(), 200 / (2 * channel.outer_edge), 1e-9);
}

// Every element of a polygon shows its own corners from above, and lines where the floe ends.
TEST(Faces, OfPolygonsHaveTheirCorners) {
    RecordingSubject made = subject();
    made.scenario.field.floes = 3;
    made.scenario.shapes.kind = ShapeKind::voronoi;
    made.floes = floes_of(made.scenario, {1, 0});
    const IceLayout layout(made.floes);
    Frame seen;
    for (std::size_t i = 0; i < layout.elements.size(); ++i) {
        seen.elements.push_back({.position = {3 + 0.05 * static_cast<double>(i), 0.1, 0}});
        seen.pieces.push_back(0);
        seen.utilisation.push_back(0);
    }
    const Stage stage(made, {});
    const Projection projection(camera(View::plan, made, 2), 4000, 800);
    const std::vector<Face> faces = stage.faces(seen, projection, {4000, 800}, Colouring::ice);
    for (std::size_t corners = 3; corners < 9; ++corners) {
        if (corners == 4) continue;  // as ice sheets and walls have
        const auto wanted = std::ranges::count_if(
            layout.elements, [&](const IceLayout::LaidElement& one) { return one.corners.size() == corners; });
        EXPECT_EQ(std::ranges::count_if(faces, [&](const Face& one) { return one.corners.size() == corners; }), wanted);
    }
}

// What lies between the eye and the structure would hide it: ice sheets and floes alongside.
TEST(Side, ShowsTheTowToTheRightAndCutsAwayWhatIsNearer) {
    const Camera seen = camera(View::side, subject(), 2);
    const Projection projection(seen, 1000, 500);
    EXPECT_GT(projection.at({3, 0, 0}).x(), projection.at({2, 0, 0}).x());
    EXPECT_GT(projection.at({2, -0.4, 0}).y(), projection.at({2, 0, 0}).y());
    const double radius = subject().scenario.structure.shape.largest_radius();
    EXPECT_TRUE(projection.before({2, 0, radius}));
    EXPECT_FALSE(projection.before({2, 0, 1.1 * radius}));
    PictureStyle style{.view = View::side, .width = 800, .height = 600};
    Canvas canvas(style.width, picture_height(style, subject()));
    draw_picture(canvas, Stage(subject(), outcome()), frame(1), style);
    const Projection drawn(seen, style.width, canvas.height() - std::round(0.17 * style.height));
    const Colour hull = pixel(canvas, drawn.at({2, -0.2, 0}));
    EXPECT_GT(hull.red, 2 * hull.blue) << "an ice sheet hides the structure";
}

TEST(Picture, ShowsTheTowAndTheScalesOfLengthsAndForces) {
    const PictureStyle style{.view = View::above, .width = 1280, .height = 800};
    Canvas canvas(style.width, picture_height(style, subject()));
    draw_picture(canvas, Stage(subject(), outcome()), frame(1), style);
    const double bottom = canvas.height() - std::round(0.17 * style.height);
    const Projection projection(camera(style.view, subject(), 2), style.width, bottom);
    const double radius = subject().scenario.structure.shape.largest_radius();
    expect_colour(pixel(canvas, projection.at({2 + 1.4 * radius, subject().scenario.structure.shape.top(), 0})),
                  tow_orange);
    // From the first bar's left end to its right one there are 60 pixels and more, a round number of metres.
    const auto is_bright = [&](double x) { return pixel(canvas, {x, bottom - 42}).blue > 0.9; };
    double x = 1280 - 480;
    while (!is_bright(x) && x < 1279) ++x;
    const double from = x;
    while (is_bright(x) && x < 1279) ++x;
    const double metres = (x - from) / projection.scale();
    EXPECT_GE(x - from, 60);
    const double power = std::pow(10, std::floor(std::log10(metres * 1.02)));
    EXPECT_THAT(std::round(metres / power), testing::AnyOf(1.0, 2.0, 5.0)) << metres;
    EXPECT_NEAR(metres / power, std::round(metres / power), 0.15) << "the bar is not as long as it says";
}

TEST(Picture, HasIceStructureAndSeaInTheirColours) {
    PictureStyle style{.view = View::above, .width = 800, .height = 600};
    const Stage stage(subject(), outcome());
    Canvas canvas(style.width, picture_height(style, subject()));
    const double drawn = canvas.height() - std::round(0.17 * style.height);
    const Projection projection(camera(style.view, subject(), 2), style.width, drawn);
    const Vec2 floe = projection.at({3.7, 0.0165, 0.03});
    draw_picture(canvas, stage, frame(1), style);
    expect_colour(pixel(canvas, floe), lit(white_ice, Vec3::UnitY()));
    expect_colour(pixel(canvas, projection.at({2.0, 0.122, 0.4})), lit(structure_yellow, Vec3::UnitY()));
    expect_colour(pixel(canvas, projection.at({3.0, 0, 1.2})), sea);
    draw_picture(canvas, stage, frame(4), style);
    expect_colour(pixel(canvas, floe), lit(broken_ice, Vec3::UnitY()));
    EXPECT_EQ(stage.floes(frame(3.99)).broken, 0);
    EXPECT_EQ(stage.floes(frame(4)).broken, 1);
    EXPECT_EQ(stage.floes(frame(4)).all, 1);
    style.colouring = Colouring::utilisation;
    draw_picture(canvas, stage, frame(4), style);
    expect_colour(pixel(canvas, projection.at({3.7, 0.0165, 0.03})), lit(scale_colour(1), Vec3::UnitY()));
    expect_colour(pixel(canvas, projection.at({3.5, 0.0165, 0.17})), lit(scale_colour(0), Vec3::UnitY()));
}

// A floe pushed 20 mm under another one is hidden, though the middles of its elements may lie nearer to the eye.
TEST(Picture, HidesWhatLiesBehind) {
    const PictureStyle style{.view = View::perspective, .width = 800, .height = 600};
    Frame both = frame(4);
    for (int k = 0; k < 9; ++k) {
        both.elements.push_back(both.elements[static_cast<std::size_t>(k)]);
        both.elements.back().position += Vec3(-0.05, -0.053, 0.05);
        both.pieces.push_back(9);
        both.utilisation.push_back(1);
    }
    RecordingSubject two = subject();
    two.floes = floes_at(two.scenario, std::vector<PlanarPose>(2));
    const Stage stage(two, outcome());
    Canvas canvas(style.width, picture_height(style, subject()));
    draw_picture(canvas, stage, both, style);
    const Projection projection(camera(style.view, subject(), 2), style.width,
                                canvas.height() - std::round(0.17 * style.height));
    for (const double x : {3.45, 3.55, 3.7, 3.95})
        for (const double z : {-0.25, 0.03, 0.24})
            expect_colour(pixel(canvas, projection.at({x, 0.0165, z})), lit(broken_ice, Vec3::UnitY()));
}

// Two faces that pass through each other: each is seen where it is nearer.
TEST(DepthBuffer, DrawsTheNearerOfTwoAtEachPixel) {
    DepthBuffer buffer(40, 10, {0, 0, 0});
    buffer.fill(std::array<Vec3, 4>{Vec3(0, 0, 1), Vec3(40, 0, 1), Vec3(40, 10, 1), Vec3(0, 10, 1)}, {1, 0, 0});
    buffer.fill(std::array<Vec3, 4>{Vec3(0, 0, 0), Vec3(40, 0, 2), Vec3(40, 10, 2), Vec3(0, 10, 0)}, {0, 1, 0});
    const std::vector<std::uint8_t> pixels = buffer.pixels();
    for (std::size_t k = 0; k < 40; ++k) {
        EXPECT_EQ(pixels[4 * (200 + k) + 2], k < 20 ? 255 : 0) << k;
        EXPECT_EQ(pixels[4 * (200 + k) + 1], k < 20 ? 0 : 255) << k;
    }
}

// Half of each pixel along an edge.
TEST(DepthBuffer, SmoothsEdges) {
    DepthBuffer buffer(4, 4, {0, 0, 0});
    buffer.fill(std::array<Vec3, 4>{Vec3(0, 0, 1), Vec3(1.5, 0, 1), Vec3(1.5, 4, 1), Vec3(0, 4, 1)}, {1, 1, 1});
    const std::vector<std::uint8_t> pixels = buffer.pixels();
    EXPECT_EQ(pixels[0], 255);
    EXPECT_EQ(pixels[4], 128);
    EXPECT_EQ(pixels[8], 0);
}

TEST(Picture, IsTheSameBytesAgain) {
    const PictureStyle style{.width = 400, .height = 300};
    const Stage stage(subject(), outcome());
    const auto drawn = [&] {
        Canvas canvas(style.width, picture_height(style, subject()));
        draw_picture(canvas, stage, frame(1), style);
        return canvas.png();
    };
    EXPECT_EQ(drawn(), drawn());
}

// Every load of the run, of whatever step the frame is.
TEST(Picture, KeepsTheArrowsOfTheLoadInTheFrame) {
    RecordingOutcome large = outcome();
    large.history.heave.assign(500, 30.0);
    large.history.sway[7] = -20;
    const Stage stage(subject(), large);
    const Vec2 size(800, 500);
    for (const View view : {View::perspective, View::above, View::side, View::below}) {
        const Projection projection(camera(view, subject(), 2), size.x(), size.y());
        const double metres = metres_a_newton(stage, frame(1), projection, size);
        EXPECT_GT(metres, 0);
        const double top = subject().scenario.structure.shape.top();
        for (const Vec3& load : {Vec3(-10, 30, 0), Vec3(-10, 30, -20), Vec3(0, 30, 0), Vec3(-10, 0, -20)}) {
            const Vec2 tip = projection.at(Vec3(2, top, 0) + metres * load);
            EXPECT_TRUE(tip.x() > 0 && tip.y() > 0 && tip.x() < size.x() && tip.y() < size.y()) << tip.transpose();
        }
    }
}

/// The same on a line that hangs under the floe to an anchor abeam.
RecordingSubject moored_subject() {
    RecordingSubject made = subject();
    made.scenario.moorings.mass = 100;
    made.scenario.moorings.hanging = {{.cable = {.length = 8, .weight = 1, .stiffness = 1e6}}};
    return made;
}

TEST(Picture, HasMooringLinesBelowTheIceAndInTheSea) {
    const PictureStyle style{.view = View::above, .width = 1280, .height = 800};
    Frame held = frame(1);
    held.lines = {{.line = 0, .fairlead = {3.7, -0.4, 0.03}, .anchor = {3.7, -4, 6}, .tension = 10}};
    const Stage stage(moored_subject(), outcome());
    Canvas canvas(style.width, picture_height(style, moored_subject()));
    draw_picture(canvas, stage, held, style);
    const double share = 0.17 + 3 * 0.075;  // of the strips
    const Projection projection(camera(style.view, moored_subject(), 2), style.width,
                                canvas.height() - std::round(share * style.height));
    expect_colour(pixel(canvas, projection.at({3.7, 0.0165, 0.1})), lit(white_ice, Vec3::UnitY()));
    const std::vector<Vec3> points =
        course(moored_subject().scenario.moorings, 0, held.lines.front().fairlead, held.lines.front().anchor);
    int seen = 0;
    for (const Vec3& point : points) {
        const Vec2 at = projection.at(point);
        if (point.z() < 0.7 || point.z() > 1.2) continue;
        const Colour found = pixel(canvas, at);
        ++seen;
        EXPECT_GT(found.red, sea.red + 0.1) << at.transpose();
        EXPECT_GT(found.blue, found.green + 0.05);
    }
    EXPECT_GT(seen, 3);
}

TEST(Strips, AreOfWhatIsAskedAndOfAHullThatGivesWay) {
    const auto words = [](const RecordingSubject& of) {
        std::vector<std::string> found;
        for (const HistoryStrip& strip : strips_of(of, {})) found.push_back(strip.words);
        return found;
    };
    using testing::ElementsAre;
    EXPECT_THAT(words(subject()), ElementsAre("surge load"));
    RecordingSubject moored = moored_subject();
    EXPECT_THAT(words(moored), ElementsAre("surge load", "offset", "line tension", "heading"));
    moored.asked = {AskedOf::mooring_force, 1};
    EXPECT_THAT(words(moored), ElementsAre("mooring force over 1 s", "offset", "line tension", "heading"));
    moored.asked = {AskedOf::offset, 1};
    EXPECT_THAT(words(moored), ElementsAre("offset", "line tension", "heading"));
    moored.asked = {AskedOf::tension, 1};
    EXPECT_THAT(words(moored), ElementsAre("largest line tension", "offset", "heading"));
    RecordingOutcome swung = outcome();
    swung.hull = {.mooring_force = {2e6, 4e6}, .offset = {1, 2}, .yaw = {0, std::numbers::pi / 2}, .tension = {1e6, 0}};
    moored.asked = {AskedOf::mooring_force, 0.01};
    const std::vector<HistoryStrip> strips = strips_of(moored, swung);
    EXPECT_EQ(strips.at(0).unit, "kN");
    EXPECT_THAT(strips.at(0).values, ElementsAre(2000, 4000));
    EXPECT_THAT(strips.at(3).values, ElementsAre(0, testing::DoubleEq(90)));
}

TEST(Picture, SaysWhatIsLargestInItsMoment) {
    RecordingSubject moored = moored_subject();
    moored.asked = {AskedOf::offset, 1};
    RecordingOutcome swung = outcome();
    swung.hull.offset.assign(500, 1.0);
    swung.hull.offset[99] = 3;  // at 2 s
    swung.hull.offset[299] = 2;
    const Stage stage(moored, swung);
    EXPECT_EQ(moment_words(stage, frame(2), {}), "largest offset: 3 m");
    EXPECT_EQ(moment_words(stage, frame(6), {}), "");
    EXPECT_EQ(moment_words(stage, frame(6), {.from = 4, .to = 8}), "largest offset: 2 m");
}

// Of a field without end a record has floes that a frame does not show: report and replay keep other frames.
TEST(Stage, CountsTheFloesThatTheFrameShows) {
    RecordingSubject two = subject();
    two.floes = floes_at(two.scenario, std::vector<PlanarPose>(2));
    const Stage stage(two, outcome());
    Frame seen = frame(4);
    for (int k = 0; k < 9; ++k) seen.ids.push_back(9 + k);
    EXPECT_EQ(stage.floes(seen).all, 1);
    EXPECT_EQ(stage.floes(seen).broken, 0) << "the other one broke";
    seen.ids.clear();
    EXPECT_EQ(stage.floes(seen).broken, 1);
}

TEST(Picture, TellsTheEndsOfAShortTimeApart) {
    EXPECT_EQ(ends_of_axis(0.2, 149.6), (std::pair<std::string, std::string>("0 s", "150 s")));
    EXPECT_EQ(ends_of_axis(0, 0.1), (std::pair<std::string, std::string>("0 s", "0.1 s")));
    EXPECT_EQ(ends_of_axis(61.25, 64.75), (std::pair<std::string, std::string>("61.3 s", "64.8 s")));
}

TEST(Picture, IsAFileOfVectorsToo) {
    const TemporaryFolder folder;
    const PictureStyle style{.width = 400, .height = 300};
    Canvas canvas(folder / "a.svg", style.width, picture_height(style, subject()));
    draw_picture(canvas, Stage(subject(), outcome()), frame(1), style);
    canvas.finish();
    EXPECT_THAT(file_text(folder / "a.svg"),
                testing::AllOf(HasSubstr("<svg"), HasSubstr("</svg>"), HasSubstr("width=\"400px\" height=\"300px\"")));
    EXPECT_THROW(Canvas(folder / "no/such/folder.svg", 10, 10), RunError);
}

/// A recording of `frames` frames at `path`.
void write_recording(const std::filesystem::path& path, int frames) {
    RecordingSubject about = subject();
    about.configuration =
        "[field]\nfloes = 24\nconcentration_percent = 50.0\n[analysis]\nsteady_start_s = 30.0\nwindow_s = "
        "30.0\n[[case]]\nname = \"one\"\n";
    RecordingWriter writer(path, about);
    for (int k = 0; k < frames; ++k) writer.add(frame(k + 1));
    writer.finish(outcome());
}

TEST(Film, IsAnAnimatedPngWithoutFfmpeg) {
    const TemporaryFolder folder;
    write_recording(folder / "a.h5", 3);
    double done = 0;
    write_film(folder / "a.apng", Recording(folder / "a.h5"), {.width = 320, .height = 200}, 25,
               [&](double share) { done = share; });
    EXPECT_EQ(done, 1);
    const std::string bytes = file_text(folder / "a.apng");
    EXPECT_EQ(bytes.substr(1, 3), "PNG");
    const std::size_t control = bytes.find("acTL");
    ASSERT_NE(control, std::string::npos);
    EXPECT_EQ(bytes.substr(control + 4, 4), std::string({0, 0, 0, 3}));
    int frames = 0;
    for (std::size_t at = bytes.find("fcTL"); at != std::string::npos; at = bytes.find("fcTL", at + 1)) ++frames;
    EXPECT_EQ(frames, 3);
    EXPECT_EQ(bytes.substr(bytes.size() - 8, 4), "IEND");
}

TEST(Film, SaysWhatIsMissing) {
    const TemporaryFolder folder;
    write_recording(folder / "a.h5", 1);
    const Recording recording(folder / "a.h5");
    const auto film = [&](const char* name) {
        return refusal([&] { write_film(folder / name, recording, {.width = 320, .height = 200}, 25, [](double) {}); });
    };
    EXPECT_THAT(film("a.avi"), HasSubstr("no ending of a film"));
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", "/nowhere", 1);
    EXPECT_THAT(film("a.mp4"), HasSubstr("install the package ffmpeg"));
    std::ofstream(folder / "ffmpeg") << "#!/bin/sh\nexit 1\n";  // one that fails
    std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
    ::setenv("PATH", (folder / "").parent_path().c_str(), 1);
    EXPECT_THROW(film("a.mp4"), RunError);
    ::setenv("PATH", path.c_str(), 1);
}

TEST(Film, IsNotWaitedForWhereFfmpegHangs) {
    const TemporaryFolder folder;
    write_recording(folder / "a.h5", 1);
    const Recording recording(folder / "a.h5");
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", ((folder / "").parent_path().string() + ":" + path).c_str(), 1);
    for (const auto& [does, said] : {std::pair{"exec sleep 300", "took no picture within 200 ms and was ended"},
                                     {"cat > /dev/null; exec sleep 300", "did not end within 1.2 s and was ended"}}) {
        std::ofstream(folder / "ffmpeg") << "#!/bin/sh\n" << does << "\n";
        std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
        EXPECT_THAT(
            [&] {
                write_film(
                    folder / "a.mp4", recording, {.width = 640, .height = 400}, 25, [](double) {}, Seconds(0.2));
            },
            testing::ThrowsMessage<RunError>(HasSubstr(said)));
    }
    ::setenv("PATH", path.c_str(), 1);
}

TEST(Film, IsKnownBeforehandToNeedAnEncoder) {
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", "/nowhere", 1);
    EXPECT_THAT(refusal([] { expect_encoder("a.gif"); }), HasSubstr("install the package ffmpeg"));
    for (const char* other : {"a.apng", "a.html", "a.h5"}) expect_encoder(other);
    ::setenv("PATH", path.c_str(), 1);
}

}  // namespace picture_test
}  // namespace floes
