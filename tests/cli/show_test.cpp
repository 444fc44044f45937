// floes show: every configuration of the repository, to scale and within its frame; what is drawn lies where the
// configuration says; and what is seldom meant is said.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "cli/given.hpp"
#include "cli/verb_output.hpp"
#include "core/error.hpp"
#include "findings/scene.hpp"
#include "page/section_html.hpp"
#include "support/file_bytes.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace show_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

const std::filesystem::path project = FLOES_SOURCE_DIR;

std::vector<std::string> configurations() {
    std::vector<std::string> files;
    for (const char* folder : {"configs", "ensemble/cli/starters"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(project / folder))
            if (entry.path().extension() == ".toml" && !entry.path().filename().string().starts_with("targets"))
                files.push_back(entry.path().string());
    std::ranges::sort(files);
    return files;
}

std::vector<Figure::Points> areas_of(const Figure& figure, const std::string& style) {
    std::vector<Figure::Points> areas;
    for (const Figure::Mark& mark : figure.marks)
        if (const auto* area = std::get_if<Figure::Area>(&mark); area != nullptr && area->style == style)
            areas.push_back(area->outline);
    return areas;
}

std::vector<Figure::Dot> crosses_of(const Figure& figure) {
    std::vector<Figure::Dot> crosses;
    for (const Figure::Mark& mark : figure.marks)
        if (const auto* dot = std::get_if<Figure::Dot>(&mark); dot != nullptr && dot->cross) crosses.push_back(*dot);
    return crosses;
}

/// Least and largest x.
std::pair<double, double> reach_along(const Figure::Points& outline) {
    const auto [low, high] = std::ranges::minmax(outline, {}, [](const auto& point) { return point.first; });
    return {low.first, high.first};
}

/// The first point of a mark that lies outside the axes; empty where there is none.
std::string outside(const Figure& figure) {
    const double rounding = 1e-9 * (figure.x.high - figure.x.low);
    std::string found;
    const auto look = [&](double x, double y, const std::string& what) {
        if (std::isnan(x) || std::isnan(y)) return;  // a gap of a line
        if (x >= figure.x.low - rounding && x <= figure.x.high + rounding && y >= figure.y.low - rounding &&
            y <= figure.y.high + rounding)
            return;
        if (found.empty()) found = fmt::format("{} at {}, {}", what, x, y);
    };
    for (const Figure::Mark& mark : figure.marks) {
        if (const auto* area = std::get_if<Figure::Area>(&mark))
            for (const auto& [x, y] : area->outline) look(x, y, "area " + area->style);
        if (const auto* line = std::get_if<Figure::Line>(&mark))
            for (const auto& [x, y] : line->points) look(x, y, "line " + line->style);
        if (const auto* dot = std::get_if<Figure::Dot>(&mark)) look(dot->x, dot->y, "dot " + dot->style);
        if (const auto* words = std::get_if<Figure::Words>(&mark)) look(words->x, words->y, words->words);
    }
    return found;
}

/// On the screen: units along x over those along y, for a metre of each.
double ratio_of_scales(const Figure& figure) {
    constexpr double beside = 80;  // of axes and labels
    constexpr double below = 74;
    return (figure.size.width - beside) / (figure.x.high - figure.x.low) * (figure.y.high - figure.y.low) /
           (figure.size.height - below);
}

/// Whether tags are closed in the order in which they were opened, with attributes in quotes.
bool is_well_formed(const std::string& text) {
    static const std::regex tag(R"(<(/?)([a-zA-Z]+)((?:\s+[a-zA-Z:-]+="[^"<]*")*)\s*(/?)>)");
    std::vector<std::string> open;
    std::size_t end = 0;
    for (auto at = std::sregex_iterator(text.begin(), text.end(), tag); at != std::sregex_iterator(); ++at) {
        const auto begin = static_cast<std::size_t>(at->position());
        if (text.substr(end, begin - end).find('<') != std::string::npos) return false;
        end = begin + static_cast<std::size_t>(at->length());
        if ((*at)[1].length() > 0) {
            if (open.empty() || open.back() != (*at)[2]) return false;
            open.pop_back();
        } else if ((*at)[4].length() == 0) {
            open.push_back((*at)[2]);
        }
    }
    return open.empty() && text.find('<', end) == std::string::npos;
}

TEST(Show, DrawsEveryConfigurationToScaleAndWithinItsFrame) {
    const std::vector<std::string> files = configurations();
    ASSERT_GE(files.size(), 60u);
    for (const std::string& file : files) {
        SCOPED_TRACE(file);
        const Campaign campaign = load_campaign(file, {});
        const Section told = scene(campaign, campaign.cases.size() - 1, 0);
        ASSERT_GE(told.figures.size(), 2u);
        EXPECT_THAT(areas_of(told.figures[0], "ice"), SizeIs(testing::Ge(std::size_t{1})));
        for (const Figure& figure : told.figures) {
            EXPECT_NEAR(ratio_of_scales(figure), 1, 1e-9) << figure.description;
            EXPECT_EQ(outside(figure), "") << figure.description;
            EXPECT_THAT(areas_of(figure, "structure"), Not(IsEmpty())) << figure.description;
        }
        EXPECT_TRUE(is_well_formed(figures_file(told)));
    }
}

TEST(Show, KnowsWhatIsNotWellFormed) {
    EXPECT_TRUE(is_well_formed("<svg a=\"1\"><path d=\"M0 0\"/>words</svg>"));
    EXPECT_FALSE(is_well_formed("<svg><g></svg></g>"));
    EXPECT_FALSE(is_well_formed("<svg>1 < 2</svg>"));
    EXPECT_FALSE(is_well_formed("<svg>"));
}

TEST(Show, AHullOf60MetresIs60MetresByTheAxes) {
    const Campaign campaign = load_campaign((project / "configs/barge.toml").string(), {});
    const double start = campaign.cases.front().scenario.structure.start;
    const Section told = scene(campaign, 0, 0);
    const auto [stern, bow] = reach_along(areas_of(told.figures[0], "structure").at(0));
    EXPECT_NEAR(bow - stern, 60, 1e-9);
    EXPECT_NEAR((bow + stern) / 2, start, 1e-9);
    double low = 0;
    double high = 0;
    const std::vector<Figure::Points> abeam = areas_of(told.figures[1], "structure");
    for (const auto& [x, height] : abeam.at(0)) {
        low = std::min(low, height);
        high = std::max(high, height);
    }
    EXPECT_NEAR(low, -4, 1e-9);  // its draught
    EXPECT_NEAR(high, 3, 1e-9);
}

TEST(Show, DrawsAnchorsAtTheirPlaces) {
    const Campaign campaign = load_campaign((project / "configs/kulluk.toml").string(), {});
    const Scenario& scenario = campaign.cases.front().scenario;
    const Section told = scene(campaign, 0, 0);
    ASSERT_EQ(told.figures.size(), 3u);
    const std::vector<Figure::Dot> crosses = crosses_of(told.figures[2]);
    ASSERT_EQ(crosses.size(), scenario.moorings.lines.size());
    for (std::size_t k = 0; k < crosses.size(); ++k) {
        const MooringLine& line = scenario.moorings.lines[k];
        EXPECT_NEAR(crosses[k].x, scenario.structure.start + line.x + line.distance * std::cos(line.azimuth), 1e-6);
        EXPECT_NEAR(crosses[k].y, line.z + line.distance * std::sin(line.azimuth), 1e-6);
    }
}

TEST(Show, DrawsLinesOfATurretFromItsAxisDownToTheBed) {
    const Campaign campaign = load_campaign((project / "ensemble/cli/starters/turret.toml").string(), {});
    const Scenario& scenario = campaign.cases.front().scenario;
    const Section told = scene(campaign, 0, 0);
    ASSERT_EQ(told.figures.size(), 4u);
    for (const Figure::Dot& anchor : crosses_of(told.figures[3])) EXPECT_NEAR(anchor.y, -100, 1e-9);
    const HangingLine& ahead = scenario.moorings.hanging.at(1);
    EXPECT_NEAR(crosses_of(told.figures[3]).at(1).x,
                scenario.moorings.turret.ahead + ahead.fairlead.x() + ahead.distance, 1e-9);
}

TEST(Show, DrawsTheWayAndItsMeasuredPart) {
    const Campaign campaign = load_campaign((project / "configs/smoke.toml").string(), {});
    const Scenario& scenario = campaign.cases.front().scenario;
    const Tow tow{scenario.structure.start, scenario.structure.speed};
    const Figure plan = scene(campaign, 0, 0).figures.front();
    std::vector<Figure::Points> measured;
    for (const Figure::Mark& mark : plan.marks)
        if (const auto* line = std::get_if<Figure::Line>(&mark); line != nullptr && line->style == "c1 thick")
            measured.push_back(line->points);
    ASSERT_EQ(measured.size(), 1u);
    const auto [from, to] = reach_along(measured.front());
    EXPECT_NEAR(from, tow.x(scenario.analysis.steady_start), 0.01);
    EXPECT_NEAR(to, tow.x(scenario.analysis.steady_start + scenario.analysis.window), 1e-9);
}

/// What `floes show` says of the smoke test with other keys.
std::vector<std::string> oddities(const std::string& config, const std::vector<std::string>& overrides) {
    return scene(load_campaign((project / config).string(), overrides), 0, 0).notes;
}

TEST(Show, SaysWhatIsSeldomMeant) {
    EXPECT_THAT(oddities("configs/smoke.toml", {}), IsEmpty());
    EXPECT_THAT(oddities("configs/smoke.toml", {"structure.start_m=0.2"}),
                ElementsAre(HasSubstr("before it meets a floe")));
    const std::string line =
        "[[33.8, 9.1, 195.0, 1250.0, 500.0, 433.0, 0.0], [33.8, -9.1, 345.0, 1250.0, 500.0, "
        "433.0, 0.0], [-33.8, 9.1, 165.0, 1250.0, 500.0, 433.0, 0.0], "
        "[-33.8, -9.1, 195.0, 1250.0, 500.0, 433.0, 0.0]]";
    EXPECT_THAT(oddities("configs/kulluk.toml", {"moorings.lines=" + line}),
                ElementsAre(HasSubstr("Mooring line 1 leads from its fairlead across the hull")));
    EXPECT_THAT(oddities("configs/kulluk.toml", {}), IsEmpty());
}

/// Of the smoke test with other floes than it lays.
std::vector<std::string> oddities_of(void (*change)(std::vector<Floe>&)) {
    const Scenario scenario = load_campaign((project / "configs/smoke.toml").string(), {}).cases.front().scenario;
    FloeSet floes = make_arrangement(scenario, 1, 0);
    change(floes.floes);
    return scene_oddities(scenario, floes);
}

TEST(Show, SaysThatTheIceLiesElsewhereOrEndsEarly) {
    EXPECT_THAT(oddities_of([](std::vector<Floe>&) {}), IsEmpty());
    EXPECT_THAT(oddities_of([](std::vector<Floe>& floes) {
                    for (Floe& floe : floes) floe.pose.z += 4;
                }),
                ElementsAre(HasSubstr("no floe lies on the way of the hull")));
    EXPECT_THAT(oddities_of([](std::vector<Floe>& floes) {
                    std::erase_if(floes, [](const Floe& floe) { return floe.pose.x > 3.2; });
                }),
                ElementsAre(HasSubstr("the bow is past the last floe")));
}

TEST(Show, SaysThatAHullFromAFileStandsHigherThanItIsLong) {
    Scenario scenario = load_campaign((project / "configs/smoke.toml").string(), {}).cases.front().scenario;
    const FloeSet floes = make_arrangement(scenario, 1, 0);
    const auto with_box = [&](double half_length, double half_height) {
        std::vector<std::vector<double>> corners;
        for (const double x : {-half_length, half_length})
            for (const double height : {-half_height, half_height})
                for (const double z : {-0.3, 0.3}) corners.push_back({0, 0, x, height, z});
        scenario.structure.shape.set_kind(HullKind::file);
        scenario.structure.shape.part_list() = "hull";
        scenario.structure.shape.set_pieces(corners);
        return scene_oddities(scenario, floes);
    };
    EXPECT_THAT(with_box(0.6, 0.3), IsEmpty());
    EXPECT_THAT(with_box(0.6, 0.9), ElementsAre(HasSubstr("if it lies on its side")));
}

std::string show(std::vector<std::string> words) {
    words.insert(words.begin(), "show");
    return verb_output(add_show, words);
}

TEST(Show, DrawsInTheLettersOfTheTerminal) {
    const std::string smoke = (project / "configs/smoke.toml").string();
    setenv("LC_ALL", "C", 1);
    const std::string plain = show({smoke});
    EXPECT_TRUE(std::ranges::all_of(plain, [](char c) { return static_cast<unsigned char>(c) < 0x80; }));
    EXPECT_THAT(plain, HasSubstr("# hull  o ice  % ice sheet  - way  = measured"));
    setenv("LC_ALL", "C.UTF-8", 1);
    EXPECT_THAT(show({smoke}), HasSubstr("█ hull  ⣿ ice  ░ ice sheet  ─ way  ━ measured"));
    unsetenv("LC_ALL");
}

TEST(Show, WritesAPictureOrAPageOfTheCasesThatDiffer) {
    const TemporaryFolder folder;
    const std::string tank = (project / "ensemble/cli/starters/tank.toml").string();
    const std::string picture = folder / "a.svg";
    EXPECT_EQ(show({tank, "-o", picture}), picture + "\n");
    EXPECT_THAT(file_text(picture), HasSubstr("tank, case thin, arrangement 0"));
    EXPECT_EQ(show({tank, "-o", picture, "--case", "thick", "--arrangement", "3"}), picture + "\n");
    EXPECT_THAT(file_text(picture), HasSubstr("tank, case thick, arrangement 3"));
    const std::string page = folder / "a.html";
    show({tank, "-o", page});
    EXPECT_THAT(file_text(page), testing::AllOf(HasSubstr("case thin"), HasSubstr("case thick")));
    EXPECT_THROW(show({tank, "--case", "thicker"}), InputError);
    EXPECT_THROW(show({tank, "-o", folder / "a.gif"}), CommandLineEnd);
}

}  // namespace show_test
}  // namespace floes
