// A member of a campaign file computed again: the same to the bit, and its frames what the run was.

#include "replay/replay_member.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "replay/jam.hpp"
#include "support/file_bytes.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace replay_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The campaign file is made once for all tests.
class Replay : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = new TemporaryFolder;
        Campaign campaign = jam::campaign();
        campaign.run.base_case = "soft";  // of which "stiff" is a variation, alone as well
        publish(file(), campaign, jam::records(campaign), {});
    }
    static void TearDownTestSuite() { delete folder_; }

    static std::filesystem::path file() { return *folder_ / "jam.h5"; }
    static std::filesystem::path place(const std::string& name) { return *folder_ / name; }
    static ReplaySubject subject(int member) { return replay_subject(file(), read_campaign_file(file()), member); }

  private:
    static inline TemporaryFolder* folder_ = nullptr;
};

TEST_F(Replay, IsTheMemberOfTheFile) {
    for (const int member : {0, 3}) {
        const ReplaySubject again = subject(member);
        const MemberResult result = replay(again, {0, 300, 50}, place("a.h5"));
        EXPECT_THAT(differences(again, result), IsEmpty());
        EXPECT_FALSE(result.breaks.empty());
    }
    EXPECT_EQ(subject(3).about.case_name, "stiff");
    EXPECT_EQ(subject(3).about.arrangement, 1);
}

TEST_F(Replay, SaysWhatIsNotAsInTheFile) {
    ReplaySubject again = subject(0);
    const MemberResult result = replay(again, {0, 0, 1}, place("b.h5"));
    again.stored.load.mean += 1;
    EXPECT_THAT(differences(again, result), ElementsAre(HasSubstr("mean_load is ")));
    again = subject(0);
    MemberResult other = result;
    other.history.surge[99] += 1e-9;
    EXPECT_THAT(differences(again, other), ElementsAre(HasSubstr("the surge load differs from t = 2.00 s on")));
    other = result;
    other.breaks.front().floe += 1;
    EXPECT_THAT(differences(again, other), ElementsAre(HasSubstr("failed in the file")));
    again.stored.status = RowStatus::failed;
    EXPECT_THAT(differences(again, result), ElementsAre(HasSubstr("failed in the file and ends now")));
}

TEST_F(Replay, KeepsTheFramesThatWereAskedFor) {
    const ReplaySubject again = subject(1);
    const FrameSteps steps = frame_steps({.from = 2, .to = 4, .every = 0.5, .through = 2.66}, again.about.scenario);
    EXPECT_EQ(steps.first, 108);
    const MemberResult result = replay(again, steps, place("c.h5"));
    const Recording recording(place("c.h5"));
    ASSERT_EQ(recording.frames(), steps.count());
    EXPECT_EQ(recording.frames(), 4);
    EXPECT_NEAR(recording.time(0), 2.16, 1e-12);
    EXPECT_NEAR(recording.time(1), 2.66, 1e-12);
    EXPECT_EQ(recording.nearest(2.5), 1);
    EXPECT_EQ(recording.layout().floes(), 12);
    EXPECT_EQ(recording.layout().elements.size(), 108);
    EXPECT_EQ(recording.outcome().history.surge, result.history.surge);
    EXPECT_EQ(recording.outcome().breaks, result.breaks);
    EXPECT_EQ(recording.subject().scenario.joint.cfm, 1e-10);
    EXPECT_EQ(recording.subject().scenario.ice.bending_strength, again.about.scenario.ice.bending_strength);
    EXPECT_EQ(recording.subject().scenario.structure.shape, again.about.scenario.structure.shape);
}

// The forces at the contacts of a frame are what the load of its step is made of.
TEST_F(Replay, HasContactsThatAddUpToTheLoad) {
    const ReplaySubject again = subject(0);
    const MemberResult result = replay(again, {1, 300, 1}, place("d.h5"));
    const Recording recording(place("d.h5"));
    int touched = 0;
    for (int k = 0; k < recording.frames(); ++k) {
        const Frame frame = recording.read(k);
        Vec3 sum = Vec3::Zero();
        double rounding = 1e-9;  // a recording keeps forces to 2^-13
        for (const FrameContact& contact : frame.contacts) {
            ASSERT_GE(contact.element, 0);
            if (contact.other != touches_structure) continue;
            sum -= contact.normal + contact.friction;
            rounding += (contact.normal.norm() + contact.friction.norm()) / 4096;
            ++touched;
            const double radius = std::hypot(contact.point.x() - frame.structure.position.x(), contact.point.z());
            EXPECT_LT(radius, again.about.scenario.structure.shape.largest_radius() + 0.02);
        }
        EXPECT_LT((sum - frame.load).norm(), rounding) << k;
        EXPECT_EQ(-frame.load.x(), result.history.surge[static_cast<std::size_t>(frame.step - 1)]);
    }
    EXPECT_GT(touched, 100);
}

TEST_F(Replay, KeepsTheStartTheWorstMomentAndTheEnd) {
    const ReplaySubject again = subject(0);
    const KeyFrames frames = key_frames(again, std::nan(""));
    EXPECT_THAT(differences(again, frames.result), IsEmpty());
    EXPECT_EQ(frames.history.surge, frames.result.history.surge);
    EXPECT_EQ(frames.start.step, 0);
    EXPECT_EQ(frames.end.step, 300);
    EXPECT_NEAR(frames.worst.time, time_of_largest(again), 1e-12);
    EXPECT_EQ(-frames.worst.load.x(), again.stored.load.maximum);
    EXPECT_THAT(frames.start.utilisation, testing::Each(0.0));
    EXPECT_THAT(frames.worst.utilisation, testing::Each(testing::Le(1.0)));
    EXPECT_GT(std::ranges::max(frames.worst.utilisation), 0.01);
    std::vector<int> pieces = frames.end.pieces;
    std::ranges::sort(pieces);
    pieces.erase(std::ranges::unique(pieces).begin(), pieces.end());
    EXPECT_GT(pieces.size(), 12u);
}

TEST_F(Replay, KnowsWhenTheLoadWasLargest) {
    const ReplaySubject again = subject(2);
    const MemberResult result = replay(again, {0, 0, 1}, place("e.h5"));
    const auto window = std::span(result.history.surge).subspan(50);
    const auto largest = std::ranges::max_element(window) - window.begin();
    EXPECT_NEAR(time_of_largest(again), 0.02 * static_cast<double>(51 + largest), 1e-12);
}

TEST_F(Replay, RefusesWhatThereIsNot) {
    EXPECT_THAT(refusal([&] { subject(4); }), HasSubstr("its members are 0 to 3"));
    const Scenario scenario = subject(0).about.scenario;
    EXPECT_THAT(refusal([&] { frame_steps({7, 9, 0.1}, scenario); }), HasSubstr("the run goes from 0 s to 6 s"));
    EXPECT_THAT(refusal([&] { frame_steps({3, 2, 0.1}, scenario); }), HasSubstr("give --from and --to within it"));
    EXPECT_THAT(refusal([&] { Recording{file()}; }), HasSubstr("no recording of floes replay"));
    EXPECT_FALSE(is_recording(file()));
    EXPECT_FALSE(is_recording(place("nothing.h5")));
}

// Every 1009th byte of a recording, each with another bit.
TEST_F(Replay, TakesNoDamagedByteForANumber) {
    const auto path = place("damaged.h5");
    replay(subject(0), {0, 300, 100}, path);
    const auto all_of = [&] {
        const Recording recording(path);
        std::vector<double> numbers = recording.outcome().history.surge;
        for (int k = 0; k < recording.frames(); ++k) {
            const Frame frame = recording.read(k);
            numbers.push_back(frame.time);
            numbers.insert(numbers.end(), frame.utilisation.begin(), frame.utilisation.end());
            for (const BodyState& one : frame.elements)
                for (const Vec3& v : {one.position, one.velocity}) numbers.insert(numbers.end(), v.begin(), v.end());
            for (const FrameContact& one : frame.contacts)
                for (const Vec3& v : {one.point, one.normal}) numbers.insert(numbers.end(), v.begin(), v.end());
        }
        return numbers;
    };
    const std::vector<double> right = all_of();
    const Bytes whole = file_bytes(path);
    int refused = 0;
    int flips = 0;
    for (std::size_t at = 0; at < whole.size(); at += 1009, ++flips) {
        Bytes bytes = whole;
        bytes[at] ^= std::byte{1} << (flips % 8);
        write_file_bytes(path, bytes);
        try {
            EXPECT_EQ(all_of(), right) << at;
        } catch (const std::runtime_error& error) {
            ++refused;
            EXPECT_THAT(error.what(), testing::AnyOf(HasSubstr("is damaged: "), HasSubstr("is not an HDF5 file")));
        }
    }
    EXPECT_GT(refused, flips / 2);
}

TEST_F(Replay, LeavesNothingWhenItIsStopped) {
    std::stop_source stop;
    const ReplayProgress stop_soon = [&](double time) {
        if (time > 1) stop.request_stop();
    };
    EXPECT_ANY_THROW(replay(subject(0), {0, 300, 10}, place("stopped.h5"), stop.get_token(), stop_soon));
    EXPECT_FALSE(std::filesystem::exists(place("stopped.h5")));
    EXPECT_FALSE(std::filesystem::exists(place("stopped.h5.tmp")));
}

}  // namespace replay_test
}  // namespace floes
