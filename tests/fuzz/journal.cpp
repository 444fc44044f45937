// A journal: read, then continued by a member. Changed bytes rarely have the right checksum, so the last byte of the
// input says whether the checksums are put right first.

#include <fcntl.h>
#include <sys/mman.h>

#include <cstring>

#include "fuzz/fuzz.hpp"
#include "store/journal.hpp"

namespace {

using floes::Bytes;
namespace format = floes::journal_format;

/// The file at path(), in memory.
class File {
  public:
    File() : file_(floes::this_system(), ::memfd_create("journal", MFD_CLOEXEC), "a journal in memory") {}
    std::string path() const { return "/proc/self/fd/" + std::to_string(file_.get()); }
    const floes::OpenFile& opened() const { return file_; }
    void fill(std::span<const std::byte> bytes) {
        floes::truncate_file(file_, 0);
        ::lseek(file_.get(), 0, SEEK_SET);
        floes::write_all(file_, bytes);
    }

  private:
    floes::OpenFile file_;
};

void put_crc(std::span<std::byte> with_crc) {
    floes::ByteWriter crc;
    crc.u32(format::crc32c(with_crc.first(with_crc.size() - format::crc_bytes)));
    std::memcpy(with_crc.data() + with_crc.size() - format::crc_bytes, crc.bytes().data(), format::crc_bytes);
}

/// Where a record or text of `length` bytes ends, with its checksum put right; the end of `rest` if it is too short.
std::span<std::byte> repaired(std::span<std::byte> rest, std::uint64_t head, std::uint64_t length) {
    if (rest.size() < head + format::crc_bytes || length > rest.size() - head - format::crc_bytes) return {};
    put_crc(rest.first(head + length + format::crc_bytes));
    return rest.subspan(head + length + format::crc_bytes);
}

void repair(Bytes& bytes) {
    if (bytes.size() < format::fixed_header_bytes) return;
    put_crc(std::span(bytes).first(format::fixed_header_bytes));
    floes::ByteReader head(std::span<const std::byte>(bytes).subspan(format::magic.size() + 4));
    std::span<std::byte> rest = std::span(bytes).subspan(format::fixed_header_bytes);
    rest = repaired(rest, 0, head.u64());
    while (rest.size() >= format::record_head_bytes)
        rest = repaired(rest, format::record_head_bytes, floes::ByteReader(rest).u64());
}

floes::MemberRecord one_more() {
    floes::MemberRecord record;
    record.case_key = "one more";
    record.result.history.surge = {1.0, 2.0};
    return record;
}

void require_whole(const File& file, const floes::JournalContents& contents, std::uint64_t size) {
    using floes::fuzz::require;
    require(contents.good_bytes + contents.torn_bytes == size, "bytes of a journal are lost");
    require(contents.damaged_bytes <= contents.good_bytes, "more bytes are damaged than there are");
    require(contents.places.size() == contents.members.size(), "a member has no place");
    for (std::size_t k = 0; k < contents.members.size(); ++k) {
        const auto alone = format::read_member(file.opened(), contents.places[k]);
        require(alone.arrangement == contents.members[k].arrangement && alone.attempt == contents.members[k].attempt,
                "a member alone is another one");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static File file;
    using floes::fuzz::require;
    if (size == 0) return 0;
    const auto given = floes::fuzz::as_bytes(data, size - 1);
    Bytes bytes(given.begin(), given.end());
    if (data[size - 1] % 2 == 1) repair(bytes);
    file.fill(bytes);
    const auto reading = floes::fuzz::taken([&] { return format::read(file.opened()); });
    if (!reading || !*reading) return 0;
    const floes::JournalContents& contents = **reading;
    require_whole(file, contents, bytes.size());
    {
        floes::Journal journal = floes::open_journal(file.path(), "", floes::Existing::resume);
        journal.append(one_more());
        journal.sync();
    }
    const floes::JournalContents more = floes::read_journal(file.path());
    require(more.torn_bytes == 0, "a continued journal has a torn tail");
    require(more.members.size() == contents.members.size() + 1, "a continued journal lost a member");
    const floes::MemberRecord last = floes::stored_members(more, file.path()).read(more.members.size() - 1);
    require(floes::encode(last) == floes::encode(one_more()), "the member added is another one");
    return 0;
}
