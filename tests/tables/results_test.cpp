// What people and programs see of rows of values: units, digits, intervals, and what there is none of.

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "tables/section.hpp"

namespace floes {
namespace results_test {

using Form = ResultColumn::Form;
using For = Results::For;
using Holds = ResultColumn::Holds;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// How people see the values of one column, one below the other.
std::vector<std::string> seen(ResultColumn column, const std::vector<Datum>& values, const Units& units = {}) {
    column.words = "load";
    Results results{.columns = {column}};
    for (const Datum& value : values) results.add({value});
    std::vector<std::string> found;
    for (const std::vector<Cell>& line : shown_table(results, units))
        found.push_back(line.front().value + (line.front().range ? " " + *line.front().range : ""));
    return found;
}

TEST(Significant, NeverTurnsToPowersAboveOne) {
    EXPECT_EQ(significant(1234.4, 3), "1234");
    EXPECT_EQ(significant(999.4, 3), "999");
    EXPECT_EQ(significant(999.6, 3), "1000");
    EXPECT_EQ(significant(-99.96, 3), "-100");
    EXPECT_EQ(significant(0, 3), "0");
    EXPECT_EQ(significant(0.012345, 3), "0.0123");
    EXPECT_EQ(significant(1e6, 3), "1000000");
}

TEST(UnitsOf, FollowTheLargestLoad) {
    EXPECT_EQ(Units(9999).text(9999, "N"), "9999 N");
    EXPECT_EQ(Units(1e4).text(12'345, "N"), "12.3 kN");
    EXPECT_EQ(Units(-2e7).text(2e7, "N"), "20 MN");
    EXPECT_EQ(Units(1e4).text(5e3, "N m-1"), "5 kN/m");
    EXPECT_EQ(Units(1e4).text(0.25, "share"), "25 %");
    EXPECT_EQ(Units(1e4).text(2, "m"), "2 m") << "only what grows with loads has a prefix";
    EXPECT_EQ(Units(1e4).text(std::nan(""), "N"), "–");
    EXPECT_EQ(Units(1e7).heading("mean load", "N"), "mean load, MN");
    EXPECT_EQ(Units(1e7).heading("runs", "1"), "runs");
}

TEST(ShownTable, HasAboutFourDigitsOfTheLargest) {
    EXPECT_THAT(seen({.unit = "N"}, {1234.56, 0.04}), ElementsAre("load, N", "1235", "0"));
    EXPECT_THAT(seen({.unit = "N"}, {23.456, -1.0}), ElementsAre("load, N", "23.46", "-1.00"));
    EXPECT_THAT(seen({.unit = "N"}, {0.12345}), ElementsAre("load, N", "0.1235"));
    EXPECT_THAT(seen({.unit = "N"}, {12'345.0}, Units(2e4)), ElementsAre("load, kN", "12.35"));
    EXPECT_THAT(seen({.unit = "share"}, {0.1234}), ElementsAre("load, %", "12.3"));
    EXPECT_THAT(seen({.unit = "N", .decimals = 1}, {-0.04}), ElementsAre("load, N", "0.0")) << "no minus of nothing";
    EXPECT_THAT(seen({.unit = "N", .digits = 2}, {123.4, 0.1234}), ElementsAre("load, N", "123", "0.12"));
}

TEST(ShownTable, HasIntervalsInThreeForms) {
    const Estimate load{17.34, 16.4, 18.28};
    EXPECT_THAT(seen({.unit = "N", .holds = Holds::estimates}, {load}), ElementsAre("load, N", "17.34 [16.40, 18.28]"));
    EXPECT_THAT(seen({.unit = "N", .holds = Holds::estimates, .form = Form::plus_minus}, {load}),
                ElementsAre("load, N", "17.3 ± 0.9"));
    EXPECT_THAT(seen({.unit = "N", .holds = Holds::estimates, .form = Form::difference},
                     {Estimate{5, 3.9, 6.1}, Estimate{-5, -6.1, -3.9}}),
                ElementsAre("load, N", "+5.0 ± 1.1", "-5.0 ± 1.1"));
    EXPECT_THAT(seen({.unit = "N", .holds = Holds::brackets}, {Bracket{{1, 2}}}),
                ElementsAre("load, N", " [1.00, 2.00]"));
}

TEST(ShownTable, SaysWhatItDoesNotKnow) {
    const double none = std::nan("");
    EXPECT_THAT(seen({.unit = "N"}, {none, infinite, Undefined{}, Undefined{"needs 6 more"}, Absent{}}),
                ElementsAre("load, N", "–", "–", "–", "needs 6 more", ""));
    const ResultColumn sure{.unit = "N", .holds = Holds::estimates, .form = Form::plus_minus};
    EXPECT_THAT(seen(sure, {Estimate{2, none, none, false}, Estimate{none, 1, 2}}),
                ElementsAre("load, N", "2.0 ± –", "–"));
    EXPECT_THAT(seen({.unit = "N", .holds = Holds::estimates}, {Estimate{2, 1, infinite}}),
                ElementsAre("load, N", "2.00 [1.00, –]"));
}

TEST(ShownTable, HasProbabilitiesOfTests) {
    EXPECT_THAT(seen({.p = true}, {0.0344, 0.0002, 1.0, std::nan("")}),
                ElementsAre("load", "0.034", "<0.001", "1.000", "–"));
}

TEST(ShownTable, LeavesOutWhatIsForOthers) {
    Results results{.columns = {{.key = "case", .words = "case"}, {.key = "seed"}}};
    results.add({"all", 1});
    results.add({"folded", 2}, For::folded);
    results.add({"program", 3}, For::programs);
    const Table table = shown_table(results, {});
    ASSERT_EQ(table.size(), 2U);
    EXPECT_EQ(table[0].size(), 1U) << "a column without words is for programs";
    EXPECT_EQ(table[1].front().value, "all");
    EXPECT_EQ(shown_table(results, {}, For::folded)[1].front().value, "folded");
    EXPECT_EQ(csv(data_rows(results)), "case,seed\nall,1\nfolded,2\nprogram,3\n");
}

TEST(DataRows, HaveIntervalsAsColumnsWhetherOrNotPeopleSeeThem) {
    Results results{.columns = {{.key = "mean", .words = "mean", .unit = "N", .holds = Holds::estimates},
                                {.key = "next", .words = "next", .holds = Holds::brackets}}};
    results.add({Estimate{2, 1, 3, false}, Bracket{{0.5, 4}}});
    results.add({Undefined{"needs 6 more"}, Absent{}});
    EXPECT_EQ(csv(data_rows(results)), "mean,mean_low,mean_high,next_low,next_high\n2,1,3,0.5,4\n,,,,\n");
    EXPECT_EQ(results.number(0, "mean"), 2);
    EXPECT_TRUE(std::isnan(results.number(1, "mean")));
}

TEST(DataRows, RefuseRowsThatDoNotFit) {
    Results results{.place = "loads", .columns = {{.key = "mean"}}};
    EXPECT_THROW(results.add({1.0, 2.0}), RunError);
    EXPECT_THROW(static_cast<void>(results.at(0, "mean")), std::exception);
    results.add({1.0});
    EXPECT_THROW(static_cast<void>(results.at(0, "mode")), RunError);
}

TEST(ShownTable, TakesTheUnitOfTheHeadingAbove) {
    Results results{.columns = {{.words = "what"}, {.words = "value", .unit = ""}}};
    results.add_heading("loads", For::everybody, "N");
    results.add({"mean", 2e4});
    results.add_heading("shares", For::everybody, "share");
    results.add({"broken", 0.5});
    const std::string shown = text_columns(shown_table(results, Units(2e4)), 80);
    EXPECT_THAT(shown, HasSubstr("loads, kN"));
    EXPECT_THAT(shown, HasSubstr("20.00"));
    EXPECT_THAT(shown, HasSubstr("shares, %"));
    EXPECT_THAT(shown, HasSubstr("50.0"));
    EXPECT_THAT(shown, Not(HasSubstr("20000")));
}

TEST(Pivot, PutsOneQuantityOverTwoOthers) {
    Results results{.columns = {{.key = "wall", .words = "wall"},
                                {.key = "speed", .words = "speed"},
                                {.key = "mean", .words = "mean", .decimals = 1}}};
    results.add({"45", "slow", 1.0});
    results.add({"45", "fast", 2.0});
    results.add({"70", "fast", 4.0});
    const Table table = shown_table(pivot(results, "wall", "speed", {"mean"}), {});
    ASSERT_EQ(table.size(), 3U);
    const auto line = [&](std::size_t k) {
        std::vector<std::string> values;
        for (const Cell& cell : table[k]) values.push_back(cell.value);
        return values;
    };
    EXPECT_THAT(line(0), ElementsAre(testing::_, HasSubstr("slow"), HasSubstr("fast")));
    EXPECT_THAT(line(1), ElementsAre("45", "1.0", "2.0"));
    EXPECT_EQ(line(2)[0], "70");
    EXPECT_EQ(line(2)[2], "4.0");
    EXPECT_THAT(line(2)[1], Not(HasSubstr("4")));
}

}  // namespace results_test
}  // namespace floes
