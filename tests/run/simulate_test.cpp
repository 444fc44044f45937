// The simulated run against closed forms and a run computed by hand.

#include "run/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.hpp"

namespace floes {
namespace simulate_test {

constexpr DriverCosts free_driver{};

std::vector<SimulatedMember> equal_members(int count, double run_time) {
    return std::vector<SimulatedMember>(static_cast<std::size_t>(count), {run_time, 1, 0, 0});
}

/// Run times 1, 2, …, count, known to the scheduler.
std::vector<SimulatedMember> rising_members(int count) {
    std::vector<SimulatedMember> members;
    for (int k = 1; k <= count; ++k) members.push_back({1.0 * k, 1.0 * k, 0, 0});
    return members;
}

TEST(Simulate, EqualMembersOnADriverThatCostsNothingTakeCeilOfMembersOverCores) {
    for (const int members : {1, 2, 7, 12, 60, 100}) {
        for (const int cores : {1, 2, 5, 12, 64}) {
            for (const int ranks : {1, 2, 5, 12, 64}) {
                if (ranks > cores) continue;
                const auto forecast = simulate(equal_members(members, 2.0), machine_of(cores, ranks), free_driver);
                const int rounds = (members + cores - 1) / cores;
                EXPECT_DOUBLE_EQ(forecast.wall_time, 2.0 * rounds)
                    << members << " members, " << cores << " cores, " << ranks << " ranks";
                EXPECT_DOUBLE_EQ(forecast.efficiency, 1.0 * members / (cores * rounds));
            }
        }
    }
}

TEST(Simulate, OneSlowMemberBoundsTheRun) {
    auto members = equal_members(100, 1.0);
    members[40] = {500.0, 500.0, 0, 0};
    EXPECT_DOUBLE_EQ(simulate(members, machine_of(16, 4), free_driver).wall_time, 500.0);
    // Nobody expected it, so it begins after two others of its core: members 0 to 15, 16 to 31, 32 to 47.
    members[40].expected_cost = 1;
    EXPECT_DOUBLE_EQ(simulate(members, machine_of(16, 1), free_driver).wall_time, 502.0);
}

TEST(Simulate, AgreesWithARunPlayedByHand) {
    // Longest first on two cores: 5 and 4 begin; 3 after the 4 (until 7), 2 after the 5 (until 7), then 1 (until 8).
    EXPECT_DOUBLE_EQ(simulate(rising_members(5), machine_of(2, 1), free_driver).wall_time, 8.0);
    EXPECT_DOUBLE_EQ(simulate(rising_members(5), machine_of(2, 2), free_driver).wall_time, 8.0);
}

TEST(Simulate, AMasterThatIsTheLimitSetsTheTime) {
    DriverCosts costs;
    costs.assign = 1e-3;
    costs.answer = 4e-3;
    costs.own_member = 5e-3;
    for (const int ranks : {1, 10, 1000}) {
        Machine machine = machine_of(1000, ranks);
        machine.writers = 1;
        const auto forecast = simulate(equal_members(20'000, 1e-6), machine, costs);
        EXPECT_NEAR(forecast.wall_time, 20'000 * 5e-3, 0.01) << ranks;
        EXPECT_NEAR(forecast.master_load, 1.0, 1e-3) << ranks;
    }
}

// Short members travel many in a message, long ones alone.
TEST(Simulate, MessagesAreSharedByShortMembersOnly) {
    DriverCosts costs;
    costs.receive = 1e-3;
    costs.longest_held_back = 0.05;
    costs.most_held_back = 256;
    const auto busy = [&](double run_time, int members) {
        const Forecast forecast = simulate(equal_members(members, run_time), machine_of(11, 11), costs);
        return forecast.master_load * forecast.last_member;
    };
    const double of_others = 10.0 / 11;  // the master computes, too
    EXPECT_NEAR(busy(1.0, 440), of_others * 440 * 1e-3, 0.02);
    EXPECT_LT(busy(0.01, 44'000), of_others * 44'000 * 1e-3 / 4) << "five members of 10 ms in each 50 ms";
    EXPECT_GT(busy(0.01, 44'000), of_others * 44'000 * 1e-3 / 6);
}

TEST(Simulate, BytesCostTheMasterTime) {
    DriverCosts costs;
    costs.keep_per_byte = 1e-9;
    const std::vector<SimulatedMember> members(100, {1e-6, 1, 1e6, 5e5});
    const auto forecast = simulate(members, machine_of(4, 1), costs);
    EXPECT_NEAR(forecast.wall_time, 100 * 1e-3, 1e-4);
    EXPECT_DOUBLE_EQ(forecast.journal_bytes, 1e8);
    EXPECT_DOUBLE_EQ(forecast.file_bytes, 5e7);
}

TEST(Simulate, WritersShareWhatBytesCost) {
    DriverCosts costs;
    costs.keep_per_byte = 1e-9;
    costs.receive_per_byte = 1e-9;
    const std::vector<SimulatedMember> members(4000, {1e-6, 1, 1e6, 0});
    const auto run_with = [&](int writers) {
        Machine machine = machine_of(8, 8);
        machine.writers = writers;
        return simulate(members, machine, costs);
    };
    // The master moves all, its own members without a message; then half; then every rank only its own.
    EXPECT_NEAR(run_with(1).last_member, 4000 * (7.0 / 8 * 2e-3 + 1.0 / 8 * 1e-3), 0.6);
    const Forecast two = run_with(2);
    EXPECT_EQ(two.writers, 2);
    EXPECT_NEAR(two.last_member, run_with(1).last_member / 2, 0.6);
    EXPECT_GT(two.writer_load, 0.8);
    EXPECT_NEAR(run_with(8).last_member, 4000.0 / 8 * 1e-3, 0.1);
}

TEST(Simulate, TheMasterTakesANoteOfWhatOthersKeep) {
    DriverCosts costs;
    costs.kept = 1e-3;
    Machine machine = machine_of(4, 4);
    machine.writers = 2;
    const auto forecast = simulate(equal_members(400, 1.0), machine, costs);
    EXPECT_NEAR(forecast.master_load * forecast.last_member, 200 * 1e-3, 0.005);
}

TEST(Simulate, TheFileOfManyWritersIsWrittenAtTheEndOrLater) {
    DriverCosts costs;
    costs.publish = 1.0;
    costs.publish_per_member = 1e-3;
    costs.publish_interval = 10.0;
    costs.publish_share = 0.5;
    costs.read_per_member = 1e-2;
    Machine machine = machine_of(4, 4);
    machine.writers = 4;
    const auto members = equal_members(400, 1.0);
    const auto without = simulate(members, machine, costs, false);
    EXPECT_NEAR(without.file_time, 1.0 + 400 * 1e-3 + 300 * 1e-2, 1e-9) << "one core, which reads what others kept";
    const auto with = simulate(members, machine, costs);
    EXPECT_NEAR(with.last_member, 100.0, 1e-9) << "it publishes in between";
    EXPECT_NEAR(with.file_time, 2 * 1.0 + 400 / 4 * 1e-3, 1e-9) << "pieces, then the file that refers to them";
    EXPECT_NEAR(with.wall_time - without.wall_time, with.file_time, 1e-9);
}

TEST(Simulate, WritersShareTheFileButNotWhatIsOfAllPieces) {
    DriverCosts costs;
    costs.publish_per_byte = 1e-6;
    costs.order_per_member = 1e-3;
    costs.index_per_piece = 0.1;
    costs.digest_per_piece = 0.2;
    costs.digest_per_member = 1e-2;
    const std::vector<SimulatedMember> members(400, {1.0, 1, 1e5, 1e5});
    Machine machine = machine_of(8, 8);
    for (const int writers : {4, 8}) {
        machine.writers = writers;
        machine.processors = 0;
        const double own = 400 * 1e-3 + 0.1 * writers;
        const double shared = 400 * 0.1 / writers + 0.2 * writers + 400 * 1e-2 / writers;
        EXPECT_NEAR(simulate(members, machine, costs).file_time, own + shared, 1e-9);
        machine.processors = 2;
        EXPECT_NEAR(simulate(members, machine, costs).file_time, own + shared * writers / 2, 1e-9);
    }
}

TEST(Simulate, BytesCostTheCoresTime) {
    DriverCosts costs;
    costs.member_per_byte = 1e-6;
    const std::vector<SimulatedMember> members(100, {.run_time = 1.0, .packed_bytes = 1e5});
    EXPECT_NEAR(simulate(members, machine_of(4, 2), costs).wall_time, 25 * 1.1, 1e-9);
}

TEST(Simulate, TheJournalIsSyncedEveryIntervalAndTwiceAtTheEnd) {
    DriverCosts costs;
    costs.sync = 0.1;
    costs.sync_interval = 0.9;
    // One core: a member of 1 s each second; the sync of each takes place while the next is computed.
    const auto forecast = simulate(equal_members(10, 1.0), machine_of(1, 1), costs);
    EXPECT_NEAR(forecast.wall_time, 10 + 0.2, 0.11);
    EXPECT_NEAR(forecast.master_load * forecast.last_member, 9 * 0.1, 0.11);
}

TEST(Simulate, PublishingTakesItsShareOfTheTimeAndNoMore) {
    DriverCosts costs;
    costs.publish = 10.0;
    costs.publish_interval = 100.0;
    costs.publish_share = 0.05;
    const auto forecast = simulate(equal_members(4000, 1.0), machine_of(4, 1), costs);
    EXPECT_NEAR(forecast.master_load, 0.05, 0.01);
    // Members that were handed out before go on meanwhile, one on each core and one ahead; the rest of 10 s is lost.
    EXPECT_GT(forecast.last_member, 1000);
    EXPECT_LT(forecast.last_member, 1000 * 1.06);
    EXPECT_NEAR(forecast.wall_time - forecast.last_member, 10.0, 1e-9);
    EXPECT_NEAR(simulate(equal_members(4000, 1.0), machine_of(4, 1), costs, false).wall_time, 1000, 1e-9);
}

TEST(Simulate, StartUpGrowsWithTheRanks) {
    DriverCosts costs;
    costs.start_up = 0.5;
    costs.start_up_per_rank = 0.01;
    EXPECT_NEAR(simulate(equal_members(64, 1.0), machine_of(64, 64), costs).wall_time, 0.5 + 63 * 0.01 + 1.0, 1e-9);
}

TEST(Simulate, ProcessorsThatAreFewerThanTheCoresShareTheWork) {
    DriverCosts costs;
    costs.member = 10e-3;
    Machine machine = machine_of(20, 1);
    EXPECT_NEAR(simulate(equal_members(1000, 0.0), machine, costs).wall_time, 1000 / 20 * 10e-3, 1e-6);
    machine.processors = 2;
    EXPECT_NEAR(simulate(equal_members(1000, 0.0), machine, costs).wall_time, 1000 / 2 * 10e-3, 1e-6);
}

TEST(Simulate, GivesTheSameEveryTime) {
    const auto members = rising_members(500);
    const auto one = simulate(members, machine_of(37, 5), measured_costs());
    const auto two = simulate(members, machine_of(37, 5), measured_costs());
    EXPECT_EQ(one.wall_time, two.wall_time);
    EXPECT_EQ(one.master_load, two.master_load);
}

TEST(Simulate, MoreCoresOrShorterMembersNeverTakeLonger) {
    double before = std::numeric_limits<double>::infinity();
    for (const int cores : {1, 2, 4, 8, 16, 32, 64, 128}) {
        const double now = simulate(rising_members(2000), machine_of(cores, 1), measured_costs()).wall_time;
        EXPECT_LE(now, before) << cores;
        before = now;
    }
    // With a driver that looks for messages now and then this holds within one such look only.
    before = 0;
    for (const double run_time : {0.0, 1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
        const double now = simulate(equal_members(1000, run_time), machine_of(32, 8), free_driver).wall_time;
        EXPECT_GE(now, before) << run_time;
        before = now;
    }
}

TEST(Simulate, NeverBeatsTheBounds) {
    const auto members = rising_members(1000);
    for (const int cores : {3, 50, 400}) {
        const auto forecast = simulate(members, machine_of(cores, 3), measured_costs());
        EXPECT_GE(forecast.wall_time, std::max(1000.0, forecast.run_time / cores));
        EXPECT_LE(forecast.efficiency, 1.0);
    }
}

TEST(MachineOf, SpreadsCoresEvenly) {
    EXPECT_EQ(machine_of(10, 4).cores_of_rank, (std::vector<int>{3, 3, 2, 2}));
    EXPECT_THROW(machine_of(3, 4), InputError);
    EXPECT_THROW(machine_of(3, 0), InputError);
}

}  // namespace simulate_test
}  // namespace floes
