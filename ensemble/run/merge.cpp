#include "run/merge.hpp"

#include <fcntl.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "campaign/write.hpp"
#include "campaign_file/publish.hpp"
#include "core/error.hpp"
#include "store/journal.hpp"

namespace floes {
namespace {

namespace fs = std::filesystem;

void remove_pieces(const fs::path& journal) {
    for (const int number : pieces_of(journal)) fs::remove(piece_path(journal, number));
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
    if (fs::exists(journal)) return true;
    if (fs::exists(output) || written.size() > 1)
        throw InputError(
            fmt::format("{} exists already but not its journal {}, so nothing can be added to it: --overwrite replaces "
                        "it, -o names another file.",
                        fs::exists(output) ? output.string() : written.back().string(), journal.string()));
    return false;
}

/// Copies the block unchanged, because the order of sessions and attempts matters.
void copy_block(const Descriptor& out, const fs::path& out_path, const fs::path& from, const Parts::Block& block) {
    const Descriptor file = open_file(from, O_RDONLY);
    constexpr std::uint64_t stretch = 1 << 20;
    for (std::uint64_t at = block.from; at < block.to;) {
        Bytes bytes(std::min(stretch, block.to - at));
        if (!read_at(file, from, at, bytes))
            throw RunError(fmt::format("{} became shorter while it was read", from.string()));
        write_all(out, out_path, bytes);
        at += bytes.size();
    }
}

void write_journal(const Parts& parts, const fs::path& aside) {
    const Descriptor out = open_file(aside, O_WRONLY | O_CREAT | O_TRUNC);
    write_all(out, aside, journal_format::header(write_campaign(parts.whole_campaign())));
    for (const Parts::Block& block : parts.blocks())
        copy_block(out, aside, piece_path(parts.all()[block.part].journal, block.piece), block);
    sync_data(out, aside);
}

}  // namespace

Parts merge_campaigns(std::span<const fs::path> parts, const fs::path& output, bool overwrite) {
    const bool adds = check_output(parts, output, overwrite);
    std::vector<fs::path> files(parts.begin(), parts.end());
    if (adds) files.insert(files.begin(), output);
    Parts read(files, adds);
    const fs::path journal = journal_path(output);
    const fs::path aside = journal.string() + ".tmp";
    try {
        write_journal(read, aside);
    } catch (...) {
        std::error_code ignored;
        fs::remove(aside, ignored);
        throw;
    }
    if (!adds) remove_pieces(journal);
    rename_into_place(aside, journal);
    remove_pieces(journal);  // the journal has their members now
    const Journal merged = open_journal(journal, read.whole_campaign(), Existing::resume);
    publish(output, read.campaign(), merged.members(), merged.sessions(), merged.calibrations());
    return read;
}

}  // namespace floes
