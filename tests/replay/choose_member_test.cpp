// Which member is meant, and which of its times.

#include "replay/replay_member.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace choose_member_test {

using testing::HasSubstr;

/// Two cases over three arrangements; loads of the members 0 to 5. Member 3 failed.
CampaignTable table() {
    CampaignTable made;
    made.cases.resize(2);
    made.cases[0].name = "soft";
    made.cases[1].name = "stiff";
    int number = 0;
    for (const double load : {10.0, 40.0, 30.0, 99.0, 20.0, 5.0}) {
        MemberRow& row = made.members.emplace_back();
        row.case_index = number % 2;
        row.status = number == 3 ? RowStatus::failed : RowStatus::done;
        row.load.maximum = load;
        ++number;
    }
    return made;
}

/// Of the members' loads.
std::vector<double> loads() {
    std::vector<double> made;
    for (const MemberRow& row : table().members) made.push_back(row.load.maximum);
    return made;
}

int chosen(const MemberChoice& choice) {
    return chosen_member(table(), choice, loads());
}

TEST(ChosenMember, HasItsNumberOrItsNames) {
    EXPECT_EQ(chosen({.number = 4}), 4);
    EXPECT_EQ(chosen({.case_name = "stiff", .arrangement = 2}), 5);
    EXPECT_EQ(chosen({.case_name = "soft", .arrangement = 1}), 2);
}

TEST(ChosenMember, IsTheWorstDoneOneOfThoseLeft) {
    EXPECT_EQ(chosen({.worst = true}), 1);
    EXPECT_EQ(chosen({.case_name = "soft", .worst = true}), 2);
    EXPECT_EQ(chosen({.arrangement = 2, .worst = true}), 4);
    EXPECT_THAT(refusal([] { chosen({.case_name = "stiff", .arrangement = 1, .worst = true}); }),
                HasSubstr("None of these members is done"));
}

// Members that have none of what is asked are no candidates.
TEST(ChosenMember, IsTheWorstOfWhatIsAsked) {
    const double none = std::nan("");
    const std::vector<double> forces{none, 1, 3, 9, 2, none};
    const Asked force{AskedOf::mooring_force, 1};
    EXPECT_EQ(chosen_member(table(), {.worst = true}, forces, force), 2);
    EXPECT_EQ(chosen_member(table(), {.case_name = "stiff", .worst = true}, forces, force), 1);
    EXPECT_THAT(refusal([&] {
                    chosen_member(table(), {.case_name = "stiff", .arrangement = 2, .worst = true}, forces, force);
                }),
                HasSubstr("None of these members has a mooring force over 1 s: its structure does not give way"));
}

TEST(ChosenMember, MustBeOne) {
    EXPECT_THAT(refusal([] { chosen({}); }), HasSubstr("Which member?"));
    EXPECT_THAT(refusal([] { chosen({.case_name = "soft"}); }), HasSubstr("--arrangement"));
    EXPECT_THAT(refusal([] { chosen({.arrangement = 0}); }), HasSubstr("--case"));
    EXPECT_THAT(refusal([] { chosen({.case_name = "hard"}); }),
                HasSubstr("There is no case hard; the cases are soft, stiff."));
    EXPECT_THAT(refusal([] { chosen({.arrangement = 3, .worst = true}); }), HasSubstr("the arrangements are 0 to 2"));
}

TEST(ChosenTimes, AreTheRunUnlessSaidOtherwise) {
    ReplaySubject subject;  // 270 s
    const FrameTimes whole = chosen_times(subject, {});
    EXPECT_EQ(whole.from, 0);
    EXPECT_DOUBLE_EQ(whole.to, 270);
    EXPECT_EQ(whole.every, 0.25);
    EXPECT_EQ(chosen_times(subject, {.from = 200, .to = 260}).every, 0.1);
    EXPECT_EQ(chosen_times(subject, {.to = 10, .every = 0.02}).every, 0.02);
}

}  // namespace choose_member_test
}  // namespace floes
