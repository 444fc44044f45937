#include "run/crew.hpp"

#include "campaign/campaign.hpp"

#include <utility>

#include <fmt/format.h>

#include "store/session.hpp"

namespace floes {

Crew::Crew(const Campaign& campaign, CrewSetup setup)
    : campaign_(campaign),
      setup_(std::move(setup)),
      limits_(limits_of(campaign.run)),
      host_(host_name()),
      case_keys_(case_fingerprints(campaign)) {
    if (setup_.cores.pool == nullptr) setup_.cores.pool = &own_cores_.emplace(setup_.threads);
    if (setup_.helper != nullptr) setup_.helper->prepare(campaign);
}

Crew::~Crew() {
    stop_.request_stop();
    std::unique_lock lock(mutex_);
    while (unfinished_ > 0)
        setup_.system.wait(changed_, lock, std::chrono::seconds(1), [this] { return unfinished_ == 0; });
}

void Crew::begin(Assignment assignment) {
    ++held_;
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(assignment);
        ++unfinished_;
    }
    setup_.cores.pool->begin(setup_.cores.turn, [this] { execute_next(); });
}

void Crew::execute_next() {
    std::unique_lock lock(mutex_);
    const Assignment assignment = waiting_.front();
    waiting_.pop_front();
    lock.unlock();
    Outcome outcome = execute(assignment);
    lock.lock();  // until the last touch of *this
    progress_.erase(assignment.number);
    outcomes_.push_back(std::move(outcome));
    --unfinished_;
    changed_.notify_all();
}

Outcome Crew::execute(Assignment assignment) {
    if (stop_.stop_requested()) return {assignment.number, std::nullopt};
    const System::Time begin = setup_.system.now();
    Attempted made = attempt(assignment);
    if (!made.result) return {assignment.number, std::nullopt};
    const std::chrono::duration<double> taken = setup_.system.now() - begin;
    made.result->wall_time = std::max(made.result->wall_time, taken.count());  // of earlier runs too, if it went on
    const MemberKey key = member_key(campaign_, assignment.number);
    MemberRecord record{.case_key = case_keys_[static_cast<std::size_t>(key.case_index)],
                        .arrangement = key.arrangement,
                        .attempt = assignment.attempt,
                        .rank = setup_.rank,
                        .host = host_,
                        .peak_memory = made.peak_memory,
                        .result = std::move(*made.result),
                        .arrays = {}};
    record.arrays = take_arrays(record.result);
    return {assignment.number, std::move(record)};
}

Attempted Crew::attempt(Assignment assignment) {
    const auto tell = [this](const MemberProgress& progress) {
        const std::lock_guard lock(mutex_);
        progress_[progress.number] = progress;
    };
    const bool apart = assignment.apart || campaign_.run.isolation == Isolation::process;
    if (setup_.helper != nullptr && apart) {
        try {
            return setup_.helper->run(assignment.number, limits_, stop_.get_token(), tell);
        } catch (const RunError& trouble) {  // it is gone, or has no process to give
            give_up({trouble.what(), false});
            return {};
        }
    }
    const auto stuck = [this, assignment] {
        give_up({fmt::format("Member {} is {:.0f} s past its deadline and cannot be ended in this process.",
                             assignment.number, limits_.grace),
                 true});
    };
    return attempt_here(setup_.compute, campaign_, assignment.number, limits_, stop_.get_token(), stuck, tell);
}

void Crew::give_up(CrewTrouble trouble) {
    stop_.request_stop();
    const std::lock_guard lock(mutex_);
    if (!trouble_) trouble_ = std::move(trouble);
    changed_.notify_all();
}

std::optional<CrewTrouble> Crew::trouble() const {
    const std::lock_guard lock(mutex_);
    return trouble_;
}

std::vector<MemberProgress> Crew::progress() const {
    const std::lock_guard lock(mutex_);
    std::vector<MemberProgress> all;
    for (const auto& [number, one] : progress_) all.push_back(one);
    return all;
}

std::vector<Outcome> Crew::take() {
    std::vector<Outcome> taken;
    {
        const std::lock_guard lock(mutex_);
        taken.swap(outcomes_);
    }
    held_ -= static_cast<int>(taken.size());
    return taken;
}

void Crew::wait(std::chrono::microseconds longest) {
    std::unique_lock lock(mutex_);
    setup_.system.wait(changed_, lock, longest, [this] { return !outcomes_.empty(); });
}

}  // namespace floes
