#pragma once
// The binary layout of a journal. All numbers are little endian.
//
//     header   magic (8)  schema (u32)  text length (u64)  CRC32C of these 20 bytes (u32)
//              text  CRC32C of the text (u32)
//     record   payload length (u64)  type (u32)  payload  CRC32C of all before in the record (u32)

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "core/bytes.hpp"
#include "core/error.hpp"
#include "journal/journal_contents.hpp"
#include "records/file_calls.hpp"

namespace floes::journal_format {

inline constexpr std::string_view magic = "floesjnl";
inline constexpr std::uint32_t schema = 4;  ///< 3: of floes 1.0; 4: arrays have their keys
inline constexpr std::uint32_t oldest_schema = 3;
inline constexpr std::uint64_t fixed_header_bytes = 24;
inline constexpr std::uint64_t record_head_bytes = 12;
inline constexpr std::uint64_t crc_bytes = 4;

/// Types are only added. A reader skips unknown ones.
enum class RecordType : std::uint32_t {
    session_begin = 2,
    session_end = 3,
    calibration = 4,
    attempt_started = 5,
    campaign = 6,
    member_1_0 = 7,  ///< of schema 3
    member = 8
};

/// A whole journal, of a schema that only a newer floes reads.
class NewerJournal : public InputError {
  public:
    using InputError::InputError;
};

std::uint32_t crc32c(std::span<const std::byte> bytes);
Bytes header(std::string_view text);
Bytes record(RecordType type, std::span<const std::byte> payload);

/// The member whose record is at `place`. Throws RunError if it is damaged.
MemberRecord read_member(const Descriptor& file, const std::filesystem::path& path, JournalContents::Place place);

/// The contents of a file open for reading. `begun` is false if the file ends inside the header: its writer was stopped
/// before it kept anything. Throws InputError if the file is not a readable journal.
struct Reading {
    bool begun = false;
    JournalContents contents;
};
Reading read(const Descriptor& file, const std::filesystem::path& path);

/// Whether what follows the last whole record, read of the file at `path`, is the begin of a record only. A whole one
/// that is damaged is not.
bool tail_is_torn(const std::filesystem::path& path, const JournalContents& contents);

}  // namespace floes::journal_format
