#include "run/writer.hpp"

#include <algorithm>
#include <utility>

#include "campaign/write.hpp"
#include "core/contract.hpp"

namespace floes {

constexpr std::chrono::milliseconds sync_interval{900};

bool SyncTimer::is_due(Time now) const {
    return now - last_sync_ >= sync_interval;
}

void SyncTimer::synced(Time now) {
    unsynced_ = false;
    last_sync_ = now;
}

Keeper::Keeper(Journal journal) : journal_(std::move(journal)), timer_(journal_.system().now()) {}

void Keeper::keep(const MemberRecord& record) {
    journal_.append(record);
    timer_.kept();
}

void Keeper::tend(SyncTimer::Time now) {
    journal_.hand_over();
    if (timer_.is_due(now)) sync();
}

void Keeper::sync() {
    if (timer_.is_unsynced()) journal_.sync();
    timer_.synced(journal_.system().now());
}

namespace {

constexpr int most_ranks_of_one = 15;  // one core would write the file of shorter members for a sixth of the time
constexpr int least_ranks_of_each = 4;
constexpr int most_usual_writers = 256;  // each of which the campaign file refers to

int ceiling(int number, int divisor) {
    return (number + divisor - 1) / divisor;
}

int usual_ranks_of_each(int ranks) {
    if (ranks <= most_ranks_of_one) return ranks;
    return std::max(least_ranks_of_each, ceiling(ranks, most_usual_writers));
}

/// What a stop rule needs of a record.
MemberRecord without_histories(MemberRecord record) {
    for (std::size_t k = 0; k < array_outputs.size(); ++k)
        if (array_outputs[k].in_file() && !array_outputs[k].in_table) record.arrays[k] = {};
    return record;
}

}  // namespace

Groups::Groups(int ranks, int writers)
    : ranks_(ranks),
      ranks_of_each_(writers > 0 ? ceiling(ranks, std::min(writers, ranks)) : usual_ranks_of_each(ranks)) {
    FLOES_EXPECTS(ranks >= 1 && writers >= 0);
}

std::vector<int> Groups::writers() const {
    std::vector<int> all;
    for (int rank = ranks_of_each_; rank < ranks_; rank += ranks_of_each_) all.push_back(rank);
    return all;
}

std::vector<int> Groups::group_of(int writer) const {
    std::vector<int> group;
    for (int rank = writer; rank < ranks_ && writer_of(rank) == writer; ++rank) group.push_back(rank);
    return group;
}

Writer::Writer(Link& link, const Campaign& campaign, const std::filesystem::path& piece, const System& system)
    : link_(link),
      has_stop_rule_(campaign.stop.active()),
      keeper_(open_journal(piece, write_campaign(campaign), Existing::resume, system)) {}

void Writer::keep(int worker, Answer answer) {
    keeper_.keep(answer.record);
    Kept& kept = kept_.emplace_back();
    const JournalContents& contents = keeper_.journal().contents();
    kept.worker = worker;
    kept.number = answer.number;
    kept.note = contents.members[contents.members.size() - 1];
    kept.place = contents.places.back();
    if (has_stop_rule_) kept.record = without_histories(std::move(answer.record));
}

void Writer::tend() {
    keeper_.sync();  // or a power cut after the loss of this rank takes what its master has told
    if (!kept_.empty()) link_.send(master_rank, Tag::kept, encode(std::exchange(kept_, {})));
    for (const int worker : std::exchange(farewells_, {})) link_.send(master_rank, Tag::farewell, encode(worker));
}

}  // namespace floes
