// What a journal keeps after a power cut and a failing disk, on a simulated one: the faults that histories from a seed
// found (tests/faults/history.hpp), each alone. What a power cut leaves is drawn, so each is tried many times.

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/error.hpp"
#include "store/journal.hpp"
#include "support/simulated_system.hpp"
#include "support/small_journal.hpp"

namespace floes {
namespace power_cut_test {

using simulated::Dice;
using simulated::Disk;
using simulated::Process;
using simulated::Timeline;

constexpr const char* path = "/simulated/a.journal";
constexpr const char* text = "name = \"small\"\n";

struct Machine {
    explicit Machine(std::uint64_t seed) : dice(seed), disk(dice, {}) {}

    Journal open(const System& system, int piece = 0) const {
        return open_journal(piece_path(path, piece), text, Existing::resume, system);
    }
    /// A journal whose maker is killed in that call.
    void begin_until(int call) {
        Process killed(disk, time, dice);
        killed.plan.dies = call;
        EXPECT_THROW(open(killed), RunError);
    }
    std::size_t members() {
        const Process reader(disk, time, dice);
        return read_journal(path, reader).members.size();
    }

    Dice dice;
    Disk disk;
    Timeline time;
};

/// Runs the test with many draws; stops at the first that fails.
template <class Test>
void with_every_draw(const Test& test) {
    for (std::uint64_t seed = 0; seed < 200 && !testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        Machine machine(seed);
        test(machine);
    }
}

/// How many calls it takes to make a journal.
int calls_to_begin() {
    Machine machine(0);
    const Process process(machine.disk, machine.time, machine.dice);
    machine.open(process);
    return process.calls();
}

TEST(PowerCut, TakesNoJournalWhoseMakerWasKilledAndThatOthersSynced) {
    with_every_draw([last = calls_to_begin()](Machine& machine) {
        machine.begin_until(last);  // the sync of the folder
        const Process process(machine.disk, machine.time, machine.dice);
        {
            Journal journal = machine.open(process);
            journal.append(small_record(0));
            journal.sync();
        }
        machine.disk.power_cut();
        EXPECT_EQ(machine.members(), 1u);
    });
}

TEST(PowerCut, LeavesNoHeaderThatHasToBeRemovedByHand) {
    with_every_draw([at = calls_to_begin() - 1](Machine& machine) {
        machine.begin_until(at);  // the sync of the header
        machine.disk.sync_names();
        machine.disk.power_cut();
        const Process process(machine.disk, machine.time, machine.dice);
        EXPECT_EQ(machine.open(process).contents().campaign_text, text);
    });
}

TEST(PowerCut, LeavesNoRecordBehindATornHeader) {
    with_every_draw([at = calls_to_begin() - 1](Machine& machine) {
        machine.begin_until(at);  // the sync of the header
        Process next(machine.disk, machine.time, machine.dice);
        {
            Journal journal = machine.open(next);
            journal.append(small_record(0));
            journal.hand_over();
        }
        machine.disk.sync_names();
        machine.disk.power_cut();
        const Process process(machine.disk, machine.time, machine.dice);
        EXPECT_EQ(machine.open(process).contents().campaign_text, text);
    });
}

TEST(PowerCut, TakesNothingOfPiecesWhoseWritersWereLost) {
    with_every_draw([](Machine& machine) {
        Process master(machine.disk, machine.time, machine.dice);
        Process writer(machine.disk, machine.time, machine.dice);
        Journal journal = machine.open(master);
        {
            Journal piece = machine.open(writer, 1);
            piece.append(small_record(0));
            piece.hand_over();
            writer.kill();
        }
        if (machine.dice.one_in(2)) {
            journal.take_in_pieces();  // at the end of the run
        } else {
            master.kill();
            const Process next(machine.disk, machine.time, machine.dice);
            EXPECT_EQ(machine.open(next).members().notes().size(), 1u);  // as the next one begins
        }
        machine.disk.power_cut();
        EXPECT_EQ(machine.members(), 1u);
    });
}

// A system may go on reading out what it could not write, and call it written.
TEST(PowerCut, TakesNothingThatIsReadAfterASyncThatFailed) {
    with_every_draw([](Machine& machine) {
        Process process(machine.disk, machine.time, machine.dice);
        Journal journal = machine.open(process);
        journal.append(small_record(0));
        journal.hand_over();
        process.plan.error = process.calls() + 1;
        EXPECT_THROW(journal.sync(), RunError);
        process.kill();
        const Process next(machine.disk, machine.time, machine.dice);
        const std::size_t believed = machine.open(next).members().notes().size();
        Journal resumed = machine.open(next);
        resumed.append(small_record(1));
        resumed.sync();
        machine.disk.power_cut();
        EXPECT_EQ(machine.members(), believed + 1);
    });
}

// A sync that fails may lose the cut of a file that is overwritten; then its old records stand behind new ones.
TEST(PowerCut, BringsNoRecordBackThatWasOverwritten) {
    with_every_draw([](Machine& machine) {
        {
            const Process first(machine.disk, machine.time, machine.dice);
            Journal journal = machine.open(first);
            for (int k = 0; k < 3; ++k) journal.append(small_record(k));
            journal.sync();
        }
        Process second(machine.disk, machine.time, machine.dice);
        second.plan.error = machine.dice.between(1, 20);
        try {
            open_journal(path, text, Existing::replace, second);
        } catch (const std::runtime_error&) {
            // at one call or another
        }
        second.kill();
        const Process third(machine.disk, machine.time, machine.dice);
        Journal resumed = machine.open(third);
        const std::size_t believed = resumed.members().notes().size();
        resumed.append(small_record(static_cast<int>(believed)));
        resumed.sync();
        machine.disk.power_cut();
        EXPECT_EQ(machine.members(), believed + 1);
    });
}

}  // namespace power_cut_test
}  // namespace floes
