#include "store/journal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <boost/crc.hpp>

#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "core/fields.hpp"

namespace floes::journal_format {

namespace {

constexpr std::uint64_t least_effort = 1 << 30;  // bytes; a second

using Crc32c = boost::crc_optimal<32, 0x1EDC6F41, 0xFFFFFFFF, 0xFFFFFFFF, true, true>;

#ifdef __x86_64__
// The checksum of histories dominated the master's cost per member; the processor's instruction is ten times faster.
__attribute__((target("sse4.2"))) std::uint32_t crc32c_by_processor(std::span<const std::byte> bytes) {
    std::uint64_t crc = 0xFFFFFFFF;
    for (; bytes.size() >= sizeof(std::uint64_t); bytes = bytes.subspan(sizeof(std::uint64_t))) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, bytes.data(), sizeof eight);
        crc = __builtin_ia32_crc32di(crc, eight);
    }
    auto rest = static_cast<std::uint32_t>(crc);
    for (const std::byte one : bytes) rest = __builtin_ia32_crc32qi(rest, static_cast<std::uint8_t>(one));
    return ~rest;
}
#endif

void append(Bytes& bytes, std::span<const std::byte> more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

void append_crc(Bytes& bytes, std::span<const std::byte> of) {
    ByteWriter crc;
    crc.u32(crc32c(of));
    append(bytes, crc.bytes());
}

bool crc_is_right(std::span<const std::byte> with_crc) {
    const auto covered = with_crc.first(with_crc.size() - crc_bytes);
    return ByteReader(with_crc.last(crc_bytes)).u32() == crc32c(covered);
}

[[noreturn]] void refuse(const std::filesystem::path& path, std::string_view why) {
    throw InputError(fmt::format("{} {}. Move it away, or start afresh with --overwrite.", path.string(), why));
}

bool magic_fits(std::span<const std::byte> bytes) {
    const auto first = bytes.first(std::min(bytes.size(), magic.size()));
    return magic.starts_with(std::string_view(reinterpret_cast<const char*>(first.data()), first.size()));
}

// The text length from the complete fixed part of a header.
std::uint64_t check_fixed_header(std::span<const std::byte> bytes, const std::filesystem::path& path) {
    ByteReader in(bytes.subspan(magic.size()));
    const std::uint32_t found = in.u32();
    const std::uint64_t length = in.u64();
    const bool whole = crc_is_right(bytes);
    if (whole && found > schema)
        throw NewerJournal(
            fmt::format("{} is a journal of schema {}, and this program knows schemas up to {}. Use the "
                        "version of floes that wrote it, or a newer one.",
                        path.string(), found, schema));
    if (!whole || found == 0) refuse(path, "is a journal whose header is damaged");
    if (found < schema)
        refuse(path, fmt::format("is a journal of schema {}, from before floes 2.0, which this program does not read "
                                 "any more; floes 2.0.0 does",
                                 found));
    return length;
}

/// Reads the record at `at`; false if there is no whole record.
bool read_record(const OpenFile& file, std::uint64_t at, std::uint64_t size, Bytes& bytes) {
    if (size - at < record_head_bytes + crc_bytes) return false;
    bytes.resize(record_head_bytes);
    if (!read_at(file, at, bytes)) return false;
    const std::uint64_t payload = ByteReader(bytes).u64();
    // Only a length that fits the file is accepted, so that a damaged one cannot cause a huge allocation.
    if (payload > size - at - record_head_bytes - crc_bytes) return false;
    bytes.resize(record_head_bytes + payload + crc_bytes);
    return read_at(file, at, bytes) && crc_is_right(bytes);
}

/// Offset of the next whole record from `at` on; `size` if there is none. Records after a damaged one were acknowledged
/// too and must not be lost. `effort`: bytes that may still be read for what only looks like a record; bytes made for
/// it look like one everywhere.
std::uint64_t next_record(const OpenFile& file, std::uint64_t at, std::uint64_t size, std::uint64_t& effort) {
    constexpr std::uint64_t most_in_window = 1 << 20;
    constexpr std::uint32_t types = 256;  // a filter: more types than there will ever be
    Bytes bytes;
    std::uint64_t window_bytes = 1 << 12;  // most damage is short
    for (Bytes window; size > at && size - at >= record_head_bytes + crc_bytes;) {
        window.resize(std::min(window_bytes, size - at));
        window_bytes = std::min(2 * window_bytes, most_in_window);
        if (!read_at(file, at, window)) break;
        const std::uint64_t heads = window.size() - record_head_bytes + 1;
        for (std::uint64_t k = 0; k < heads; ++k) {
            ByteReader head{std::span<const std::byte>(window).subspan(k, record_head_bytes)};
            const std::uint64_t payload = head.u64();
            const std::uint32_t type = head.u32();
            if (payload >= size - at - k || type == 0 || type >= types) continue;
            if (payload > effort)
                refuse(file.path(),
                       fmt::format("is a journal with so much that looks like a record after byte {} that its "
                                   "records cannot be found",
                                   at));
            effort -= payload;
            if (read_record(file, at + k, size, bytes)) return at + k;
        }
        at += heads;
    }
    return size;
}

std::uint32_t type_of(std::span<const std::byte> record) {
    return ByteReader(record.subspan(8)).u32();
}

void take_record(JournalContents& contents, std::uint32_t type, std::span<const std::byte> payload,
                 JournalContents::Place place) {
    ByteReader in(payload);
    switch (static_cast<RecordType>(type)) {
        case RecordType::member:
            contents.add(decode_member_record(payload), place);
            break;
        case RecordType::session_begin:
            contents.begin(decode_session(payload), place.offset);
            break;
        case RecordType::session_end: {
            const std::string when = in.text();
            contents.end(when, in.text());
            break;
        }
        case RecordType::calibration:
            contents.calibrations.push_back(decode_calibration_record(payload));
            break;
        case RecordType::attempt_started:
            contents.attempts.started({in.text(), in.i32()});
            break;
        case RecordType::campaign:
            contents.campaign_text = in.text();
            break;
        case RecordType::session_surroundings:
            if (!contents.sessions.empty()) decode_surroundings(payload, contents.sessions.back());
            break;
        case RecordType::done_in_piece:
            contents.add_done({in.text(), in.i32()});
            break;
        case RecordType::session_counts:
            if (contents.sessions.empty()) break;
            contents.sessions.back().computed = in.i32();
            contents.sessions.back().set_aside = in.i32();
            break;
    }
}

/// A piece that is there, but whose writer was stopped inside the header, is as good as none.
constexpr std::uint64_t not_begun = 0;

/// Where whole records end and what between them is damaged.
struct Walked {
    std::uint64_t good_bytes = 0;
    std::uint64_t damaged_bytes = 0;
};

/// Calls `use` with the bytes and the offset of each whole record between `at` and `size`.
template <class Use>
Walked walk(const OpenFile& file, std::uint64_t at, std::uint64_t size, const Use& use) {
    Walked walked{at, 0};
    std::uint64_t effort = std::max(4 * size, least_effort);
    for (Bytes bytes; true;) {
        if (!read_record(file, at, size, bytes)) {
            const std::uint64_t next = next_record(file, at + 1, size, effort);
            if (next == size) return walked;
            walked.damaged_bytes += next - at;
            at = next;
            continue;
        }
        use(std::span<const std::byte>(bytes), at);
        at += bytes.size();
        walked.good_bytes = at;
    }
}

std::span<const std::byte> payload_of(std::span<const std::byte> record) {
    return record.subspan(record_head_bytes).first(record.size() - record_head_bytes - crc_bytes);
}

/// The text of the header of a file of that size, and where its records begin; empty if the file ends before they do.
struct Header {
    std::string text;
    std::uint64_t end = 0;
};
std::optional<Header> read_header(const OpenFile& file, std::uint64_t size) {
    Bytes fixed(std::min(size, fixed_header_bytes));
    read_at(file, 0, fixed);
    if (!magic_fits(fixed)) refuse(file.path(), "is not a journal of floes");
    if (fixed.size() < fixed_header_bytes) return {};
    const std::uint64_t length = check_fixed_header(fixed, file.path());
    const std::uint64_t room = size - fixed_header_bytes;
    if (room < crc_bytes || length > room - crc_bytes) return {};
    Bytes text(length + crc_bytes);
    read_at(file, fixed_header_bytes, text);
    if (!crc_is_right(text)) refuse(file.path(), "is a journal whose configuration is damaged");
    return Header{std::string(reinterpret_cast<const char*>(text.data()), length),
                  fixed_header_bytes + length + crc_bytes};
}

/// Whether this is what a power cut left of a header of that text: zeros stand for what had not come to the disk.
bool is_torn_header(const OpenFile& file, std::uint64_t size, std::string_view text) {
    if (size == 0 || size > fixed_header_bytes + text.size() + crc_bytes) return false;
    const Bytes whole = header(text);
    Bytes found(size);
    if (!read_at(file, 0, found)) return false;
    const auto fits = [](std::byte one, std::byte of_whole) { return one == of_whole || one == std::byte{0}; };
    return found != whole && std::ranges::equal(found, std::span(whole).first(found.size()), fits);
}

/// Whether so many bytes at the end of a file may be the begin of a record, and no damaged one.
bool is_begin_of_record(const OpenFile& file, std::uint64_t at, std::uint64_t size) {
    if (size < record_head_bytes + crc_bytes) return true;
    Bytes head(record_head_bytes);
    if (!read_at(file, at, head)) return true;
    return ByteReader(head).u64() > size - record_head_bytes - crc_bytes;
}

/// Adds the members that the piece has beyond what was read of it.
void read_piece(const std::filesystem::path& journal, JournalContents& contents, JournalContents::Piece& piece,
                const System& system) {
    const OpenFile file = open_file(piece_path(journal, piece.number), O_RDONLY, system);
    const std::uint64_t size = file_size(file);
    if (piece.good_bytes == not_begun) {
        if (is_torn_header(file, size, contents.campaign_text)) return;
        const std::optional<Header> header = read_header(file, size);
        if (!header) return;
        piece.good_bytes = header->end;
    }
    const Walked walked = walk(file, piece.good_bytes, size, [&](auto record, std::uint64_t at) {
        if (static_cast<RecordType>(type_of(record)) != RecordType::member) return;
        contents.add(decode_member_record(payload_of(record)), {at, record.size(), piece.number});
    });
    contents.damaged_bytes += walked.damaged_bytes;
    piece.good_bytes = walked.good_bytes;
    const std::uint64_t tail = size - walked.good_bytes;
    if (!is_begin_of_record(file, walked.good_bytes, tail)) contents.damaged_bytes += tail;
}

}  // namespace

std::uint32_t crc32c(std::span<const std::byte> bytes) {
#ifdef __x86_64__
    if (__builtin_cpu_supports("sse4.2") != 0) return crc32c_by_processor(bytes);
#endif
    Crc32c crc;
    crc.process_bytes(bytes.data(), bytes.size());
    return crc.checksum();
}

MemberRecord read_member(const OpenFile& file, JournalContents::Place place) {
    Bytes bytes(place.size);
    if (!read_at(file, place.offset, bytes) || !crc_is_right(bytes))
        throw RunError(
            fmt::format("{} was changed or damaged at byte {} while it was in use; --resume continues with what is "
                        "whole.",
                        file.path().string(), place.offset));
    return decode_member_record(payload_of(bytes));
}

Bytes header(std::string_view text) {
    Bytes bytes;
    append(bytes, std::as_bytes(std::span(magic)));
    ByteWriter fixed;
    fixed.u32(schema);
    fixed.u64(text.size());
    append(bytes, fixed.bytes());
    append_crc(bytes, Bytes(bytes));
    append(bytes, std::as_bytes(std::span(text)));
    append_crc(bytes, std::as_bytes(std::span(text)));
    return bytes;
}

Bytes record(RecordType type, std::span<const std::byte> payload) {
    ByteWriter head;
    head.u64(payload.size());
    head.u32(static_cast<std::uint32_t>(type));
    Bytes bytes = head.take();
    bytes.reserve(bytes.size() + payload.size() + crc_bytes);
    append(bytes, payload);
    append_crc(bytes, std::span<const std::byte>(bytes));
    return bytes;
}

std::optional<JournalContents> read(const OpenFile& file, std::span<const std::string> texts) {
    // The size is read once: data that a live writer adds meanwhile is left to the next reader.
    const std::uint64_t size = file_size(file);
    for (const std::string& text : texts)
        if (is_torn_header(file, size, text)) return {};
    std::optional<Header> header = read_header(file, size);
    if (!header) return {};
    JournalContents contents;
    contents.first_record = header->end;
    contents.campaign_text = std::move(header->text);
    const Walked walked = walk(file, header->end, size, [&](auto record, std::uint64_t at) {
        take_record(contents, type_of(record), payload_of(record), {at, record.size()});
    });
    contents.damaged_bytes = walked.damaged_bytes;
    contents.good_bytes = walked.good_bytes;
    contents.torn_bytes = size - walked.good_bytes;
    return contents;
}

void read_pieces(const std::filesystem::path& path, JournalContents& contents, const System& system) {
    for (const int number : pieces_of(path, system)) {
        if (std::ranges::find(contents.pieces, number, &JournalContents::Piece::number) == contents.pieces.end())
            contents.pieces.push_back({number, not_begun});
    }
    std::ranges::sort(contents.pieces, {}, &JournalContents::Piece::number);
    for (JournalContents::Piece& piece : contents.pieces) read_piece(path, contents, piece, system);
}

std::vector<JournalContents::Place> records_between(const OpenFile& file, std::uint64_t from, std::uint64_t to) {
    std::vector<JournalContents::Place> places;
    walk(file, from, to, [&](auto record, std::uint64_t at) { places.push_back({at, record.size()}); });
    return places;
}

bool tail_is_torn(const std::filesystem::path& path, const JournalContents& contents) {
    return is_begin_of_record(open_file(path, O_RDONLY), contents.good_bytes, contents.torn_bytes);
}

}  // namespace floes::journal_format

namespace floes {

void JournalContents::add(const MemberRecord& record, Place place) {
    attempts.finished(identity(record));
    if (!sessions.empty() && place.piece == 0) {
        Session& session = sessions.back();
        ++(record.result.status == MemberStatus::done ? session.computed : session.set_aside);
    }
    members.add(record);
    places.push_back(place);
}

void JournalContents::add_done(const MemberIdentity& member) {
    attempts.finished(member);
    if (!sessions.empty()) ++sessions.back().computed;
}

void JournalContents::begin(const Session& session, std::uint64_t at) {
    attempts.close_session();
    sessions.push_back(session);
    session_begins.push_back(at);
}

void JournalContents::end(const std::string& when, const std::string& outcome) {
    attempts.session_ended();
    if (sessions.empty()) return;
    sessions.back().ended = when;
    sessions.back().outcome = outcome;
}

namespace {

using journal_format::RecordType;

constexpr std::size_t most_appended = 1 << 20;  // bytes buffered before a write()
constexpr double least_told_difference = 10;    // s between two clocks; a sync to a busy disk takes seconds

[[noreturn]] void refuse_second_writer(const std::filesystem::path& path) {
    throw InputError(
        fmt::format("{} is being written by another run. Wait for it, stop it, or choose another output "
                    "file with -o.",
                    path.string()));
}

/// Refuses if one of them has a writer still, whose master was lost; removes them where the journal is replaced.
void settle_pieces(const std::filesystem::path& journal, Existing existing, const System& system) {
    const std::vector<int> numbers = pieces_of(journal, system);
    for (const int number : numbers)
        if (is_being_written(piece_path(journal, number), system)) refuse_second_writer(piece_path(journal, number));
    if (existing != Existing::replace) return;
    for (const int number : numbers) remove_file(piece_path(journal, number), system);
}

/// What is read of pieces may be in the system's memory only, of writers that were lost.
void sync_pieces(const std::filesystem::path& journal, const JournalContents& contents, const System& system) {
    for (const JournalContents::Piece& piece : contents.pieces)
        sync_data(open_file(piece_path(journal, piece.number), O_RDONLY, system));
}

/// Removes those whose writers were stopped inside the header: when the campaign has grown, nobody knows any more what
/// a power cut has torn of it.
void remove_unbegun(const std::filesystem::path& journal, JournalContents& contents, const System& system) {
    const auto is_unbegun = [](const JournalContents::Piece& piece) { return piece.good_bytes == 0; };
    if (std::ranges::none_of(contents.pieces, is_unbegun)) return;
    for (const JournalContents::Piece& piece : contents.pieces)
        if (is_unbegun(piece)) remove_file(piece_path(journal, piece.number), system);
    std::erase_if(contents.pieces, is_unbegun);
    sync_folder_of(journal, system);
}

/// A file system without locks lets both in (docs/campaign_file.md). Who has the lock may have removed the file since
/// it was opened here.
void lock_for_writing(const OpenFile& file, const std::filesystem::path& path) {
    if (file.system().lock(file.get()) == -EAGAIN || !is_named(file, path)) refuse_second_writer(path);
}

/// A journal in place of the one at the path. That one is not cut: a sync that fails may lose the cut, and after a
/// power cut its old records would stand behind new ones.
OpenFile make_anew(const std::filesystem::path& path, const System& system) {
    remove_file(path, system);
    OpenFile file = open_file(path, O_RDWR | O_CREAT | O_EXCL | O_APPEND, system);
    lock_for_writing(file, path);
    return file;
}

std::string load_nothing(const std::string& path) {
    throw InputError(
        fmt::format("the configuration in a journal refers to the file {}, which should be part of it", path));
}

Campaign read_text(const std::string& campaign_text, const std::filesystem::path& path) {
    return read_campaign({campaign_text, path.string(), {}}, load_nothing);
}

/// All members, whose files it opens now, but for the journal itself where that is `open`.
StoredMembers members_of(const JournalContents& contents, const std::filesystem::path& journal, const System& system,
                         const OpenFile* open) {
    auto files = std::make_shared<std::map<int, OpenFile>>();  // by number of the piece
    if (open == nullptr) files->emplace(0, open_file(journal, O_RDONLY, system));
    for (const JournalContents::Piece& piece : contents.pieces)
        files->emplace(piece.number, open_file(piece_path(journal, piece.number), O_RDONLY, system));
    return {contents.members, [&contents, files, open](std::size_t k) {
                const JournalContents::Place place = contents.places.at(k);
                const bool is_open = place.piece == 0 && open != nullptr;
                return journal_format::read_member(is_open ? *open : files->at(place.piece), place);
            }};
}

/// The payload of a record: these values, one after the other.
template <class... Values>
Bytes payload(const Values&... values) {
    ByteWriter out;
    (put(out, values), ...);
    return out.take();
}

}  // namespace

std::filesystem::path journal_path(const std::filesystem::path& campaign_file) {
    return target_of(campaign_file).replace_extension(".journal");
}

std::filesystem::path piece_path(const std::filesystem::path& journal, int number) {
    return number == 0 ? journal : std::filesystem::path(fmt::format("{}.{}", journal.string(), number));
}

std::vector<int> pieces_of(const std::filesystem::path& journal, const System& system) {
    const std::string begin = journal.filename().string() + ".";
    std::vector<int> numbers;
    for (const std::string& name : system.names_in(folder_of(journal))) {
        if (!name.starts_with(begin)) continue;
        int number = 0;
        const char* const end = name.data() + name.size();
        const auto read = std::from_chars(name.data() + begin.size(), end, number);
        if (read.ec == std::errc() && read.ptr == end && number > 0 && name == begin + std::to_string(number))
            numbers.push_back(number);
    }
    std::ranges::sort(numbers);
    return numbers;
}

void remove_journal(const std::filesystem::path& path, const System& system) {
    const std::vector<int> pieces = pieces_of(path, system);
    for (const int number : pieces) remove_file(piece_path(path, number), system);
    if (!pieces.empty()) sync_folder_of(path, system);  // or a power cut leaves them without it
    remove_file(path, system);                          // the last: its lock keeps others out meanwhile
}

Journal::Journal(std::filesystem::path path, OpenFile file, JournalContents contents)
    : path_(std::move(path)), file_(std::move(file)), contents_(std::move(contents)) {}

Journal::~Journal() {
    try {
        hand_over();
    } catch (const std::exception&) {
        // Callers that need the error call sync(), which reports it.
    }
}

Journal open_journal(const std::filesystem::path& path, const std::string& campaign_text, Existing existing,
                     const System& system, const std::string& before) {
    OpenFile file = open_file(path, O_RDWR | O_CREAT | O_APPEND, system);
    lock_for_writing(file, path);
    settle_pieces(path, existing, system);
    std::optional<JournalContents> contents;
    if (existing == Existing::replace)
        file = make_anew(target_of(path), system);
    else
        contents = journal_format::read(file, std::array{campaign_text, before});
    if (contents && existing == Existing::refuse)
        throw InputError(fmt::format(
            "{} exists already. Continue it with --resume, start afresh with --overwrite, or choose another "
            "output file with -o.",
            path.string()));
    truncate_file(file, contents ? contents->good_bytes : 0);
    if (!contents) {
        contents.emplace();
        contents->campaign_text = before.empty() ? campaign_text : before;
        const Bytes header = journal_format::header(contents->campaign_text);
        write_all(file, header);
        contents->first_record = contents->good_bytes = header.size();
    }
    // The run that made it may have been killed before it did; no record is to stand behind a torn header.
    sync_data(file);
    sync_folder_of(path, system);
    journal_format::read_pieces(path, *contents, system);  // perhaps of a journal that was lost
    remove_unbegun(path, *contents, system);
    sync_pieces(path, *contents, system);
    contents->attempts.close_session();  // no other run is active, because we hold the lock
    return {path, std::move(file), *std::move(contents)};
}

Journal open_journal(const std::filesystem::path& path, const Campaign& campaign, Existing existing,
                     const System& system, const std::string& before) {
    const std::string here = write_campaign(campaign);
    Journal journal = open_journal(path, here, existing, system, before);
    if (journal.contents().campaign_text == here) return journal;
    const Campaign there = read_text(journal.contents().campaign_text, path);
    expect_to_continue(there, campaign, path);
    // What readers of the journal alone ask for, besides the members.
    if (fingerprint(there) != fingerprint(campaign) || there.stop != campaign.stop || there.name != campaign.name ||
        there.run.base_case != campaign.run.base_case)
        journal.extend(there, campaign);
    return journal;
}

void expect_to_continue(const Campaign& there, const Campaign& here, const std::filesystem::path& path) {
    if (fingerprint(there) == fingerprint(here) || is_part_of(there, here)) return;
    if (is_part_of(here, there))
        throw InputError(fmt::format(
            "{} has more members than this configuration: {}. A campaign may grow but not shrink: ask for at least as "
            "many, or choose another output file with -o.",
            path.string(), fmt::join(differences(there, here), "; ")));
    throw InputError(
        fmt::format("{} belongs to another campaign: {}. Give the configuration it was started with, choose "
                    "another output file with -o, or start afresh with --overwrite.",
                    path.string(), fmt::join(differences(there, here), "; ")));
}

void Journal::extend(const Campaign& there, const Campaign& here) {
    contents_.campaign_text = write_campaign(here);
    write_record(RecordType::campaign, payload(contents_.campaign_text));
    sync();
    extension_ = differences(there, here);
}

void Journal::write_record(journal_format::RecordType type, std::span<const std::byte> payload) {
    const Bytes bytes = journal_format::record(type, payload);
    appended_.insert(appended_.end(), bytes.begin(), bytes.end());
    contents_.good_bytes += bytes.size();
    if (appended_.size() >= most_appended) hand_over();
}

void Journal::hand_over() {
    if (appended_.empty()) return;
    const Bytes bytes = std::exchange(appended_, {});
    try {
        write_all(file_, bytes);
    } catch (const RunError&) {
        // Half a record would hide every later one from the reader.
        contents_.good_bytes -= bytes.size();
        truncate_file(file_, contents_.good_bytes);
        throw;
    }
}

void Journal::append(const MemberRecord& record) {
    const std::uint64_t offset = contents_.good_bytes;
    write_record(RecordType::member, encode(record));
    contents_.add(record, {offset, contents_.good_bytes - offset});
}

StoredMembers Journal::members() const {
    return members_of(contents_, path_, file_.system(), &file_);
}

void Journal::append(const CalibrationRecord& record) {
    if (find_calibration(contents_.calibrations, record.key) != nullptr) return;
    write_record(RecordType::calibration, encode(record));
    contents_.calibrations.push_back(record);
}

void Journal::append(std::span<const Session> earlier) {
    for (const Session& session : earlier) {
        const std::uint64_t at = contents_.good_bytes;
        write_record(RecordType::session_begin, encode(session));
        contents_.begin(session, at);
        write_record(RecordType::session_counts, payload(session.computed, session.set_aside));
    }
}

void Journal::done_in_piece(const MemberIdentity& member) {
    write_record(RecordType::done_in_piece, payload(member.first, member.second));
    contents_.add_done(member);
}

void Journal::take_in_pieces() {
    journal_format::read_pieces(path_, contents_, file_.system());
    sync_pieces(path_, contents_, file_.system());
}

void Journal::take_in(const MemberIdentity& member, const MemberNote& note, const JournalContents::Place& place) {
    auto known = std::ranges::find(contents_.pieces, place.piece, &JournalContents::Piece::number);
    if (known == contents_.pieces.end()) known = contents_.pieces.insert(known, {place.piece, 0});
    known->good_bytes = std::max(known->good_bytes, place.offset + place.size);
    contents_.members.add(member.first, note);
    contents_.places.push_back(place);
}

void Journal::started(const MemberIdentity& member, int attempt) {
    write_record(RecordType::attempt_started, payload(member.first, member.second, attempt));
    contents_.attempts.started(member);
}

void Journal::sync() {
    hand_over();
    sync_data(file_);
    // A deleted file accepts writes, but they are lost.
    if (!is_named(file_, path_))
        throw RunError(
            fmt::format("{} is gone: its folder was deleted, moved or replaced during the run.", path_.string()));
}

void Journal::begin_session(const Session& session) {
    const std::uint64_t at = contents_.good_bytes;
    write_record(RecordType::session_begin, encode(session));
    contents_.begin(session, at);
    sync();
    Session& begun = contents_.sessions.back();
    const double ahead = file_.system().seconds_since_1970() - modified_at(file_);
    if (std::abs(ahead) >= least_told_difference) begun.clock_ahead = ahead;
    if (begun.parts == 1 && begun.clock_ahead == 0) return;
    write_record(RecordType::session_surroundings, encode_surroundings(begun, ::getpid()));
    sync();
}

void Journal::end_session(const std::string& outcome) {
    const std::string now = utc_now(file_.system());
    contents_.end(now, outcome);
    write_record(RecordType::session_end, payload(now, outcome));
    sync();
}

JournalContents read_journal(const std::filesystem::path& path, const System& system) {
    std::optional<JournalContents> contents = journal_format::read(open_file(path, O_RDONLY, system));
    if (!contents) throw InputError(fmt::format("{} is still empty.", path.string()));
    journal_format::read_pieces(path, *contents, system);
    return *std::move(contents);
}

StoredMembers stored_members(const JournalContents& contents, const std::filesystem::path& path, const System& system) {
    return members_of(contents, path, system, nullptr);
}

Campaign read_stored_campaign(const JournalContents& contents, const std::filesystem::path& path) {
    return read_text(contents.campaign_text, path);
}

bool is_being_written(const std::filesystem::path& path, const System& system) {
    const OpenFile file = open_file(path, O_RDONLY, system);
    return system.is_locked(file.get());
}

}  // namespace floes
