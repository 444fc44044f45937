// A member of a field without end computed again: a record has each floe that its frames show, and where it was there.

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "campaign/campaign.hpp"
#include "campaign_file/publish.hpp"
#include "campaign_file/read.hpp"
#include "replay/replay_member.hpp"
#include "run/attempt.hpp"
#include "store/member_record.hpp"
#include "support/endless_scenario.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace endless_replay_test {

using testing::IsEmpty;

/// Floes of two sizes, a moored structure, and two parts that have left at the end.
Scenario of_two_sizes() {
    Scenario scenario = endless_scenario(20, SolverKind::direct);
    scenario.sizes.law = SizeLaw::list;
    scenario.sizes.list = {{0.4, 0.4, 0.5}, {0.6, 0.6, 0.5}};
    scenario.moorings = {.mass = 500, .gyration = 0.4, .surge = 1200, .sway = 1200, .yaw = 200, .damping = 0.2};
    return scenario;
}

class EndlessReplay : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = new TemporaryFolder;
        Campaign campaign;
        campaign.name = "endless";
        campaign.seed = 7;
        campaign.arrangements = 1;
        campaign.cases.push_back({"only", of_two_sizes()});
        MemberRecord record;
        record.case_key = case_fingerprint(campaign, 0);
        record.result = compute_member(campaign, 0, {});
        publish(*folder_ / "endless.h5", campaign, std::vector{record}, {});
    }
    static void TearDownTestSuite() { delete folder_; }

    static std::filesystem::path place(const std::string& name) { return *folder_ / name; }
    static ReplaySubject subject() {
        return replay_subject(place("endless.h5"), read_campaign_file(place("endless.h5")), 0);
    }

  private:
    static inline TemporaryFolder* folder_ = nullptr;
};

/// What a run has in the field after these steps: floe by floe in the order of entry.
struct Seen {
    std::vector<Vec3> positions;
    std::vector<double> sides;  // of the elements
    std::set<int> numbers;
};

Seen seen_of(const Simulation& run) {
    Seen seen;
    std::vector<std::pair<int, int>> there;
    for (int place = 0; place < run.ice().places(); ++place)
        if (run.ice().is_there(place)) there.emplace_back(run.ice().number_of(place), place);
    std::ranges::sort(there);
    for (const auto& [number, place] : there) {
        seen.numbers.insert(number);
        for (int k = 0; k < run.ice().elements(place); ++k) {
            seen.positions.push_back(
                run.element_states()[static_cast<std::size_t>(run.ice().first_element(place) + k)].position);
            seen.sides.push_back(2 * run.ice().cut(place).elements.front().corners.front().x);
        }
    }
    return seen;
}

TEST_F(EndlessReplay, ShowsEachFloeWhileItIsThere) {
    const ReplaySubject again = subject();
    const FrameSteps steps{0, 1000, 100};
    const MemberResult result = replay(again, steps, place("whole.h5"));
    EXPECT_THAT(differences(again, result), IsEmpty());
    const Recording recording(place("whole.h5"));
    ASSERT_EQ(recording.frames(), steps.count());

    LaidField laid = lay_field(again.about.scenario, again.seed, 0);
    Simulation run(again.about.scenario, laid.floes, std::move(laid.ahead));
    std::set<int> all;
    std::size_t left = 0;
    int frame = 0;
    ASSERT_TRUE(run.run({}, [&](const Simulation& now) {
        if (!steps.has(now.steps())) return;
        const Seen seen = seen_of(now);
        all.insert(seen.numbers.begin(), seen.numbers.end());
        left = all.size() - seen.numbers.size();
        const Frame shown = recording.read(frame++);
        ASSERT_EQ(shown.elements.size(), seen.positions.size());
        ASSERT_EQ(shown.ids.size(), seen.positions.size());
        ASSERT_TRUE(std::ranges::is_sorted(shown.ids));
        std::set<int> floes;
        for (std::size_t k = 0; k < seen.positions.size(); ++k) {
            const IceLayout::LaidElement& one = recording.layout().elements.at(shown.id(k));
            ASSERT_LT((shown.elements[k].position - seen.positions[k]).norm(), 2e-5) << k;
            ASSERT_NEAR(2 * one.half_extents.x(), seen.sides[k], 1e-12) << k;
            ASSERT_EQ(recording.layout().elements.at(static_cast<std::size_t>(shown.pieces[k])).floe, one.floe);
            floes.insert(one.floe);
        }
        EXPECT_EQ(floes.size(), seen.numbers.size());
        Vec3 load = Vec3::Zero();
        for (const FrameContact& contact : shown.contacts) {
            ASSERT_TRUE(std::ranges::binary_search(shown.ids, contact.element));
            ASSERT_TRUE(contact.other < 0 || std::ranges::binary_search(shown.ids, contact.other));
            if (contact.other == touches_structure) load -= contact.normal + contact.friction;
        }
        EXPECT_LT((load - shown.load).norm(), 1e-9 + 1e-3 * shown.load.norm());
    }));
    EXPECT_EQ(recording.layout().floes(), static_cast<int>(all.size()));
    EXPECT_GT(left, 12u) << "more than a part is to have left";
    EXPECT_EQ(recording.outcome().breaks.size(), result.breaks.size());
    EXPECT_GT(result.breaks.size(), 10u);
    EXPECT_FALSE(recording.subject().floes.alike());
}

TEST_F(EndlessReplay, OfAPartHasItsFloesAloneAndTheSidesBesideThem) {
    const ReplaySubject again = subject();
    const MemberResult result = replay(again, {900, 1000, 50}, place("part.h5"));
    const Recording recording(place("part.h5"));
    const Frame first = recording.read(0);
    EXPECT_EQ(recording.layout().elements[first.id(0)].floe, 0);
    EXPECT_EQ(first.id(0), 0u) << "those that left before are not in it";
    replay(again, {0, 1000, 50}, place("of_all.h5"));
    EXPECT_LT(recording.layout().floes(), Recording(place("of_all.h5")).layout().floes());
    for (const BreakEvent& event : recording.outcome().breaks) EXPECT_LT(event.floe, recording.layout().floes());
    EXPECT_LT(recording.outcome().breaks.size(), result.breaks.size());
    EXPECT_GT(recording.outcome().breaks.size(), 0u);
    const Channel channel = recording.subject().channel();
    const double x = first.structure.position.x();
    EXPECT_NEAR(channel.begin, x - again.about.scenario.field.behind - 0.6, 0.1);
    EXPECT_LT(channel.end, x + again.about.scenario.field.ahead + 2);
    ASSERT_EQ(channel.sheets.size(), 2u);
    EXPECT_NEAR(2 * channel.sheets[0].half_extents.x(), channel.end - channel.begin, 1e-9);
}

TEST_F(EndlessReplay, KeepsTheStartTheWorstMomentAndTheEnd) {
    const ReplaySubject again = subject();
    const KeyFrames frames = key_frames(again, std::nan(""));
    EXPECT_THAT(differences(again, frames.result), IsEmpty());
    EXPECT_NEAR(frames.worst.time, time_of_largest(again), 1e-12);
    const IceLayout layout(frames.about.floes);
    for (const Frame* frame : {&frames.start, &frames.worst, &frames.end}) {
        ASSERT_FALSE(frame->ids.empty());
        EXPECT_TRUE(std::ranges::is_sorted(frame->ids));
        EXPECT_LT(static_cast<std::size_t>(frame->ids.back()), layout.elements.size());
    }
    EXPECT_EQ(frames.start.ids.front(), 0);
    EXPECT_GT(frames.end.ids.front(), 0) << "the first floes have left";
    EXPECT_EQ(static_cast<std::size_t>(frames.end.ids.back()), layout.elements.size() - 1);
    for (const BreakEvent& event : frames.breaks) EXPECT_LT(event.floe, layout.floes());
}

}  // namespace endless_replay_test
}  // namespace floes
