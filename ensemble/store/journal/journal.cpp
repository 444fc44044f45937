#include "journal/journal.hpp"

#include <fcntl.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <memory>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/identity.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "core/error.hpp"
#include "journal/journal_format.hpp"

namespace floes {
namespace {

using journal_format::RecordType;

constexpr std::size_t most_appended = 1 << 20;  // bytes buffered before a write()

struct flock whole_file(short type) {
    struct flock lock {};
    lock.l_type = type;
    lock.l_whence = SEEK_SET;
    return lock;
}

// Locks of the open file, not of the process, so that they also work between two journals of one process. A file system
// without locks lets both in (docs/campaign_file.md).
void lock_for_writing(const Descriptor& file, const std::filesystem::path& path) {
    auto lock = whole_file(F_WRLCK);
    if (::fcntl(file.get(), F_OFD_SETLK, &lock) == 0 || (errno != EAGAIN && errno != EACCES)) return;
    throw InputError(
        fmt::format("{} is being written by another run. Wait for it, stop it, or choose another output "
                    "file with -o.",
                    path.string()));
}

std::string load_nothing(const std::string& path) {
    throw InputError(
        fmt::format("the configuration in a journal refers to the file {}, which should be part of it", path));
}

Campaign read_text(const std::string& campaign_text, const std::filesystem::path& path) {
    return read_campaign({campaign_text, path.string(), {}}, load_nothing);
}

/// True if every member of `part` is one of `whole`. Names and order of cases do not matter.
bool is_part_of(const Campaign& part, const Campaign& whole) {
    std::set<std::string> keys;
    for (int k = 0; k < static_cast<int>(whole.cases.size()); ++k) keys.insert(case_fingerprint(whole, k));
    for (int k = 0; k < static_cast<int>(part.cases.size()); ++k)
        if (!keys.contains(case_fingerprint(part, k))) return false;
    return part.arrangements <= whole.arrangements;
}

}  // namespace

std::filesystem::path journal_path(const std::filesystem::path& campaign_file) {
    return std::filesystem::path(campaign_file).replace_extension(".journal");
}

Journal::Journal(std::filesystem::path path, Descriptor file, JournalContents contents)
    : path_(std::move(path)), file_(std::move(file)), contents_(std::move(contents)) {}

Journal::~Journal() {
    try {
        hand_over();
    } catch (const std::exception&) {
        // Callers that need the error call sync(), which reports it.
    }
}

Journal open_journal(const std::filesystem::path& path, const std::string& campaign_text, Existing existing) {
    Descriptor file = open_file(path, O_RDWR | O_CREAT | O_APPEND);
    lock_for_writing(file, path);
    if (existing != Existing::replace) {
        journal_format::Reading reading = journal_format::read(file, path);
        if (reading.begun) {
            if (existing == Existing::refuse)
                throw InputError(
                    fmt::format("{} exists already. Continue it with --resume, start afresh with "
                                "--overwrite, or choose another output file with -o.",
                                path.string()));
            truncate_file(file, path, reading.contents.good_bytes);
            reading.contents.attempts.close_session();  // no other run is active, because we hold the lock
            return {path, std::move(file), std::move(reading.contents)};
        }
    }
    const Bytes header = journal_format::header(campaign_text);
    truncate_file(file, path, 0);
    write_all(file, path, header);
    sync_data(file, path);
    sync_folder_of(path);
    JournalContents contents;
    contents.campaign_text = campaign_text;
    contents.good_bytes = header.size();
    return {path, std::move(file), std::move(contents)};
}

Journal open_journal(const std::filesystem::path& path, const Campaign& campaign, Existing existing) {
    const std::string here = write_campaign(campaign);
    Journal journal = open_journal(path, here, existing);
    if (journal.campaign_text() == here) return journal;
    const Campaign there = read_text(journal.campaign_text(), path);
    const bool same_members = fingerprint(there) == fingerprint(campaign);
    if (same_members && there.stop == campaign.stop) return journal;
    if (same_members || is_part_of(there, campaign)) {
        journal.extend(there, campaign);
        return journal;
    }
    if (is_part_of(campaign, there))
        throw InputError(fmt::format(
            "{} has more members than this configuration: {}. A campaign may grow but not shrink: ask for at least as "
            "many, or choose another output file with -o.",
            path.string(), fmt::join(differences(there, campaign), "; ")));
    throw InputError(
        fmt::format("{} belongs to another campaign: {}. Give the configuration it was started with, choose "
                    "another output file with -o, or start afresh with --overwrite.",
                    path.string(), fmt::join(differences(there, campaign), "; ")));
}

void Journal::extend(const Campaign& there, const Campaign& here) {
    ByteWriter payload;
    payload.text(write_campaign(here));
    write_record(static_cast<std::uint32_t>(RecordType::campaign), payload.bytes());
    sync();
    contents_.campaign_text = write_campaign(here);
    extension_ = differences(there, here);
}

void Journal::write_record(std::uint32_t type, std::span<const std::byte> payload) {
    const Bytes bytes = journal_format::record(static_cast<RecordType>(type), payload);
    appended_.insert(appended_.end(), bytes.begin(), bytes.end());
    contents_.good_bytes += bytes.size();
    if (appended_.size() >= most_appended) hand_over();
}

void Journal::hand_over() {
    if (appended_.empty()) return;
    const Bytes bytes = std::exchange(appended_, {});
    try {
        write_all(file_, path_, bytes);
    } catch (const RunError&) {
        // Half a record would hide every later one from the reader.
        contents_.good_bytes -= bytes.size();
        truncate_file(file_, path_, contents_.good_bytes);
        throw;
    }
}

void Journal::append(const MemberRecord& record) {
    const std::uint64_t offset = contents_.good_bytes;
    write_record(static_cast<std::uint32_t>(RecordType::member), encode(record));
    contents_.add(record, {offset, contents_.good_bytes - offset});
}

StoredMembers Journal::members() const {
    return {contents_.members,
            [this](std::size_t k) { return journal_format::read_member(file_, path_, contents_.places.at(k)); }};
}

void Journal::append(const CalibrationRecord& record) {
    if (find_calibration(contents_.calibrations, record.key) != nullptr) return;
    write_record(static_cast<std::uint32_t>(RecordType::calibration), encode(record));
    contents_.calibrations.push_back(record);
}

void Journal::started(const MemberIdentity& member, int attempt) {
    ByteWriter payload;
    payload.text(member.first);
    payload.i32(member.second);
    payload.i32(attempt);
    write_record(static_cast<std::uint32_t>(RecordType::attempt_started), payload.bytes());
    contents_.attempts.started(member);
}

void Journal::sync() {
    hand_over();
    sync_data(file_, path_);
    // A deleted file accepts writes, but they are lost.
    if (!is_named(file_, path_))
        throw RunError(
            fmt::format("{} is gone: its folder was deleted, moved or replaced during the run.", path_.string()));
}

void Journal::begin_session(const Session& session) {
    write_record(static_cast<std::uint32_t>(RecordType::session_begin), encode(session));
    contents_.begin(session);
    sync();
}

void Journal::end_session(const std::string& outcome) {
    const std::string now = utc_now();
    contents_.end(now, outcome);
    ByteWriter payload;
    payload.text(now);
    payload.text(outcome);
    write_record(static_cast<std::uint32_t>(RecordType::session_end), payload.bytes());
    sync();
}

JournalContents read_journal(const std::filesystem::path& path) {
    const Descriptor file = open_file(path, O_RDONLY);
    journal_format::Reading reading = journal_format::read(file, path);
    if (!reading.begun) throw InputError(fmt::format("{} is still empty.", path.string()));
    return std::move(reading.contents);
}

StoredMembers stored_members(const JournalContents& contents, const std::filesystem::path& path) {
    const auto file = std::make_shared<const Descriptor>(open_file(path, O_RDONLY));
    return {contents.members, [&contents, path, file](std::size_t k) {
                return journal_format::read_member(*file, path, contents.places.at(k));
            }};
}

Campaign read_stored_campaign(const JournalContents& contents, const std::filesystem::path& path) {
    return read_text(contents.campaign_text, path);
}

bool is_being_written(const std::filesystem::path& path) {
    const Descriptor file = open_file(path, O_RDONLY);
    auto lock = whole_file(F_WRLCK);
    return ::fcntl(file.get(), F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

}  // namespace floes
