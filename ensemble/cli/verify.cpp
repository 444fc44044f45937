// floes verify and merge: whether campaign files, records and journals are as they were written, and one file of
// several.

#include "cli/verify.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "campaign_file/kinds.hpp"
#include "campaign_file/pieces.hpp"
#include "campaign_file/read.hpp"
#include "cli/commands.hpp"
#include "findings/cases.hpp"
#include "hdf5/read.hpp"
#include "replay/recording.hpp"
#include "run/link.hpp"
#include "run/parts.hpp"
#include "solver/lane_width.hpp"
#include "store/session.hpp"
#include "tables/section.hpp"

namespace floes {

namespace {

constexpr std::size_t most_told = 20;  // members in a sentence

std::string members_text(const std::set<std::size_t>& members) {
    if (members.size() > most_told) return counted(std::ssize(members), "member");
    return fmt::format("{} {}", members.size() == 1 ? "member" : "members", fmt::join(members, ", "));
}

/// Which results of a damaged campaign file are still good.
std::string whole_members(const hdf5::FileCheck& check) {
    std::set<std::size_t> lost;
    bool only_provenance = check.fault.empty();
    bool only_rows = check.fault.empty();
    for (const hdf5::DamagedDataset& one : check.damaged) {
        if (one.path.starts_with("/provenance/")) continue;
        only_provenance = false;
        only_rows = only_rows && one.by_rows && !one.rows.empty();
        lost.insert(one.rows.begin(), one.rows.end());
    }
    if (only_provenance) return "The results of all members are whole.";
    if (only_rows) return fmt::format("What is damaged is of {}; all other members are whole.", members_text(lost));
    return "It does not show which members are whole, so no number of it should be used.";
}

/// The bytes behind the last whole record of a journal.
void judge_tail(const std::filesystem::path& path, const JournalContents& contents, FileVerdict& verdict) {
    if (contents.torn_bytes == 0) return;
    if (is_being_written(path)) {
        verdict.notes.push_back("A run is writing it.");
        return;
    }
    if (journal_format::tail_is_torn(path, contents)) {
        verdict.notes.push_back(
            fmt::format("Its last {} bytes are a record that was begun and never finished, as a killed run leaves it; "
                        "--resume cuts them off.",
                        contents.torn_bytes));
        return;
    }
    verdict.faults.push_back(fmt::format("Its last {} bytes are damaged.", contents.torn_bytes));
}

FileVerdict verify_journal(const std::filesystem::path& path) {
    FileVerdict verdict{.file = path.string(), .kind = "journal"};
    try {
        return judge_journal(path, read_journal(path));
    } catch (const journal_format::NewerJournal& error) {
        verdict.faults.push_back(error.what());
        verdict.state = FileState::newer;
    } catch (const std::runtime_error& error) {
        verdict.faults.push_back(error.what());
        verdict.remedy = "Restore it from a copy.";
        verdict.state = FileState::damaged;
    }
    return verdict;
}

/// How to make the campaign file anew.
std::string campaign_remedy(const std::filesystem::path& path) {
    const std::filesystem::path journal = journal_path(path);
    const std::string otherwise = "restore it from a copy, or compute it again.";
    if (!std::filesystem::exists(journal)) return fmt::format("There is no journal beside it: {}", otherwise);
    const FileVerdict beside = verify_journal(journal);
    if (beside.counts.empty()) return fmt::format("Its journal is damaged as well: {}", otherwise);
    return fmt::format(
        "floes run CONFIG.toml -o {} --resume makes it anew from its journal{}.", shell_word(path.string()),
        beside.state == FileState::good ? ", which is whole" : ", and computes again what is damaged there");
}

/// Those that the file refers to; none where it is no campaign file, or so damaged that the check of it says more.
std::vector<FilePiece> pieces_in(const std::filesystem::path& path) {
    const hdf5::QuietErrors quiet;
    try {
        const hdf5::Handle file = hdf5::open_for_reading(path);
        return hdf5::is_of_kind(file.id(), campaign_kind) ? pieces_of(file.id()) : std::vector<FilePiece>();
    } catch (const RunError&) {
        return {};
    }
}

/// Opens them; of what cannot be opened it says so.
std::vector<hdf5::Handle> opened_pieces(const std::filesystem::path& path, std::span<const FilePiece> pieces,
                                        FileVerdict& verdict) {
    try {
        return open_pieces(path, pieces);
    } catch (const std::runtime_error& error) {
        verdict.state = FileState::damaged;
        verdict.kind = "campaign file";
        verdict.faults.emplace_back(error.what());
        verdict.remedy = campaign_remedy(path);
        return {};
    }
}

void verify_pieces(const std::filesystem::path& path, std::span<const FilePiece> pieces, FileVerdict& verdict) {
    constexpr std::array filetypes{piece_kind.filetype};
    for (const FilePiece& piece : pieces) {
        const hdf5::FileCheck check = hdf5::check_file(path_of_piece(path, piece), filetypes);
        if (check.good()) continue;
        verdict.state = FileState::damaged;
        verdict.remedy = campaign_remedy(path);
        for (const std::string& fault : {check.fault, check.between})
            if (!fault.empty()) verdict.faults.push_back(fmt::format("Its piece {}: {}.", piece.file, fault));
        for (const hdf5::DamagedDataset& one : check.damaged)
            verdict.faults.push_back(fmt::format("Its piece {}: {}.", piece.file, one.fault));
    }
}

void verify_hdf5(const std::filesystem::path& path, FileVerdict& verdict) {
    constexpr std::array filetypes{campaign_kind.filetype, recording_kind.filetype, piece_kind.filetype};
    const std::vector<FilePiece> pieces = pieces_in(path);
    const std::vector<hdf5::Handle> opened = opened_pieces(path, pieces, verdict);
    if (verdict.state == FileState::damaged) return;
    const hdf5::FileCheck check = hdf5::check_file(path, filetypes);
    const bool is_recording = check.filetype == recording_kind.filetype;
    if (check.filetype == campaign_kind.filetype || is_recording)
        verdict.kind = is_recording ? "recording" : "campaign file";
    if (check.filetype == piece_kind.filetype) verdict.kind = "piece of a campaign file";
    if (verdict.kind.empty() && check.fault.empty())
        throw InputError("It is an HDF5 file, but neither a campaign nor a recording of floes.");
    verdict.counts = counted(static_cast<std::int64_t>(check.datasets), "dataset");
    if (!pieces.empty()) verdict.counts += fmt::format(" in {}", counted(std::ssize(pieces), "piece"));
    verdict.digest = check.contents;
    if (!check.has_digests && check.fault.empty())
        verdict.notes.push_back(fmt::format(
            "Layout {} carries no digests: what HDF5 itself checks is whole, but a changed number would not show.",
            check.version));
    if (const std::vector<std::string> added = check.added.words(); !added.empty())
        verdict.notes.push_back(fmt::format("Added by other programs, and not checked: {}.", name_list(added)));
    verify_pieces(path, pieces, verdict);
    if (check.good()) return;
    verdict.state = FileState::damaged;
    if (!check.fault.empty()) verdict.faults.push_back(fmt::format("The file: {}.", check.fault));
    if (!check.between.empty())
        verdict.faults.push_back(fmt::format("Outside all that is stored in it, {}.", check.between));
    for (const hdf5::DamagedDataset& one : check.damaged)
        verdict.faults.push_back(fmt::format(
            "{}{}.", one.fault, one.rows.empty() ? "" : fmt::format("; rows {}", fmt::join(one.rows, ", "))));
    if (!is_recording) verdict.whole = whole_members(check);
    verdict.remedy = is_recording ? "Remove it; floes replay makes it anew." : campaign_remedy(path);
}

}  // namespace

FileVerdict judge_journal(const std::filesystem::path& path, const JournalContents& contents) {
    FileVerdict verdict{.file = path.string(), .kind = "journal"};
    verdict.counts = fmt::format("{}, {}", counted(std::ssize(contents.members), "member"),
                                 counted(std::ssize(contents.sessions), "session"));
    if (contents.damaged_bytes > 0)
        verdict.faults.push_back(fmt::format("{} bytes inside it belong to no whole record.", contents.damaged_bytes));
    judge_tail(path, contents, verdict);
    if (verdict.faults.empty()) return verdict;
    verdict.state = FileState::damaged;
    verdict.whole = fmt::format("{} in it are whole.", counted(std::ssize(contents.members), "member"));
    verdict.remedy = "floes run with --resume keeps these, and computes the members in the damaged parts again.";
    return verdict;
}

FileVerdict verify_file(const std::filesystem::path& path) {
    if (first_bytes(path, journal_format::magic.size()) == journal_format::magic) return verify_journal(path);
    FileVerdict verdict{.file = path.string()};
    const GivenFile kind = given_file(path);
    try {
        if (kind == GivenFile::unreadable)
            throw InputError("It may not be read by you; its owner has to permit it (chmod).");
        if (kind == GivenFile::text || kind == GivenFile::other)
            throw InputError("It is neither a campaign file, nor a recording, nor a journal of floes.");
        verify_hdf5(path, verdict);
    } catch (const hdf5::OpenElsewhere& error) {
        verdict.state = FileState::open_elsewhere;
        verdict.faults.emplace_back(error.what());
    } catch (const InputError& error) {
        verdict.state = FileState::not_of_floes;
        verdict.faults.push_back(error.what());
    }
    return verdict;
}

namespace {

constexpr const char* state_words[]{"good", "damaged", "not of floes", "of a newer floes", "open elsewhere"};

const char* state_word(const FileVerdict& verdict) {
    return state_words[static_cast<std::size_t>(verdict.state)];
}

std::string text_of(const FileVerdict& verdict) {
    std::string head;
    for (const std::string& part : {verdict.kind, verdict.counts})
        if (!part.empty()) head += ", " + part;
    if (!verdict.digest.empty()) head += ", digest " + verdict.digest;
    std::string text = fmt::format("{}: {}{}\n", verdict.file, state_word(verdict), head);
    for (const std::vector<std::string>* sentences : {&verdict.faults, &verdict.notes})
        for (const std::string& one : *sentences) text += fmt::format("  {}\n", one);
    for (const std::string& one : {verdict.whole, verdict.remedy})
        if (!one.empty()) text += fmt::format("  {}\n", one);
    return text;
}

std::string json_of(const std::vector<FileVerdict>& verdicts) {
    std::vector<Results> all{list("files", "file kind state checked digest whole remedy", verdicts,
                                  [](const FileVerdict& one) -> std::vector<Datum> {
                                      return {one.file,   one.kind,  state_word(one), one.counts,
                                              one.digest, one.whole, one.remedy};
                                  })};
    const auto sentence = [](const std::string& one) -> std::vector<Datum> { return {one}; };
    for (std::size_t k = 0; k < verdicts.size(); ++k) {
        all.push_back(list(fmt::format("files/{}/faults", k), ".", verdicts[k].faults, sentence));
        all.push_back(list(fmt::format("files/{}/notes", k), ".", verdicts[k].notes, sentence));
    }
    return json(std::vector{Section{.results = std::move(all)}});
}

int verify(const std::vector<std::string>& files, const std::string& format) {
    std::vector<FileVerdict> verdicts;
    for (const std::string& file : files) {
        verdicts.push_back(verify_file(file));
        if (format == "table") std::fputs(text_of(verdicts.back()).c_str(), stdout);
    }
    if (format == "json") std::fputs(json_of(verdicts).c_str(), stdout);
    const auto any = [&](FileState state) { return std::ranges::count(verdicts, state, &FileVerdict::state) > 0; };
    if (any(FileState::damaged)) return 1;
    return any(FileState::not_of_floes) || any(FileState::newer) || any(FileState::open_elsewhere) ? 2 : 0;
}

}  // namespace

void add_verify(CommandLine& line) {
    struct Options {
        std::vector<std::string> files;
        std::string format = "table";
    };
    auto options = std::make_shared<Options>();
    Verb verb =
        line.verb("verify", "Check that campaign files, records and journals are as they were written, byte by byte");
    verb.option("files", options->files, "Campaign files (.h5), records of floes replay, journals (.journal)")
        .required();
    verb.option("--format", options->format, "table or json").one_of({"table", "json"}).shows_default();
    verb.footer(
        "What floes wrote is checked; what other programs have added to it is named.\n"
        "Exit status: 0 all good, 1 one is damaged, 2 none is damaged but one is no file of floes, of a newer one, or\n"
        "open for writing elsewhere.");
    verb.runs([options] { return verify(options->files, options->format); });
}

// floes merge: one campaign file from those of separate runs with --part.

namespace {

struct MergeOptions {
    std::vector<std::string> parts;
    std::string output;
    bool overwrite = false;
    bool keep_journal = false;
};

/// A merge leaves out damaged records; their members count as missing.
void tell_damage(const Parts& parts) {
    for (const Parts::Part& part : parts.all()) {
        const FileVerdict verdict = judge_journal(part.journal, part.contents);
        if (verdict.state != FileState::damaged) continue;
        for (const std::string& fault : verdict.faults) note("{}: {}", verdict.file, fault);
    }
}

int merge(const MergeOptions& options) {
    expect_no_other_file(options.output);
    const std::vector<std::filesystem::path> files(options.parts.begin(), options.parts.end());
    const Parts parts = merge_campaigns(files, options.output, options.overwrite);
    tell_damage(parts);
    tell_parts(parts);
    const CampaignTable table = read_campaign_file(CampaignFile(options.output));
    const auto done = std::ranges::count(table.members, RowStatus::done, &MemberRow::status);
    const auto missing = std::ranges::count(table.members, RowStatus::missing, &MemberRow::status);
    const auto failed = std::ssize(table.members) - done - missing;
    note("{} of {} done, {} failed, {} missing from all parts, into {}", done,
         counted(std::ssize(table.members), "member"), failed, missing, options.output);
    if (missing > 0)
        note(
            "the same command adds what the parts compute from now on; floes run CONFIG.toml -o {} --resume computes "
            "the missing members",
            shell_word(options.output));
    if (!options.keep_journal && done == member_count(parts.whole_campaign()))
        remove_journal(journal_path(options.output));
    print({summary_section(summarise(table))}, "table");
    return failed + missing > 0 ? 1 : 0;
}

}  // namespace

void add_merge(CommandLine& line) {
    auto options = std::make_shared<MergeOptions>();
    Verb verb = line.verb("merge", "Merge the parts computed by floes run --part into one campaign");
    verb.option("parts", options->parts, "Campaign files of the parts; their journals are read from the same folders")
        .required();
    verb.option("-o,--output", options->output, "The merged campaign file; one that exists is added to")
        .required()
        .file_ending({".h5", ".hdf5", ".nc"});
    verb.flag("--overwrite", options->overwrite, "Replace what the merged campaign file has, instead of adding to it");
    verb.flag("--keep-journal", options->keep_journal, keep_journal_words);
    verb.runs([options] { return merge(*options); });
}

// floes --version: what this program is, and what it was built with.

std::string version_text() {
    std::string text = fmt::format("floes {}\n", floes_version());
    std::vector<Software> parts = built_with();
    parts.push_back({"mpi", library_version()});
    for (const Software& part : parts) {
        if (part.name != "floes") text += fmt::format("{}: {}\n", part.name, part.version);
    }
    return text + fmt::format("lane_widths: {}", fmt::join(lane_widths(), ", "));  // whoever prints it ends the line
}

}  // namespace floes
