// What the master keeps of members that are done, and what it takes to publish them: bytes got by operator new.

#include <gtest/gtest.h>
#include <malloc.h>

#include <array>
#include <atomic>
#include <cstddef>

#include "campaign_file/read.hpp"
#include "run/recorder.hpp"
#include "support/replaced_new.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace {

std::atomic<long> held{0};
std::atomic<long> most_held{0};

}  // namespace

void floes::replaced_new::taken(void* memory) noexcept {
    const long now = held += static_cast<long>(malloc_usable_size(memory));
    if (now > most_held) most_held = now;
}

void floes::replaced_new::leaving(void* memory) noexcept {
    held -= static_cast<long>(malloc_usable_size(memory));
}

namespace floes {
namespace {

struct Held {
    long kept = 0;        ///< bytes, of members that are done
    long publishing = 0;  ///< bytes in addition, at most
};

Held held_by(int arrangements) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign(arrangements);
    std::array<MemberRecord, 3> models;
    for (int k = 0; k < 3; ++k) models[static_cast<std::size_t>(k)] = synthetic::record(campaign, k);
    for (MemberRecord& model : models) model.result.history = {};  // a campaign of histories would only take longer
    Recorder recorder(campaign, {.campaign_file = folder / "a.h5"});
    recorder.begin(synthetic::session());
    Held found;
    const long before = held;
    for (int arrangement = 0; arrangement < arrangements; ++arrangement) {
        for (MemberRecord& model : models) {
            model.arrangement = arrangement;
            recorder.keep(model);
        }
        recorder.hand_over();
    }
    found.kept = held - before;
    most_held = held.load();
    recorder.finish("complete");
    found.publishing = most_held - before - found.kept;
    EXPECT_EQ(read_campaign_file(folder / "a.h5").members.back().status, RowStatus::done);
    return found;
}

// A record of these has 1.3 kB. The smaller campaign fills the buffers that every campaign has.
TEST(MastersMemory, GrowsBySomeTensOfBytesAMember) {
    constexpr int few = 3000;
    constexpr int many = 6000;
    const Held small = held_by(few);
    const Held large = held_by(many);
    constexpr double members = 3.0 * (many - few);
    EXPECT_LT(static_cast<double>(large.kept - small.kept) / members, 100);
    EXPECT_LT(static_cast<double>(large.publishing - small.publishing) / members, 100);
    RecordProperty("kept", static_cast<int>(static_cast<double>(large.kept - small.kept) / members));
    RecordProperty("publishing", static_cast<int>(static_cast<double>(large.publishing - small.publishing) / members));
}

}  // namespace
}  // namespace floes
