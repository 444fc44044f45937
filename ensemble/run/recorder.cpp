#include "run/recorder.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "campaign/campaign.hpp"
#include "campaign/write.hpp"
#include "campaign_file/pieces.hpp"
#include "core/error.hpp"
#include "run/parts.hpp"

namespace floes {

constexpr std::chrono::seconds heartbeat_interval{5};
constexpr int least_work_per_publishing = 20;
constexpr std::chrono::seconds look_interval{20};

UpkeepTimer::UpkeepTimer(Time begin, std::chrono::seconds publish_every)
    : publish_every_(publish_every), next_heartbeat_(begin), next_publishing_(begin + publish_every) {}

void UpkeepTimer::heartbeat_written(Time now) {
    next_heartbeat_ = now + heartbeat_interval;
}

void UpkeepTimer::publish_first(Time now) {
    unpublished_ = true;
    next_publishing_ = now;
}

void UpkeepTimer::published(Time begin, Time end, bool success) {
    if (success) unpublished_ = false;
    next_publishing_ = end + std::max<Time::duration>(publish_every_, least_work_per_publishing * (end - begin));
}

namespace {

namespace fs = std::filesystem;

bool has_journal(const Recorder::Places& places) {
    const fs::path journal = journal_path(places.campaign_file);
    return is_there(journal, places.system) || !pieces_of(journal, places.system).empty();
}

std::unique_lock<std::mutex> alone_with_files(const Recorder::Places& places) {
    return places.publishing == nullptr ? std::unique_lock<std::mutex>() : std::unique_lock(*places.publishing);
}

/// The campaign file that a run goes on from; none where there is no file, or a damaged one beside a journal, which
/// makes it anew. Throws InputError where the file alone cannot be continued.
std::optional<FiledCampaign> filed_before(const Campaign& campaign, const Recorder::Places& places) {
    if (places.existing != Existing::resume || !is_there(places.campaign_file, places.system)) return {};
    if (has_journal(places)) {
        try {
            return Recorder::filed(places);
        } catch (const std::runtime_error&) {
            return {};
        }
    }
    FiledCampaign filed = Recorder::filed(places);
    expect_to_continue(filed.campaign, campaign, places.campaign_file);
    return filed;
}

/// Opens the journal of the campaign file after checking that nothing is overwritten or mixed up by accident.
Journal open(const Campaign& campaign, const Recorder::Places& places) {
    stop_rule_of(campaign, places.part);  // refuses an invalid rule before a file is created
    Recorder::check(places);
    const std::optional<FiledCampaign> filed = filed_before(campaign, places);
    // A journal that is made begins with the campaign of the file, so that it is told what this one has grown by.
    Journal opened = open_journal(journal_path(places.campaign_file), campaign, places.existing, places.system,
                                  filed ? write_campaign(filed->campaign) : "");
    if (places.existing == Existing::replace) {
        remove_file(places.campaign_file, places.system);
        if (&places.system == &this_system()) remove_pieces(places.campaign_file);
        remove_saved(
            places.campaign_file, [](const MemberIdentity&) { return false; }, HalfWritten::removed, places.system);
    }
    if (filed) take_in(*filed, campaign, opened);
    return opened;
}

}  // namespace

FiledCampaign Recorder::filed(const Places& places) {
    const std::unique_lock<std::mutex> alone = alone_with_files(places);
    return places.filed(places.campaign_file);
}

void Recorder::check(const Places& places) {
    const fs::path journal = journal_path(places.campaign_file);
    const std::string file = places.campaign_file.string();
    const bool has_file = is_there(places.campaign_file, places.system);
    const std::vector<int> pieces = pieces_of(journal, places.system);
    if (places.existing == Existing::refuse && (has_file || has_journal(places))) {
        throw InputError(
            fmt::format("{} exists already: --resume continues it, --overwrite starts afresh and replaces it, "
                        "-o names another file.",
                        has_file                           ? file
                        : is_there(journal, places.system) ? journal.string()
                                                           : piece_path(journal, pieces[0]).string()));
    }
    const int may_write = places.system.may_write_in(folder_of(journal));
    if (may_write < 0)
        throw InputError(fmt::format("{} cannot be written: {}. The folder must exist and permit it.", journal.string(),
                                     std::strerror(-may_write)));
}

bool Recorder::is_over(const Campaign& campaign, const Places& places) {
    if (places.existing != Existing::resume || places.part.of > 1 || has_journal(places)) return false;
    if (!is_there(places.campaign_file, places.system)) return false;
    const FiledCampaign there = filed(places);
    const bool same_words = std::ranges::equal(there.campaign.cases, campaign.cases, {}, &Case::name, &Case::name) &&
                            there.campaign.name == campaign.name &&
                            there.campaign.run.base_case == campaign.run.base_case;
    return there.is_whole() && same_words && there.campaign.stop == campaign.stop &&
           fingerprint(there.campaign) == fingerprint(campaign);
}

Recorder::Recorder(const Campaign& campaign, Places places)
    : campaign_(campaign),
      places_(std::move(places)),
      keeper_(open(campaign, places_)),
      tally_(campaign,
             take_inventory(campaign, journal().members(), journal().contents().attempts, places_.part,
                            places_.retry_failed),
             places_.system.now()),
      timer_(places_.system.now(), places_.publish_every) {}

std::vector<std::string> Recorder::begin(Session session) {
    const Inventory& found = tally_.found();
    std::vector<std::string> changes;
    Journal& journal = keeper_.journal();
    if (found.reused() > 0 && !journal.contents().sessions.empty())
        changes = changed_software(journal.contents().sessions.back(), session);
    for (const CalibrationRecord& calibration : places_.calibrations) journal.append(calibration);
    session.reused = found.reused();
    session.retried = found.retried;
    session.part = places_.part.number;
    session.parts = places_.part.of;
    journal.begin_session(session);
    // So that NAME.part*.h5 names every part that has begun.
    if (places_.part.of > 1 && !is_there(places_.campaign_file, places_.system))
        timer_.publish_first(places_.system.now());
    return changes;
}

void Recorder::started(int number, int attempt) {
    keeper_.journal().started(tally_.identity_of(number), attempt);
    tally_.started(number, attempt, places_.system.now());
}

void Recorder::keep(const MemberRecord& record) {
    keeper_.keep(record);
    tally_.kept(record);
    timer_.kept();
}

void Recorder::kept_in_piece(const Kept& kept, int piece) {
    const MemberIdentity member = tally_.identity_of(kept.number);
    keeper_.journal().done_in_piece(member);
    tally_.kept(member, MemberStatus::done, kept.record ? &*kept.record : nullptr);
    InPiece& one = in_pieces_.emplace_back(kept.number, kept.note, kept.place);
    one.place.piece = piece;
}

std::string Recorder::tend(Time now) {
    keeper_.tend(now);
    if (timer_.heartbeat_is_due(now)) {
        write_heartbeat(heartbeat_path(places_.campaign_file), tally_.heartbeat(now), places_.system);
        write_metrics_now(now, true);
        timer_.heartbeat_written(now);
    }
    std::string trouble;
    // Many writers fill more than one process can publish meanwhile.
    if (places_.with_file && in_pieces_.empty() && timer_.publishing_is_due(now)) {
        try {
            publish_now();
        } catch (const std::exception& error) {
            trouble = error.what();
        }
        timer_.published(now, places_.system.now(), trouble.empty());
    }
    if (places_.part.of > 1 && campaign_.stop.active() && !together_ && now >= next_look_) {
        try {
            look_at_other_parts();
        } catch (const std::exception& error) {
            trouble = error.what();
        }
        const Time end = places_.system.now();
        next_look_ = end + std::max<Time::duration>(look_interval, least_work_per_publishing * (end - now));
    }
    return trouble;
}

void Recorder::look_at_other_parts() {
    std::vector<fs::path> files = other_parts(places_.campaign_file, places_.part);
    files.insert(files.begin(), places_.campaign_file);
    const Parts parts(files);
    if (parts.rule() && parts.rule()->met()) together_ = parts.rule();
}

bool Recorder::has_all_pieces() const {
    std::map<int, std::uint64_t> ends;
    for (const InPiece& one : in_pieces_) {
        std::uint64_t& end = ends[one.place.piece];
        end = std::max(end, one.place.offset + one.place.size);
    }
    return std::ranges::all_of(ends, [&](const auto& piece) {
        FileFacts facts;
        const fs::path path = piece_path(journal_path(places_.campaign_file), piece.first);
        return places_.system.facts(path, facts) == 0 && facts.size >= piece.second;
    });
}

int Recorder::take_in_pieces(bool lost_a_writer) {
    if (!lost_a_writer && has_all_pieces()) {
        for (const InPiece& one : in_pieces_)
            keeper_.journal().take_in(tally_.identity_of(one.number), one.note, one.place);
        return 0;
    }
    keeper_.journal().take_in_pieces();
    const StoredMembers members = journal().members();
    const auto kept = match_records(campaign_, members.notes());
    const auto is_there = [&](const MemberTask& task) {
        const std::optional<std::size_t>& record = kept[static_cast<std::size_t>(task.number)];
        return record && members.notes()[*record].done();
    };
    const auto there = static_cast<int>(std::ranges::count_if(tally_.found().tasks, is_there));
    return std::max(0, tally_.computed() - there);
}

void Recorder::give_up() noexcept {
    try {
        say_at_rest();
        keeper_.journal().end_session("failed");
    } catch (const std::exception&) {
        // The original error is the one to report.
    }
}

void Recorder::say_at_rest() const {
    places_.system.remove(heartbeat_path(places_.campaign_file));
    write_metrics_now(places_.system.now(), false);
}

void Recorder::finish(const std::string& outcome, const std::function<bool()>& together) {
    sync();
    keeper_.journal().end_session(outcome);
    try {
        if (places_.with_file && !(together && together())) publish_now();
    } catch (...) {
        try {
            say_at_rest();
        } catch (const std::exception&) {
            // The first error is the one to report.
        }
        throw;
    }
    if (outcome.starts_with("complete"))
        remove_saved(
            places_.campaign_file, [](const MemberIdentity&) { return false; }, HalfWritten::removed, places_.system);
    else if (!places_.with_file)
        remove_saved_of_done(HalfWritten::removed);
    say_at_rest();
    if (!places_.keep_journal && outcome == "complete" && is_whole_in_file())
        remove_journal(journal_path(places_.campaign_file), places_.system);
}

bool Recorder::is_whole_in_file() const {
    if (!places_.with_file || places_.part.of > 1 || tally_.done() < member_count(campaign_)) return false;
    try {
        const FiledCampaign there = filed(places_);
        return there.is_whole() && there.campaign.arrangements == campaign_.arrangements;
    } catch (const std::runtime_error&) {
        return false;  // a journal that is left does no harm
    }
}

void Recorder::write_metrics_now(Time now, bool at_work) const {
    if (places_.metrics.empty()) return;
    const Heartbeat heartbeat = tally_.heartbeat(now);
    const int running = at_work ? tally_.running() : 0;
    const int finished = tally_.computed() + tally_.set_aside();
    write_metrics(places_.metrics,
                  {.campaign = campaign_.name,
                   .at_work = at_work,
                   .done = tally_.done(),
                   .failed = tally_.failed(),
                   .running = running,
                   .to_do = std::max(0, static_cast<int>(tally_.found().tasks.size()) - finished - running),
                   .elapsed = heartbeat.elapsed,
                   .finished = finished,
                   .seconds_left =
                       at_work ? time_left(heartbeat.finished_cost, heartbeat.remaining_cost, heartbeat.elapsed) : -1},
                  places_.system);
}

/// Members that still run have such files too, and may be writing them; hardly ever are there more.
void Recorder::remove_saved_of_done(HalfWritten half_written) const {
    const StoredMembers members = journal().members();
    const MemberNotes& notes = members.notes();
    const auto is_wanted = [&](const MemberIdentity& member) {
        const auto key = notes.keys().find(member.first);
        if (key == notes.keys().end()) return true;
        for (std::size_t k = 0; k < notes.size(); ++k)
            if (notes[k].key == key->second && notes[k].arrangement == member.second && notes[k].done()) return false;
        return true;
    };
    remove_saved(places_.campaign_file, is_wanted, half_written, places_.system);
}

void Recorder::publish_now() {
    remove_saved_of_done(HalfWritten::kept);
    const std::unique_lock<std::mutex> alone = alone_with_files(places_);
    publish(places_.campaign_file, tally_.published(), journal().members(), journal().contents().sessions,
            journal().contents().calibrations, places_.system, places_.content);
}

}  // namespace floes
