#include "driver/recorder.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "campaign/identity.hpp"
#include "campaign_file/campaign_file.hpp"
#include "core/error.hpp"
#include "driver/heartbeat.hpp"
#include "driver/precision.hpp"

namespace floes {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds sync_interval{900};  // "within a second", with room for the disk
constexpr std::chrono::seconds heartbeat_interval{5};
constexpr std::size_t most_told = 20;
constexpr int least_work_per_publishing = 20;  // publishing takes at most a twentieth of the time

/// Opens the journal of the campaign file, having seen that nothing is overwritten or mixed up unasked.
Journal open(const Campaign& campaign, const Recorder::Places& places) {
    Recorder::check(places);
    Journal opened = open_journal(journal_path(places.campaign_file), campaign, places.existing);
    if (places.existing == Existing::replace) fs::remove(places.campaign_file);
    return opened;
}

std::vector<std::string> case_fingerprints(const Campaign& campaign) {
    std::vector<std::string> keys;
    for (int k = 0; k < static_cast<int>(campaign.cases.size()); ++k) keys.push_back(case_fingerprint(campaign, k));
    return keys;
}

/// None of a part: it has no arrangements in a row, and is run whole.
std::optional<PrecisionStop> precision_of(const Campaign& campaign, const Part& part) {
    if (part.of > 1) return {};
    return stop_rule_of(campaign);
}

}  // namespace

void Recorder::check(const Places& places) {
    const fs::path journal = journal_path(places.campaign_file);
    const std::string file = places.campaign_file.string();
    const bool has_file = fs::exists(places.campaign_file);
    const bool has_journal = fs::exists(journal);
    if (places.existing == Existing::refuse && (has_file || has_journal)) {
        throw InputError(
            fmt::format("{} exists already: --resume goes on with it, --overwrite begins anew in its place, "
                        "-o names another file.",
                        has_file ? file : journal.string()));
    }
    if (places.existing == Existing::resume && has_file && !has_journal) {
        throw InputError(
            fmt::format("{} exists but its journal {} does not, so there is nothing to go on from: "
                        "--overwrite begins anew in its place, -o names another file.",
                        file, journal.string()));
    }
}

Recorder::Recorder(const Campaign& campaign, Places places)
    : campaign_(campaign),
      places_(std::move(places)),
      case_keys_(case_fingerprints(campaign)),
      precision_(precision_of(campaign, places_.part)),
      journal_(open(campaign_, places_)),
      next_publish_(std::chrono::steady_clock::now() + places_.publish_every) {
    take_stock();
}

void Recorder::take_stock() {
    const auto kept = match_records(campaign_, journal_.records());
    for (int number = 0; number < member_count(campaign_); ++number) {
        const MemberRecord* record = kept[static_cast<std::size_t>(number)];
        const MemberKey key = member_key(campaign_, number);
        if (record != nullptr && record->result.status == MemberStatus::done) {
            ++total_;
            ++reused_;
            ++done_;
            tell_precision(key.arrangement, key.case_index, &record->result);
            pace_ = std::max(pace_, record->result.wall_time / expected_cost(campaign_, number));
            continue;
        }
        if (!places_.part.has(member_key(campaign_, number).arrangement)) continue;
        ++total_;
        const int lost = journal_.attempts().lost(identity_of(number));
        const int failures = record == nullptr || places_.retry_failed ? 0 : record->attempt;
        if (failures >= campaign_.run.attempts) {
            ++reused_;
            failed_.push_back(key.arrangement);
            tell_precision(key.arrangement, key.case_index, nullptr);
            continue;
        }
        tasks_.push_back({.number = number,
                          .cost = expected_cost(campaign_, number),
                          .batch = precision_ ? key.arrangement / campaign_.stop.batch : 0,
                          .attempts_made = failures + lost,
                          .failures = failures,
                          .suspect = lost > 0});
        tasks_cost_ += tasks_.back().cost;
        if (record != nullptr || lost > 0) ++retried_;
    }
    if (precise()) {
        tasks_.clear();
        tasks_cost_ = 0;
        retried_ = 0;
    }
}

void Recorder::tell_precision(int arrangement, int case_index, const MemberResult* result) {
    if (!precision_) return;
    MemberRow row;
    row.status = RowStatus::failed;
    if (result != nullptr) {
        row.status = RowStatus::done;
        set_load(row, result->load);
        row.failure_ratio = result->failure_ratio;
    }
    precision_->put(arrangement, case_index, stop_value(campaign_.stop.of, row));
}

int Recorder::failed() const {
    const int last = precise() ? precision_->arrangements() : campaign_.arrangements;
    return static_cast<int>(std::ranges::count_if(failed_, [last](int arrangement) { return arrangement < last; }));
}

Campaign Recorder::published() const {
    Campaign campaign = campaign_;
    if (precise()) campaign.arrangements = precision_->arrangements();
    return campaign;
}

MemberIdentity Recorder::identity_of(int number) const {
    const MemberKey key = member_key(campaign_, number);
    return {case_keys_[static_cast<std::size_t>(key.case_index)], key.arrangement};
}

std::vector<std::string> Recorder::begin(Session session) {
    std::vector<std::string> changes;
    if (reused_ > 0 && !journal_.sessions().empty()) changes = changed_software(journal_.sessions().back(), session);
    for (const CalibrationRecord& calibration : places_.calibrations) journal_.append(calibration);
    session.reused = reused_;
    session.retried = retried_;
    journal_.begin_session(session);
    return changes;
}

void Recorder::started(int number, int attempt) {
    const MemberIdentity member = identity_of(number);
    journal_.started(member, attempt);
    under_way_[member] = {number, attempt, std::chrono::steady_clock::now()};
}

void Recorder::keep(const MemberRecord& record) {
    journal_.append(record);
    under_way_.erase(identity(record));
    ++finished_;
    const auto known = std::ranges::find(case_keys_, record.case_key);
    finished_cost_ += expected_cost(campaign_, static_cast<int>(known - case_keys_.begin()));
    const bool done = record.result.status == MemberStatus::done;
    if (done) {
        ++done_;
    } else {
        failed_.push_back(record.arrangement);
    }
    for (std::size_t k = 0; k < case_keys_.size(); ++k) {
        if (case_keys_[k] != record.case_key) continue;
        tell_precision(record.arrangement, static_cast<int>(k), done ? &record.result : nullptr);
    }
    ++(done ? computed_ : set_aside_);
    synced_ = false;
    published_ = false;
}

std::string Recorder::tend(Time now) {
    journal_.hand_over();
    if (now - last_sync_ >= sync_interval) sync();
    if (now >= next_heartbeat_) {
        tell(now);
        next_heartbeat_ = now + heartbeat_interval;
    }
    if (published_ || now < next_publish_) return {};
    std::string trouble;
    try {
        publish_now();
    } catch (const RunError& error) {
        trouble = error.what();
    }
    const auto after = std::chrono::steady_clock::now();
    next_publish_ = after + std::max<std::chrono::steady_clock::duration>(places_.publish_every,
                                                                          least_work_per_publishing * (after - now));
    return trouble;
}

void Recorder::tell(Time now) const {
    const auto seconds = [now](Time since) { return std::chrono::duration<double>(now - since).count(); };
    Heartbeat heartbeat;
    heartbeat.elapsed = seconds(begin_);
    heartbeat.finished = finished_;
    heartbeat.finished_cost = finished_cost_;
    heartbeat.remaining_cost = std::max(0.0, tasks_cost_ - finished_cost_);
    for (const auto& [member, one] : under_way_)
        heartbeat.under_way.push_back({one.number, one.attempt, seconds(one.since)});
    std::ranges::sort(heartbeat.under_way, std::greater(), &Heartbeat::UnderWay::seconds);
    if (heartbeat.under_way.size() > most_told) heartbeat.under_way.resize(most_told);
    write_heartbeat(heartbeat_path(places_.campaign_file), std::move(heartbeat));
}

void Recorder::sync() {
    if (!synced_) journal_.sync();
    synced_ = true;
    last_sync_ = std::chrono::steady_clock::now();
}

void Recorder::give_up() noexcept {
    try {
        std::error_code ignored;
        fs::remove(heartbeat_path(places_.campaign_file), ignored);
        journal_.end_session("failed");
    } catch (const std::exception&) {
        // The error that brought us here is the one to tell.
    }
}

void Recorder::finish(const std::string& outcome) {
    sync();
    journal_.end_session(outcome);
    publish_now();
    std::error_code ignored;
    fs::remove(heartbeat_path(places_.campaign_file), ignored);
}

void Recorder::publish_now() {
    publish(places_.campaign_file, published(), journal_.records(), journal_.sessions(), journal_.calibrations(),
            [this](const MemberRecord& record) { return journal_.history(record); });
    published_ = true;
}

}  // namespace floes
