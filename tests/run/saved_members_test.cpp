#include "run/saved_members.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "core/error.hpp"
#include "member/run_member.hpp"
#include "support/file_bytes.hpp"
#include "support/short_scenario.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace saved_members_test {

/// A campaign of two members that end soon.
Campaign short_campaign() {
    Campaign made;
    made.name = "short";
    made.seed = 7;
    made.arrangements = 2;
    made.cases.push_back({"only", short_scenario()});
    return made;
}

constexpr double at_once = 1e-9;  // s between two saves

/// Puts its member off after some steps; 0: never.
Attempting put_off_after(int steps) {
    Attempting attempting;
    attempting.is_put_off = [left = steps]() mutable { return left > 0 && --left == 0; };
    return attempting;
}

class LongMembers : public ::testing::Test {
  protected:
    std::filesystem::path saved(int arrangement) const {
        return saved_path(file, {case_fingerprint(campaign, 0), arrangement});
    }

    TemporaryFolder folder;
    std::filesystem::path file = folder / "a.h5";
    Campaign campaign = short_campaign();
    MemberFunction compute = long_members(file, at_once);
    MemberResult whole = compute_member(campaign, 1, {});
};

TEST_F(LongMembers, GoOnWhereTheyWerePutOff) {
    EXPECT_THROW(compute(campaign, 1, put_off_after(30)), Interrupted);
    EXPECT_TRUE(std::filesystem::exists(saved(1)));
    EXPECT_THROW(compute(campaign, 1, put_off_after(20)), Interrupted);
    int steps = 0;
    Attempting rest;
    rest.is_put_off = [&] { return ++steps < 0; };
    const MemberResult result = compute(campaign, 1, rest);
    EXPECT_LT(steps, campaign.cases[0].scenario.step_count() - 40) << "it began at its start";
    EXPECT_EQ(result.history.surge, whole.history.surge);
    EXPECT_EQ(result.load.mean, whole.load.mean);
    EXPECT_EQ(result.work.ice_friction, whole.work.ice_friction);
    EXPECT_EQ(result.breaks, whole.breaks);
}

TEST_F(LongMembers, BeginAnewWhereTheirFileIsDamaged) {
    EXPECT_THROW(compute(campaign, 1, put_off_after(30)), Interrupted);
    std::string bytes = file_text(saved(1));
    bytes[bytes.size() / 2] ^= 1;
    std::ofstream(saved(1), std::ios::binary) << bytes;
    EXPECT_THROW(read_saved(saved(1), saved_stamp(campaign, 1)), RunError);
    EXPECT_EQ(compute(campaign, 1, put_off_after(0)).history.surge, whole.history.surge);
}

TEST_F(LongMembers, TakeNoFileOfAnother) {
    EXPECT_THROW(compute(campaign, 0, put_off_after(30)), Interrupted);
    std::filesystem::rename(saved(0), saved(1));
    EXPECT_THROW(read_saved(saved(1), saved_stamp(campaign, 1)), RunError);
    EXPECT_EQ(compute(campaign, 1, put_off_after(0)).history.surge, whole.history.surge);
}

TEST_F(LongMembers, AreNotSavedWithoutAnInterval) {
    EXPECT_THROW(long_members(file, 0)(campaign, 1, put_off_after(30)), Interrupted);
    EXPECT_FALSE(std::filesystem::exists(saved(1)));
}

TEST_F(LongMembers, LoseTheirFilesWhenNobodyWantsThem) {
    for (const int arrangement : {0, 1}) EXPECT_THROW(compute(campaign, arrangement, put_off_after(3)), Interrupted);
    std::ofstream(saved(0).string() + ".host.1.tmp") << "half";
    const std::filesystem::path other = folder / "a.b.0123-1.saved";
    std::ofstream(other) << "of a.b.h5";
    EXPECT_EQ(count_saved(campaign, file), 2);
    Campaign faster = campaign;
    faster.cases.front().scenario.structure.speed *= 2;
    EXPECT_EQ(count_saved(faster, file), 0);
    const auto wanted = [](const MemberIdentity& member) { return member.second == 1; };
    remove_saved(file, wanted, HalfWritten::kept);
    EXPECT_TRUE(std::filesystem::exists(saved(0).string() + ".host.1.tmp")) << "some member may be writing it";
    remove_saved(file, wanted, HalfWritten::removed);
    EXPECT_FALSE(std::filesystem::exists(saved(0)));
    EXPECT_FALSE(std::filesystem::exists(saved(0).string() + ".host.1.tmp"));
    EXPECT_TRUE(std::filesystem::exists(saved(1)));
    EXPECT_TRUE(std::filesystem::exists(other));
}

}  // namespace saved_members_test
}  // namespace floes
