#include "campaign_file/pieces.hpp"

#include <algorithm>
#include <regex>
#include <utility>

#include <fmt/format.h>

#include "campaign_file/content.hpp"
#include "campaign_file/kinds.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "hdf5/columns.hpp"
#include "hdf5/digest.hpp"
#include "hdf5/read.hpp"
#include "store/file_calls.hpp"

namespace floes {

namespace fs = std::filesystem;

namespace {

fs::path home_of(const fs::path& campaign_file) {
    const fs::path folder = target_of(campaign_file).parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

fs::path piece_folder(const fs::path& campaign_file) {
    return target_of(campaign_file).replace_extension(".pieces");
}

bool is_piece_name(const std::string& name) {
    static const std::regex form(R"([0-9]+-[0-9]+\.h5(\.tmp)?)");
    return std::regex_match(name, form);
}

}  // namespace

std::pair<int, int> arrangements_of_piece(int arrangements, int pieces, int number) {
    const auto from = [&](int k) { return static_cast<int>(static_cast<std::int64_t>(arrangements) * k / pieces); };
    return {from(number), from(number + 1) - from(number)};
}

std::string piece_name(const fs::path& campaign_file, std::size_t session, int number) {
    return fmt::format("{}/{}-{}.h5", piece_folder(campaign_file).filename().string(), session, number);
}

void make_piece_folder(const fs::path& campaign_file) {
    const fs::path folder = piece_folder(campaign_file);
    std::error_code error;
    fs::create_directory(folder, error);
    if (error)
        throw RunError(fmt::format("the folder {} for the pieces of {} cannot be made: {}.", folder.string(),
                                   campaign_file.string(), error.message()));
    sync_folder_of(folder);
}

void remove_pieces(const fs::path& campaign_file, std::span<const FilePiece> but) {
    const fs::path folder = piece_folder(campaign_file);
    std::error_code none;
    std::vector<fs::path> old;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
        const std::string name = entry.path().filename().string();
        const std::string relative = fmt::format("{}/{}", folder.filename().string(), name);
        if (is_piece_name(name) && std::ranges::find(but, relative, &FilePiece::file) == but.end())
            old.push_back(entry.path());
    }
    for (const fs::path& path : old) fs::remove(path, none);
    if (but.empty() && fs::is_empty(folder, none) && !none) fs::remove(folder, none);
}

std::uintmax_t size_with_pieces(const fs::path& campaign_file) {
    std::uintmax_t bytes = fs::file_size(campaign_file);
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(piece_folder(campaign_file), none))
        if (is_piece_name(entry.path().filename().string())) bytes += entry.file_size();
    return bytes;
}

void remove_those(const fs::path& campaign_file, std::span<const FilePiece> pieces) {
    std::error_code ignored;
    for (const FilePiece& piece : pieces) fs::remove(path_of_piece(campaign_file, piece), ignored);
}

fs::path path_of_piece(const fs::path& campaign_file, const FilePiece& piece) {
    return home_of(campaign_file) / piece.file;
}

std::vector<FilePiece> pieces_of(std::int64_t file) {
    if (!hdf5::exists(file, "provenance/piece")) return {};
    std::vector<FilePiece> pieces;
    for (std::string& name : hdf5::read_texts(file, "provenance/piece")) pieces.emplace_back().file = std::move(name);
    read_columns(file, "provenance", piece_columns, pieces);
    return pieces;
}

namespace {

std::string rows_words(const FilePiece& piece) {
    return piece.count == 1 ? fmt::format("arrangement {}", piece.first)
                            : fmt::format("arrangements {} to {}", piece.first, piece.first + piece.count - 1);
}

}  // namespace

std::vector<hdf5::Handle> open_pieces(const fs::path& campaign_file, std::span<const FilePiece> pieces) {
    std::vector<hdf5::Handle> open;
    for (const FilePiece& piece : pieces) {
        const fs::path path = path_of_piece(campaign_file, piece);
        if (!fs::exists(path))
            throw InputError(fmt::format(
                "{} is made of {}, and {} with {} is not there. Keep the file and the folder {} together; with its "
                "journal beside it, floes run CONFIG.toml -o {} --resume makes it anew.",
                campaign_file.string(), counted(std::ssize(pieces), "piece"), path.string(), rows_words(piece),
                piece_folder(campaign_file).filename().string(), shell_word(campaign_file.string())));
        open.push_back(hdf5::open_for_reading(path));
        hdf5::check_kind(open.back().id(), piece_kind, path);
        const std::string found = hdf5::read_contents_digests(open.back().id()).contents;
        if (found != piece.digest)
            throw InputError(fmt::format(
                "{} is not the piece that {} was made with: its digest is {} in place of {}. Put the right one there, "
                "with {}; with its journal beside it, floes run CONFIG.toml -o {} --resume makes the file anew.",
                path.string(), campaign_file.string(), found, piece.digest, rows_words(piece),
                shell_word(campaign_file.string())));
    }
    return open;
}

}  // namespace floes
