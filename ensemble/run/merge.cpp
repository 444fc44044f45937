#include "run/merge.hpp"

#include <fcntl.h>

#include <algorithm>
#include <optional>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/identity.hpp"
#include "campaign_file/publish.hpp"
#include "core/error.hpp"
#include "store/journal.hpp"

namespace floes {
namespace {

namespace fs = std::filesystem;

void check_output(std::span<const fs::path> parts, const fs::path& output, bool overwrite) {
    const fs::path journal = journal_path(output);
    for (const fs::path& part : parts) {
        if (fs::weakly_canonical(journal_path(part)) == fs::weakly_canonical(journal))
            throw InputError(fmt::format("{} cannot be merged into itself; -o names another file.", part.string()));
    }
    if (!overwrite && (fs::exists(output) || fs::exists(journal)))
        throw InputError(fmt::format("{} exists already: --overwrite replaces it, -o names another file.",
                                     fs::exists(output) ? output.string() : journal.string()));
    if (fs::exists(journal) && is_being_written(journal))
        throw InputError(fmt::format("{} is being written by a run.", journal.string()));
}

/// Throws unless the part belongs to the campaign of the first part.
void check_part(const Campaign& first, const JournalContents& contents, const fs::path& path) {
    const Campaign campaign = read_stored_campaign(contents, path);
    if (fingerprint(campaign) == fingerprint(first)) return;
    throw InputError(fmt::format("{} belongs to a different campaign than the first part: {}.", path.string(),
                                 fmt::join(differences(first, campaign), "; ")));
}

/// Offset of the first record of a journal.
std::uint64_t begin_of_records(const Descriptor& file, const fs::path& path) {
    Bytes fixed(journal_format::fixed_header_bytes);
    read_at(file, path, 0, fixed);
    ByteReader in(fixed);
    in.u64();  // magic
    in.u32();  // schema
    return journal_format::fixed_header_bytes + in.u64() + journal_format::crc_bytes;
}

/// Copies the first `good_bytes` of `part` without the header, unchanged, because the order of sessions and attempts
/// matters.
void copy_records(const Descriptor& out, const fs::path& out_path, const fs::path& part, std::uint64_t good_bytes) {
    const Descriptor file = open_file(part, O_RDONLY);
    constexpr std::uint64_t piece = 1 << 20;
    for (std::uint64_t at = begin_of_records(file, part); at < good_bytes;) {
        Bytes bytes(std::min(piece, good_bytes - at));
        if (!read_at(file, part, at, bytes))
            throw RunError(fmt::format("{} became shorter while it was read", part.string()));
        write_all(out, out_path, bytes);
        at += bytes.size();
    }
}

}  // namespace

void merge_campaigns(std::span<const fs::path> parts, const fs::path& output, bool overwrite, const OnPart& on_part) {
    check_output(parts, output, overwrite);
    std::optional<Campaign> campaign;  // of the first part
    const fs::path journal = journal_path(output);
    const fs::path aside = journal.string() + ".tmp";
    try {
        Descriptor out;
        for (const fs::path& part : parts) {
            const fs::path path = journal_path(part);
            const JournalContents contents = read_journal(path);
            on_part(path, contents);
            if (campaign) {
                check_part(*campaign, contents, path);
            } else {
                campaign = read_stored_campaign(contents, path);
                out = open_file(aside, O_WRONLY | O_CREAT | O_TRUNC);
                write_all(out, aside, journal_format::header(contents.campaign_text));
            }
            copy_records(out, aside, path, contents.good_bytes);
        }
        sync_data(out, aside);
    } catch (...) {
        std::error_code ignored;
        fs::remove(aside, ignored);
        throw;
    }
    rename_into_place(aside, journal);
    const Journal merged = open_journal(journal, *campaign, Existing::resume);
    publish(output, *campaign, merged.members(), merged.sessions(), merged.calibrations());
}

}  // namespace floes
