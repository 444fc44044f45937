// Failed joints as the report shows them: by mode, over time and over the floe.

#include "findings/catalogue.hpp"

#include <gmock/gmock.h>

#include "findings/example.hpp"
#include "ice/failure_mode.hpp"

namespace floes {
namespace failures_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

/// The example's table with breaks of its first member (case E30) and of the third (E200).
Evidence evidence(std::vector<BreakRow> breaks) {
    Campaign campaign;
    campaign.cases.resize(3);
    Evidence made = evidence_of(campaign, example::campaign());
    made.kept.set(std::move(breaks));
    return made;
}

constexpr int bending = static_cast<int>(FailureMode::bending);
constexpr int tension = static_cast<int>(FailureMode::tension);
constexpr int in_plane = static_cast<int>(FailureMode::in_plane_bending);

TEST(Failures, AreStepsOverTheTimeAsAMeanOverTheArrangementsThatAreDone) {
    Evidence of = evidence({{0, 30, 0, 0, bending}, {0, 20, 1, 2, bending}});
    const Section told = failures_section(of);
    const auto& line = std::get<Figure::Line>(told.figures.at(0).marks.at(0));
    EXPECT_EQ(told.figures[0].marks.size(), 1u);
    EXPECT_EQ(line.style, "c0");
    // Four arrangements of E30 are done; the window ends at 270 s.
    EXPECT_THAT(line.points,
                ElementsAre(Pair(0, 0), Pair(20, 0), Pair(20, 0.25), Pair(30, 0.25), Pair(30, 0.5), Pair(270, 0.5)));
    EXPECT_EQ(told.figures[0].caption, "Failed joints so far, mean over arrangements; all failed in bending.");
}

TEST(Failures, AreShownInEveryModeThatOccurs) {
    Evidence of = evidence({{0, 20, 0, 0, in_plane}, {2, 20, 0, 0, tension}, {2, 30, 0, 1, in_plane}});
    const Section told = failures_section(of);
    EXPECT_EQ(told.figures.at(0).marks.size(), 3u);
    EXPECT_EQ(told.figures[0].caption,
              "Failed joints so far, mean over arrangements: thin tension, thin dotted in-plane bending.");
}

TEST(Failures, AreNamedByTheirModes) {
    Evidence of =
        evidence({{0, 20, 0, 0, in_plane}, {0, 20, 0, 0, tension}, {0, 30, 0, 1, in_plane}, {0, 40, 0, 1, in_plane}});
    EXPECT_THAT(joint_failures_section(of).notes,
                ElementsAre("E30: 1.0 joints failed in a member: in-plane bending 75 %, tension 25 %."));
}

/// Where floes are numbered as they enter, a number does not tell which cells a floe has.
TEST(Failures, OfCellsInAFieldWithoutEndHaveNoPlaces) {
    std::vector<BreakRow> breaks{{0, 20, 0, 0, tension}, {0, 30, 190, 15, tension}};
    Evidence of = evidence(breaks);
    for (Case& one : of.campaign.cases) one.scenario.field.far_end = FarEnd::never;
    EXPECT_THAT(joint_failures_section(of).figures, IsEmpty());
    for (Case& one : of.campaign.cases) one.scenario.elements.form = ElementForm::squares;
    breaks.back().joint = 11;
    of.kept.set(breaks);
    EXPECT_THAT(joint_failures_section(of).figures, testing::Not(IsEmpty()));
}

TEST(Failures, MayBeNone) {
    Evidence of = evidence({});
    EXPECT_EQ(failures_section(of).before, "No joint failed in any member.\n");
    EXPECT_THAT(joint_failures_section(of).figures, IsEmpty());
}

}  // namespace failures_test
}  // namespace floes
