// The loads of a year as a finding: of cases with known tails, of a design between its points, and what is refused.

#include "match/year.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/random.hpp"
#include "match/synthetic_wave.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace year_test {

using testing::HasSubstr;
using testing::Not;

constexpr double window = 100;  // s
constexpr int peaks_a_window = 20;
constexpr double hour = 3600;

/// Exponential peaks above 1.5 times the scale of the case, of the scale; 20 of them in 100 s.
MatchWave measured(const std::string& text, const std::function<double(const Case&)>& scale_of) {
    MatchWave made = synthetic::wave("my.h5", text, [&](const Case& one, int) { return scale_of(one); });
    for (CaseRow& row : made.table.cases) {
        row.shape = Shape({{-0.4, 0.2}, {0.1, 0.7}});
        row.analysis.window = window;
        row.analysis.segments = 4;
        row.analysis.peak_separation = 0.01;  // peaks hide none
    }
    for (std::size_t number = 0; number < made.table.members.size(); ++number) {
        MemberRow& row = made.table.members[number];
        RandomStream random{9, static_cast<std::uint32_t>(number), StreamId::bootstrap, 0};
        const double scale = row.load.mean;
        row.load.steady = true;
        for (AveragedLoad& averaged : row.averaged) {
            averaged.peaks.resize(peaks_a_window);
            for (double& peak : averaged.peaks) peak = scale * (1.5 - std::log(random.uniform(1e-16, 1)));
            std::ranges::sort(averaged.peaks, std::ranges::greater{});
            averaged.segment_maximum.assign(averaged.peaks.begin(), averaged.peaks.begin() + 4);
            averaged.mean_maximum = 3 * scale * (1 + 0.01 * (random.uniform() - 0.5));
        }
    }
    return made;
}

MatchWave two_cases() {
    return measured(
        "[campaign]\narrangements = 60\n[[case]]\nname = \"thin\"\n[[case]]\nname = \"thick\"\n"
        "ice.thickness_m = 0.05\n",
        [](const Case& one) { return one.name == "thin" ? 20.0 : 60.0; });
}

const std::string axis = "[[design.axis]]\nkey = \"ice.thickness_m\"\nvalues = [0.02, 0.03, 0.04, 0.05, 0.06, 0.07]\n";

/// The scale is 1000 N/m times the thickness.
MatchWave design() {
    return measured("[campaign]\narrangements = 12\n[design]\nmethod = \"list\"\n" + axis,
                    [](const Case& one) { return 1000 * one.scenario.floe.thickness; });
}

Regime regime(const std::string& case_name, double hours, const std::string& name = {}) {
    return {name.empty() ? case_name : name, hours * hour, case_name, {}, "year.toml:1"};
}

Regime at_thickness(double thickness, double hours) {
    return {"between", hours * hour, "", {{"ice.thickness_m", {thickness}, "year.toml:3"}}, "year.toml:1"};
}

/// The load of a year of exponential peaks: (scale, hours) of each regime.
double truth(const std::vector<std::pair<double, double>>& regimes, double p) {
    double low = 1, high = 1e5;
    for (int k = 0; k < 100; ++k) {
        const double x = 0.5 * (low + high);
        double sum = 0;
        for (const auto& [scale, hours] : regimes)
            sum += hours * hour * peaks_a_window / window * std::exp(1.5 - x / scale);
        (sum > -std::log1p(-p) ? low : high) = x;
    }
    return low;
}

void expect_holds(const LoadFigure& found, double wanted) {
    EXPECT_LE(found.interval.low, wanted);
    EXPECT_GE(found.interval.high, wanted);
    EXPECT_NEAR(found.value / wanted, 1, 0.25);
}

TEST(Year, OfTwoCasesIsTheRootOfTheSumOfTheirRates) {
    const Year year = find_year(two_cases(), {regime("thin", 300), regime("thick", 5)}, {});
    ASSERT_EQ(year.levels.size(), 2u);
    for (const YearLevel& level : year.levels) {
        expect_holds(level.load, truth({{20, 300}, {60, 5}}, level.per_year));
        EXPECT_GT(level.shares[1].value, 0.8);  // the thick ice, few hours as it has
        EXPECT_NEAR(level.shares[0].value + level.shares[1].value, 1, 1e-9);
    }
    EXPECT_TRUE(says_some_load(year));
    EXPECT_EQ(year.sources.size(), 2u);
    EXPECT_EQ(year.sources[0].time_run, 60 * window);
    EXPECT_LE(year.curve.back().per_year, 1.01e-4);
    for (std::size_t k = 1; k < year.curve.size(); ++k) {
        EXPECT_GT(year.curve[k].all.value, year.curve[k - 1].all.value);
        EXPECT_LE(year.curve[k].alone[0], year.curve[k].all.interval.high);
    }
}

TEST(Year, OfACaseInTwoRegimesHasOneTail) {
    const Year year = find_year(two_cases(), {regime("thin", 200, "spring"), regime("thin", 100, "autumn")}, {});
    EXPECT_EQ(year.sources.size(), 1u);
    EXPECT_NEAR(year.levels[0].shares[0].value, 2.0 / 3, 1e-6);
    const Year whole = find_year(two_cases(), {regime("thin", 300)}, {});
    EXPECT_NEAR(year.levels[0].load.value / whole.levels[0].load.value, 1, 1e-6);
}

// Rows of a design lie point by point, its members arrangement by arrangement.
TEST(Year, NamesTheMembersOfADesignThatStandOut) {
    MatchWave wave = design();
    constexpr std::size_t jammed = 25;
    for (AveragedLoad& averaged : wave.table.members[jammed].averaged)
        for (double& peak : averaged.peaks) peak *= 20;
    const Year year = find_year(wave, {at_thickness(0.045, 300)}, {});
    const TailSource& source = year.sources[0];
    ASSERT_EQ(source.unlike.out.size(), 1u);
    EXPECT_EQ(source.members[source.unlike.out[0]], static_cast<int>(jammed));
}

TEST(Year, LiesBetweenThePointsOfADesign) {
    const MatchWave wave = design();
    for (const double thickness : {0.025, 0.045, 0.07}) {
        const Year year = find_year(wave, {at_thickness(thickness, 300)}, {});
        expect_holds(year.levels[0].load, truth({{1000 * thickness, 300}}, 1e-2));
        EXPECT_NEAR(year.regimes[0].tail.factor, 3000 * thickness, 0.02 * 3000 * thickness);
        EXPECT_GT(year.regimes[0].tail.factor_sd, 0);
        EXPECT_LT(year.regimes[0].tail.factor_sd, 0.05);
        EXPECT_EQ(year.sources[0].members.size(), 72u);
        EXPECT_EQ(year.sources[0].arrangements, 12u);
    }
}

/// At so many thicknesses.
MatchWave design_of(int points) {
    std::string values;
    for (int k = 0; k < points; ++k) values += (k > 0 ? ", " : "") + std::to_string(0.02 + 0.01 * k);
    return measured(
        "[campaign]\narrangements = 12\n[design]\nmethod = \"list\"\n[[design.axis]]\n"
        "key = \"ice.thickness_m\"\nvalues = [" +
            values + "]\n",
        [](const Case& one) { return 1000 * one.scenario.floe.thickness; });
}

// Where it is one number for all regimes, the share of each is that of its hours, which is no answer.
TEST(Year, IsRefusedWhereTheDesignIsAConstant) {
    EXPECT_EQ(refusal([&] { find_year(design_of(4), {at_thickness(0.03, 300)}, {}); }),
              "my.h5: the mean maximum cannot be interpolated between the points of the design: its emulator is a "
              "constant, the same at all inputs, because it has 4 points; 9 or more make it a Gaussian process, which "
              "follows them; run more points, or name points as cases");
}

TEST(Year, SaysThatADesignOfFewPointsIsAPlane) {
    const auto told = [](int points) {
        const MatchWave wave = design_of(points);
        const Year year = find_year(wave, {at_thickness(0.025, 300), at_thickness(0.03, 30)}, {});
        const std::vector<Section> sections = year_sections(evidence_of(wave.campaign, wave.table), year, {});
        const auto records = nlohmann::json::parse(json(sections)).at("year");
        return std::pair(text(sections, 400), records.at("sources").at(0).at("interpolation").get<std::string>());
    };
    const auto [few, plane] = told(6);
    EXPECT_THAT(few,
                HasSubstr("! the design: between its points the mean maximum is a plane because it has 6 points; 9"));
    EXPECT_EQ(plane, "linear");
    const auto [many, process] = told(9);
    EXPECT_THAT(many, Not(HasSubstr("between its points")));
    EXPECT_EQ(process, "Gaussian process");
}

TEST(Year, DoesNotDependOnTheOrderOfItsRegimes) {
    const std::vector<Regime> there{regime("thin", 300), regime("thick", 5), regime("thin", 20, "late")};
    const std::vector<Regime> back{there.rbegin(), there.rend()};
    const Year one = find_year(two_cases(), there, {});
    const Year other = find_year(two_cases(), back, {});
    for (std::size_t level = 0; level < one.levels.size(); ++level) {
        EXPECT_EQ(one.levels[level].load.value, other.levels[level].load.value);
        EXPECT_EQ(one.levels[level].load.interval.high, other.levels[level].load.interval.high);
        for (std::size_t k = 0; k < there.size(); ++k)
            EXPECT_EQ(one.levels[level].shares[k].value, other.levels[level].shares[there.size() - 1 - k].value);
    }
    for (std::size_t k = 0; k < there.size(); ++k) {
        EXPECT_EQ(one.regimes[k].regime.name, there[k].name);
        EXPECT_EQ(other.regimes[k].regime.name, back[k].name);
        EXPECT_EQ(one.curve[0].alone[k], other.curve[0].alone[there.size() - 1 - k]);
    }
}

TEST(Year, SaysWhereItIsALeapYear) {
    const MatchWave wave = two_cases();
    const Evidence evidence = evidence_of(wave.campaign, wave.table);
    const auto told = [&](double hours) {
        return text(year_sections(evidence, find_year(wave, {regime("thin", hours)}, {}), {}), 400);
    };
    EXPECT_THAT(told(8784),
                HasSubstr("1 regimes with 8784 h a year, a leap year, whose hours are taken as they stand."));
    EXPECT_THAT(told(8766), Not(HasSubstr("leap")));
}

TEST(Year, GrowsByFroude) {
    const double scale = 36;
    const Year model = find_year(two_cases(), {regime("thin", 100)}, {});
    YearRequest request;
    request.load.scale = scale;
    request.load.averaging = 6;
    const Year full = find_year(two_cases(), {regime("thin", 600)}, request);
    EXPECT_NEAR(full.levels[0].load.value / model.levels[0].load.value, 1, 1e-6);  // at the scale of the campaign
    const MatchWave wave = two_cases();
    const Evidence evidence = evidence_of(wave.campaign, wave.table);
    const auto told = nlohmann::json::parse(json(year_sections(evidence, full, request)));
    EXPECT_NEAR(told.at("year").at("loads").at(0).at("load").get<double>() / model.levels[0].load.value,
                scale * scale * scale, 1);
}

TEST(Year, SaysWhatItRestsOnAndWhatIsNext) {
    const MatchWave wave = two_cases();
    Evidence evidence = evidence_of(wave.campaign, wave.table);
    evidence.file = "my.h5";
    const Year year = find_year(wave, {regime("thin", 300), regime("thick", 100)}, {});
    const std::string told = text(year_sections(evidence, year, {}), 120);
    EXPECT_THAT(told, HasSubstr("Loads of a year: the largest averaged over 1 s"));
    EXPECT_THAT(told, HasSubstr("10^-2 (extreme level)"));
    EXPECT_THAT(told, HasSubstr("case thick"));
    EXPECT_THAT(told, Not(HasSubstr("nan")));
    const auto records = nlohmann::json::parse(json(year_sections(evidence, year, {})));
    EXPECT_EQ(records.at("year").at("regimes").size(), 4u);
    EXPECT_EQ(records.at("year").at("curve").size(), year.curve.size());
    const std::string next = year_next(evidence, year, "floes", "my.h5").before;
    EXPECT_THAT(next, HasSubstr("Next: case thick wants more members"));
    EXPECT_THAT(next, HasSubstr("-o my.h5 --set campaign.arrangements=120 --resume"));
    evidence.campaign.name = "my ice";
    EXPECT_THAT(year_next(evidence, year, "floes", "'my ice.h5'").before,
                HasSubstr("floes run CONFIG.toml -o 'my ice.h5' --set"));
    EXPECT_THAT(year_next(evidence, year, "floes", "").before,
                HasSubstr("the command of each part, with --set campaign.arrangements=120 --resume"));
}

TEST(Year, SaysWhereTheTailCannotSay) {
    MatchWave wave = two_cases();
    std::erase_if(wave.table.members, [](const MemberRow& row) { return row.arrangement > 5; });
    const Year year = find_year(wave, {regime("thin", 300)}, {});
    const std::string told = text(year_sections(evidence_of(wave.campaign, wave.table), year, {}), 400);
    EXPECT_THAT(told, HasSubstr("10^-4: the tail cannot say: its interval is from"));
    EXPECT_THAT(told, HasSubstr("h of thin, and 0.167 h were run; run more members"));
    EXPECT_THAT(told, HasSubstr("! The load of 10^-4 a year is farther from what was run"));
    const Evidence evidence = evidence_of(wave.campaign, wave.table);
    const auto records = nlohmann::json::parse(json(year_sections(evidence, year, {}))).at("year");
    EXPECT_TRUE(records.at("loads").at(1).at("load").is_null());
    EXPECT_TRUE(records.at("loads").at(1).at("load_high").is_number());
    EXPECT_TRUE(records.at("curve").back().at("load").is_null());
}

TEST(Year, RefusesRegimesThatNothingWasRunFor) {
    const MatchWave cases = two_cases();
    EXPECT_EQ(refusal([&] { find_year(cases, {regime("thck", 1)}, {}); }),
              "year.toml:1: case = \"thck\" is no case of my.h5; did you mean thick?");
    EXPECT_THAT(refusal([&] { find_year(cases, {at_thickness(0.03, 1)}, {}); }),
                HasSubstr("has no design to interpolate"));
    EXPECT_THAT(
        refusal([&] { find_year(design(), {at_thickness(0.08, 1)}, {}); }),
        HasSubstr("year.toml:3: ice.thickness_m = 0.08 is outside of the design, which has it from 0.02 to 0.07"));
    Regime other = at_thickness(0.03, 1);
    other.values[0].path = "floe.length_m";
    EXPECT_THAT(refusal([&] { find_year(design(), {other}, {}); }),
                HasSubstr("floe.length_m is no axis of the design; its axes are ice.thickness_m"));
    MatchWave few = two_cases();
    std::erase_if(few.table.members, [](const MemberRow& row) { return row.arrangement > 2; });
    EXPECT_THAT(refusal([&] { find_year(few, {regime("thin", 1)}, {}); }),
                HasSubstr("year.toml:1: case thin has 3 of the 4 members that a tail needs"));
    MatchWave flat = two_cases();
    for (MemberRow& row : flat.table.members)
        for (AveragedLoad& averaged : row.averaged) averaged.peaks.resize(row.arrangement % 20 == 0 ? 1 : 0);
    EXPECT_THAT(refusal([&] { find_year(flat, {regime("thin", 1)}, {}); }), HasSubstr("too few peaks for a tail"));
    MatchWave rising = two_cases();
    for (MemberRow& row : rising.table.members) row.load.trend = (row.arrangement % 4 + 1) * 0.02;
    EXPECT_THAT(refusal([&] { find_year(rising, {regime("thin", 1)}, {}); }), HasSubstr("give --rising"));
    YearRequest anyway;
    anyway.load.rising = true;
    EXPECT_FALSE(find_year(rising, {regime("thin", 1)}, anyway).levels.empty());
}

}  // namespace year_test
}  // namespace floes
