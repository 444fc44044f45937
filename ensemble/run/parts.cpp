#include "run/parts.hpp"

#include <fcntl.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/write.hpp"
#include "campaign_file/filed_campaign.hpp"
#include "campaign_file/publish.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "member/array_output.hpp"
#include "member/quantity.hpp"
#include "run/progress.hpp"

namespace floes {

namespace {

namespace fs = std::filesystem;

constexpr double told_clock = 60;           // s
constexpr std::size_t most_told = 20;       // ranges or sentences of a kind
constexpr std::uint64_t stretch = 1 << 20;  // bytes read at a time

/// "2, 5-9, 12"
std::string ranges(const std::vector<int>& sorted) {
    std::vector<std::string> texts;
    for (std::size_t k = 0; k < sorted.size();) {
        std::size_t last = k;
        while (last + 1 < sorted.size() && sorted[last + 1] == sorted[last] + 1) ++last;
        texts.push_back(last == k ? fmt::format("{}", sorted[k]) : fmt::format("{}-{}", sorted[k], sorted[last]));
        k = last + 1;
    }
    const std::size_t more = texts.size() > most_told ? texts.size() - most_told : 0;
    texts.resize(texts.size() - more);
    return fmt::format("{}{}", fmt::join(texts, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

/// Whether the numbers are the same bits; another zlib packs them otherwise. A file has no row of an array without
/// numbers.
bool same_array(const PackedArray& one, const PackedArray& other) {
    if (one == other) return true;
    const ArrayValues a = unpack(one);
    const ArrayValues b = unpack(other);
    const auto is_nan = [](double value) { return std::isnan(value); };
    if (std::ranges::all_of(a.values, is_nan) && std::ranges::all_of(b.values, is_nan)) return true;
    return a.sizes == b.sizes && std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(double)) == 0;
}

/// True if both are the same to the last bit, all but the times that they took.
bool same_result(const MemberRecord& one, const MemberRecord& other) {
    const auto equal = [](double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; };
    for (const Quantity& of : quantities)
        if (!equal(of.place.get(one.result), of.place.get(other.result))) return false;
    for (std::size_t k = 0; k < array_outputs.size(); ++k)
        if (!same_array(one.array(k), other.array(k))) return false;
    return true;
}

Parts::Part read_part(const fs::path& file) {
    Parts::Part part{.file = file, .journal = journal_path(file), .contents = {}, .campaign = {}};
    if (!fs::exists(part.journal))
        throw InputError(
            fmt::format("there is no journal {} beside {}; parts are read from their journals, so the two "
                        "files stay together. A campaign that has all its members needs no journal, and no other part.",
                        part.journal.string(), file.string()));
    part.contents = read_journal(part.journal);
    part.campaign = read_stored_campaign(part.contents, part.journal);
    return part;
}

/// Where the first session begins.
std::uint64_t end_of_loose(const JournalContents& contents) {
    return contents.session_begins.empty() ? contents.good_bytes : contents.session_begins.front();
}

/// Records before the first session that are no members: calibrations.
std::vector<JournalContents::Place> loose_others(const Parts::Part& part) {
    std::vector<JournalContents::Place> others;
    const OpenFile file = open_file(part.journal, O_RDONLY);
    const auto add = [&](std::uint64_t from, std::uint64_t to) {
        for (const auto& place : journal_format::records_between(file, from, to)) others.push_back(place);
    };
    const std::uint64_t end = end_of_loose(part.contents);
    std::uint64_t at = part.contents.first_record;
    for (const auto& [offset, size, piece] : part.contents.places) {
        if (piece > 0 || offset >= end) break;
        add(at, offset);
        at = offset + size;
    }
    add(at, end);
    return others;
}

Bytes bytes_at(const OpenFile& file, std::uint64_t offset, std::uint64_t size) {
    Bytes bytes(size);
    if (!read_at(file, offset, bytes))
        throw RunError(fmt::format("{} became shorter while it was read", file.path().string()));
    return bytes;
}

}  // namespace

Parts::Parts(std::span<const fs::path> files, bool merged_before) : merged_before_(merged_before) {
    for (const fs::path& file : files) parts_.push_back(read_part(file));
    check_campaigns();
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        notes_.add(parts_[k].contents.members);
        for (std::size_t record = 0; record < parts_[k].contents.places.size(); ++record)
            places_.push_back({k, record});
    }
    gather_loose();
    gather_sessions();
    apply_rule();
}

void Parts::apply_rule() {
    published_ = whole_campaign();
    matched_ = match_records(published_, notes_);
    rule_ = stop_rule_of(published_);
    for (std::size_t k = 0; rule_ && k < matched_.size(); ++k)
        if (matched_[k]) tell(rule_, member_key(published_, static_cast<int>(k)), read(*matched_[k]));
    if (rule_) rule_->look();
    if (rule_ && rule_->met()) {
        published_.arrangements = rule_->arrangements();
        matched_.resize(static_cast<std::size_t>(member_count(published_)));
    }
}

void Parts::check_campaigns() {
    for (std::size_t k = 1; k < parts_.size(); ++k) {
        const Campaign& largest = parts_[largest_].campaign;
        if (is_part_of(parts_[k].campaign, largest)) continue;
        if (is_part_of(largest, parts_[k].campaign)) {
            largest_ = k;
            continue;
        }
        throw InputError(
            fmt::format("{} belongs to a different campaign than {}: {}. Leave it out, or run that part "
                        "again with the configuration of the others.",
                        parts_[k].journal.string(), parts_[largest_].journal.string(),
                        fmt::join(differences(largest, parts_[k].campaign), "; ")));
    }
}

bool Parts::begins_with(const Block& longer, const Block& shorter) const {
    const OpenFile one = open_file(parts_[longer.part].journal, O_RDONLY);
    const OpenFile other = open_file(parts_[shorter.part].journal, O_RDONLY);
    for (std::uint64_t at = 0; at < shorter.to - shorter.from; at += stretch) {
        const std::uint64_t size = std::min(stretch, shorter.to - shorter.from - at);
        Bytes here(size);
        Bytes there(size);
        if (!read_at(one, longer.from + at, here) || !read_at(other, shorter.from + at, there) || here != there)
            return false;
    }
    return true;
}

bool Parts::is_loose(const Place& place) const {
    const JournalContents& contents = parts_[place.part].contents;
    const JournalContents::Place& at = contents.places[place.record];
    return at.piece > 0 || at.offset < end_of_loose(contents);
}

// A merged journal has these once, whatever was merged into it before: members by their number, since a session's notes
// of them do not say which record they mean, and all else by its bytes.
void Parts::gather_loose() {
    std::vector<Block> loose;
    std::set<std::tuple<int, int, int>> known;  // case, arrangement, and the attempt that failed
    for (std::size_t k = 0; k < places_.size(); ++k) {
        const MemberNote& note = notes_[k];
        const bool is_new = known.emplace(note.key, note.arrangement, note.done() ? 0 : note.attempt).second;
        if (!is_new || !is_loose(places_[k])) continue;
        const auto [offset, size, piece] = parts_[places_[k].part].contents.places[places_[k].record];
        loose.push_back({places_[k].part, piece, offset, offset + size});
    }
    std::set<Bytes> others;
    for (std::size_t k = 0; k < parts_.size(); ++k)
        for (const JournalContents::Place& place : loose_others(parts_[k]))
            if (others.insert(bytes_at(open_file(parts_[k].journal, O_RDONLY), place.offset, place.size)).second)
                loose.push_back({k, 0, place.offset, place.offset + place.size});
    std::ranges::sort(loose, {}, [](const Block& one) { return std::tuple(one.part, one.piece, one.from); });
    for (const Block& block : loose) {
        const bool follows = !blocks_.empty() && blocks_.back().part == block.part &&
                             blocks_.back().piece == block.piece && blocks_.back().to == block.from;
        if (follows) {
            blocks_.back().to = block.to;
        } else {
            blocks_.push_back(block);
        }
    }
}

void Parts::gather_sessions() {
    std::multimap<std::string, std::size_t> alike;  // blocks by the beginning of their session
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        const JournalContents& contents = parts_[k].contents;
        const std::vector<std::uint64_t>& begins = contents.session_begins;
        for (std::size_t i = 0; i < begins.size(); ++i) {
            const Block block{k, 0, begins[i], i + 1 < begins.size() ? begins[i + 1] : contents.good_bytes};
            const std::string begin = contents.sessions[i].started + " " + contents.sessions[i].host;
            const auto [first, last] = alike.equal_range(begin);
            const auto known = std::find_if(first, last, [&](const auto& entry) {
                Block& there = blocks_[entry.second];
                const bool longer = block.to - block.from > there.to - there.from;
                if (!(longer ? begins_with(block, there) : begins_with(there, block))) return false;
                if (longer) there = block;
                return true;
            });
            if (known != last) continue;
            alike.emplace(begin, blocks_.size());
            blocks_.push_back(block);
        }
    }
}

MemberRecord Parts::read(std::size_t record) const {
    const Place& place = places_[record];
    const Part& part = parts_[place.part];
    const JournalContents::Place& at = part.contents.places[place.record];
    const fs::path path = piece_path(part.journal, at.piece);
    if (latest_.path() != path) latest_ = open_file(path, O_RDONLY);
    return journal_format::read_member(latest_, at);
}

std::vector<Session> Parts::sessions() const {
    std::vector<Session> sessions;
    for (const Block& block : blocks_) {
        if (block.piece > 0) continue;
        const JournalContents& contents = parts_[block.part].contents;
        const auto begin = std::ranges::find(contents.session_begins, block.from);
        if (begin != contents.session_begins.end())
            sessions.push_back(contents.sessions[static_cast<std::size_t>(begin - contents.session_begins.begin())]);
    }
    return sessions;
}

std::vector<CalibrationRecord> Parts::calibrations() const {
    std::vector<CalibrationRecord> all;
    for (const Part& part : parts_)
        for (const CalibrationRecord& one : part.contents.calibrations)
            if (find_calibration(all, one.key) == nullptr) all.push_back(one);
    return all;
}

CampaignPart Parts::place_of(std::size_t part) const {
    const std::vector<Session>& sessions = parts_[part].contents.sessions;
    if (sessions.empty()) return {};
    const Session& first = sessions.front();
    const auto same = [&](const Session& one) { return one.part == first.part && one.parts == first.parts; };
    return std::ranges::all_of(sessions, same) ? CampaignPart{first.part, first.parts} : CampaignPart{};
}

PartCount Parts::count(std::size_t part) const {
    PartCount count;
    const CampaignPart place = place_of(part);
    const MemberNotes& notes = parts_[part].contents.members;
    const auto matched = match_records(published_, notes);
    for (std::size_t k = 0; k < matched.size(); ++k) {
        if (!place.has(member_key(published_, static_cast<int>(k)).arrangement)) continue;
        ++(!matched[k] ? count.missing : notes[*matched[k]].done() ? count.done : count.failed);
    }
    return count;
}

std::vector<std::string> Parts::remarks() const {
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        if (parts_[k].campaign.arrangements == whole_campaign().arrangements &&
            parts_[k].campaign.cases.size() == whole_campaign().cases.size())
            continue;
        if (k == 0 && merged_before_) continue;
        sentences.push_back(fmt::format("{} was run for a smaller campaign: {}", parts_[k].file.string(),
                                        fmt::join(differences(parts_[k].campaign, whole_campaign()), "; ")));
    }
    add_twins(sentences);
    add_builds(sentences);
    add_clocks(sentences);
    add_unfinished(sentences);
    return sentences;
}

void Parts::add_twins(std::vector<std::string>& sentences) const {
    struct Twins {
        std::vector<int> members;
        std::vector<int> different;
    };
    std::map<std::pair<std::size_t, std::size_t>, Twins> twins;  // by first and later part
    std::map<MemberIdentity, std::size_t> first;                 // the record of each done member
    std::map<int, std::string> keys;
    for (const auto& [key, number] : notes_.keys()) keys[number] = key;
    std::map<MemberIdentity, int> numbers;
    const std::vector<std::string> case_keys = case_fingerprints(whole_campaign());
    for (int number = 0; number < member_count(whole_campaign()); ++number) {
        const MemberKey key = member_key(whole_campaign(), number);
        numbers.try_emplace({case_keys[static_cast<std::size_t>(key.case_index)], key.arrangement}, number);
    }
    for (std::size_t k = 0; k < notes_.size(); ++k) {
        if (!notes_[k].done() || (merged_before_ && places_[k].part == 0)) continue;
        const MemberIdentity member{keys.at(notes_[k].key), notes_[k].arrangement};
        const auto [known, is_new] = first.try_emplace(member, k);
        const auto number = numbers.find(member);
        if (is_new || number == numbers.end() || places_[known->second].part == places_[k].part) continue;
        Twins& pair = twins[{places_[known->second].part, places_[k].part}];
        pair.members.push_back(number->second);
        if (!same_result(read(known->second), read(k))) pair.different.push_back(number->second);
    }
    for (auto& [pair, found] : twins) {
        std::ranges::sort(found.members);
        std::ranges::sort(found.different);
        const std::string told = fmt::format(
            "{} of {} {} in {} too", counted(std::ssize(found.members), "member"), parts_[pair.second].file.string(),
            found.members.size() == 1 ? "is" : "are", parts_[pair.first].file.string());
        sentences.push_back(
            found.different.empty()
                ? fmt::format("{}, with the same results; they count once.", told)
                : fmt::format("{}, and {} of them differ (members {}): the two were not computed by the same build, "
                              "or a machine computes wrong. Those of {} count.",
                              told, found.different.size(), ranges(found.different), parts_[pair.first].file.string()));
    }
}

void Parts::add_builds(std::vector<std::string>& sentences) const {
    const Session* first = nullptr;
    const Part* of = nullptr;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        const Part& part = parts_[k];
        for (const Session& session : part.contents.sessions) {
            if (first == nullptr) {
                first = &session;
                of = &part;
            }
            if (k == 0 && merged_before_) break;  // whose own builds were told when they were merged
            const std::vector<std::string> changes =
                changed_software(*first, session, "in " + of->file.string(), "in " + part.file.string());
            if (changes.empty()) continue;
            sentences.push_back(
                fmt::format("{} was computed by another build, so single members may differ in the "
                            "last bits: {}.",
                            part.file.string(), fmt::join(changes, "; ")));
            break;
        }
    }
}

void Parts::add_clocks(std::vector<std::string>& sentences) const {
    for (std::size_t k = merged_before_ ? 1 : 0; k < parts_.size(); ++k) {
        for (const Session& session : parts_[k].contents.sessions) {
            if (std::abs(session.clock_ahead) < told_clock) continue;
            sentences.push_back(fmt::format(
                "{} was run on a clock that is off: that of {} was {} {} that of the file system. Only the times of "
                "its sessions are, by as much.",
                parts_[k].file.string(), session.host, duration_text(std::abs(session.clock_ahead)),
                session.clock_ahead > 0 ? "ahead of" : "behind"));
            break;
        }
    }
}

void Parts::add_unfinished(std::vector<std::string>& sentences) const {
    std::size_t told = 0;
    std::size_t all = 0;
    for (std::size_t k = merged_before_ ? 1 : 0; k < parts_.size(); ++k) {
        const CampaignPart place = place_of(k);
        const PartCount found = count(k);
        if (place.of == 1 || found.missing == 0 || ++all > most_told) continue;
        ++told;
        const Session& last = parts_[k].contents.sessions.back();
        const std::string state = is_at_work(parts_[k].journal) ? fmt::format("it runs on {}", last.host)
                                  : !last.ended.empty() ? fmt::format("it ended {} ({})", last.ended, last.outcome)
                                                        : fmt::format("it was killed on {}", last.host);
        sentences.push_back(fmt::format("{}, part {} of {}, has {} of its {}: {}.", parts_[k].file.string(),
                                        place.number, place.of, found.done,
                                        counted(found.done + found.failed + found.missing, "member"), state));
    }
    if (all > told) sentences.push_back(fmt::format("{} more are not complete.", all - told));
}

std::string Parts::missing_parts() const {
    std::set<int> given;
    int of = 0;
    for (const Session& session : sessions()) {
        if (session.parts == 1) continue;
        if (of != 0 && of != session.parts) return {};  // of different divisions
        of = session.parts;
        given.insert(session.part);
    }
    std::vector<int> missing;
    for (int k = 1; k <= of; ++k)
        if (!given.contains(k)) missing.push_back(k);
    if (missing.empty()) return {};
    return fmt::format("Of {} there is no file of {} {}.", counted(of, "part"), missing.size() == 1 ? "part" : "parts",
                       ranges(missing));
}

std::string Parts::missing_members() const {
    const std::size_t cases = published_.cases.size();
    std::vector<int> whole;
    std::vector<std::vector<int>> single(cases);
    int missing = 0;
    for (int arrangement = 0; arrangement < published_.arrangements; ++arrangement) {
        std::vector<std::size_t> lacking;
        for (std::size_t k = 0; k < cases; ++k)
            if (!matched_[static_cast<std::size_t>(arrangement) * cases + k]) lacking.push_back(k);
        missing += static_cast<int>(lacking.size());
        if (lacking.size() == cases) {
            whole.push_back(arrangement);
            continue;
        }
        for (const std::size_t k : lacking) single[k].push_back(arrangement);
    }
    if (missing == 0) return {};
    std::vector<std::string> texts;
    if (!whole.empty())
        texts.push_back(fmt::format("all of {} {}", whole.size() == 1 ? "arrangement" : "arrangements", ranges(whole)));
    for (std::size_t k = 0; k < cases; ++k)
        if (!single[k].empty())
            texts.push_back(fmt::format("of case {} {} {}", published_.cases[k].name,
                                        single[k].size() == 1 ? "arrangement" : "arrangements", ranges(single[k])));
    return fmt::format("{} {} missing: {}.", counted(missing, "member"), missing == 1 ? "is" : "are",
                       fmt::join(texts, "; "));
}

bool is_at_work(const fs::path& journal) {
    if (is_being_written(journal)) return true;
    const std::optional<Heartbeat> heartbeat = read_heartbeat(heartbeat_path(journal));
    return heartbeat && !is_stale(*heartbeat);
}

std::vector<fs::path> other_parts(const fs::path& file, const CampaignPart& part) {
    std::vector<fs::path> others;
    const std::string stem = fs::path(file).replace_extension("").string();
    const std::string own = fmt::format(".part{}", part.number);
    if (!stem.ends_with(own)) return others;
    for (int k = 1; k <= part.of; ++k) {
        const fs::path other = fmt::format("{}.part{}.h5", stem.substr(0, stem.size() - own.size()), k);
        if (k != part.number && fs::exists(journal_path(other))) others.push_back(other);
    }
    return others;
}

namespace {

void remove_pieces(const fs::path& journal) {
    for (const int number : pieces_of(journal)) fs::remove(piece_path(journal, number));
}

/// Puts a journal in the place of what stands there, once `write` has written it aside. `adds`: it has the members of
/// what stands there.
void replace_journal(const fs::path& journal, bool adds, const std::function<void(const fs::path& aside)>& write) {
    const fs::path aside = journal.string() + ".tmp";
    try {
        write(aside);
    } catch (...) {
        std::error_code ignored;
        fs::remove(aside, ignored);
        throw;
    }
    if (!adds) remove_pieces(journal);
    rename_into_place(aside, journal);
    remove_pieces(journal);  // the journal has their members now
}

/// The journal of a campaign that is whole in a file without one.
void make_journal(const fs::path& journal, const fs::path& campaign_file) {
    const FiledCampaign filed = read_filed(campaign_file);
    replace_journal(journal, false, [&](const fs::path& aside) {
        Journal made = open_journal(aside, filed.campaign, Existing::replace);
        take_in(filed, filed.campaign, made);
    });
}

/// What only the file beside a journal has: that of a run that was stopped while it made its journal from the file.
void complete_journal(const fs::path& journal, const fs::path& campaign_file) {
    std::optional<FiledCampaign> filed;
    try {
        filed = read_filed(campaign_file);
    } catch (const std::runtime_error&) {
        return;  // a damaged one is made anew from its journal
    }
    const Campaign campaign = read_stored_campaign(read_journal(journal), journal);
    Journal completed = open_journal(journal, campaign, Existing::resume);
    take_in(*filed, campaign, completed);
}

/// Whether the output has members already that are kept.
bool check_output(std::span<const fs::path> parts, const fs::path& output, bool overwrite) {
    const fs::path journal = journal_path(output);
    for (const fs::path& part : parts) {
        if (fs::weakly_canonical(journal_path(part)) == fs::weakly_canonical(journal))
            throw InputError(fmt::format("{} cannot be merged into itself; -o names another file.", part.string()));
    }
    std::vector<fs::path> written{journal};
    for (const int number : pieces_of(journal)) written.push_back(piece_path(journal, number));
    for (const fs::path& path : written)
        if (fs::exists(path) && is_being_written(path))
            throw InputError(fmt::format("{} is being written by a run.", path.string()));
    if (overwrite) return false;
    if (fs::exists(journal)) {
        if (fs::exists(output)) complete_journal(journal, output);
        return true;
    }
    if (written.size() > 1)
        throw InputError(
            fmt::format("{} exists already but not its journal {}, so nothing can be added to it: --overwrite replaces "
                        "it, -o names another file.",
                        written.back().string(), journal.string()));
    if (!fs::exists(output)) return false;
    make_journal(journal, output);
    return true;
}

/// Copies the block unchanged, because the order of sessions and attempts matters.
void copy_block(const OpenFile& out, const OpenFile& from, const Parts::Block& block) {
    for (std::uint64_t at = block.from; at < block.to; at += stretch)
        write_all(out, bytes_at(from, at, std::min(stretch, block.to - at)));
}

void write_journal(const Parts& parts, const fs::path& aside) {
    const OpenFile out = open_file(aside, O_WRONLY | O_CREAT | O_TRUNC);
    write_all(out, journal_format::header(write_campaign(parts.whole_campaign())));
    for (const Parts::Block& block : parts.blocks())
        copy_block(out, open_file(piece_path(parts.all()[block.part].journal, block.piece), O_RDONLY), block);
    sync_data(out);
}

void publish_merged(const Parts& read, const fs::path& output) {
    const Journal merged = open_journal(journal_path(output), read.whole_campaign(), Existing::resume);
    publish(output, read.campaign(), merged.members(), merged.contents().sessions, merged.contents().calibrations);
}

}  // namespace

Parts merge_campaigns(std::span<const fs::path> parts, const fs::path& output, bool overwrite) {
    const bool adds = check_output(parts, output, overwrite);
    const fs::path journal = journal_path(output);
    if (!adds && parts.size() == 1 && fs::exists(parts.front()) && !fs::exists(journal_path(parts.front()))) {
        make_journal(journal, parts.front());
        Parts read(std::span(&output, 1), true);
        publish_merged(read, output);
        return read;
    }
    std::vector<fs::path> files(parts.begin(), parts.end());
    if (adds) files.insert(files.begin(), output);
    Parts read(files, adds);
    replace_journal(journal, adds, [&](const fs::path& aside) { write_journal(read, aside); });
    publish_merged(read, output);
    return read;
}

}  // namespace floes
