#pragma once
// A campaign file by many hands: each writes a piece, an HDF5 file with the rows of some arrangements, and the campaign
// file refers to the pieces (HDF5's virtual datasets). Pieces lie in NAME.pieces beside NAME.h5.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "hdf5/handle.hpp"
#include "member/array_output.hpp"
#include "store/member_record.hpp"
#include "store/session.hpp"

namespace floes {

/// Places along each of found_axes: the most of a member, or all of what is listed.
using FoundSizes = std::array<std::size_t, found_axes.size()>;

/// Adds what a done member has.
void add_found(FoundSizes& sizes, const MemberNote& note);

/// A piece that is there.
struct FilePiece {
    std::string file;    ///< relative to the folder of the campaign file
    std::string digest;  ///< of its contents
    int first = 0;       ///< arrangement
    int count = 0;       ///< of arrangements
    FoundSizes found{};  ///< not known of pieces that were read
};

/// The members of a piece, in their order.
struct PieceRows {
    int first = 0;                                    ///< arrangement
    std::vector<std::optional<std::size_t>> records;  ///< of each; none where there is none
    std::vector<int> attempts;                        ///< at each
    FoundSizes most{};                                ///< of all members of the campaign
};

/// Which of so many arrangements the piece `number` (from 0) of so many has: the first, and how many.
std::pair<int, int> arrangements_of_piece(int arrangements, int pieces, int number);

/// `a.h5` -> `a.pieces/3-1.h5`, relative to the folder of the file: piece 1 of the session 3. No session writes where
/// another did, so what an older file refers to stays.
std::string piece_name(const std::filesystem::path& campaign_file, std::size_t session, int number);

/// Writes a piece aside, brings it to the disk and renames it into place. `name`: of piece_name(); its folder is there.
/// `members`: those of `rows`. Throws RunError as publish() does.
FilePiece publish_piece(const std::filesystem::path& campaign_file, const std::string& name, const Campaign& campaign,
                        const StoredMembers& members, PieceRows rows);

/// The values of the attribute `digest` of datasets, by their paths.
using DatasetDigests = std::map<std::string, std::string>;

/// The digests of some datasets of a file that refers to pieces, as they are read through it; of tables whose rows are
/// packed by the checksums that the pieces keep of these.
DatasetDigests digests_over_pieces(const std::filesystem::path& file, std::span<const FilePiece> pieces,
                                   std::span<const std::string> datasets);

/// Who computes them: digests_over_pieces(), or several ranks.
using DigestsOver =
    std::function<DatasetDigests(const std::filesystem::path& file, const std::vector<std::string>& datasets)>;

/// Publishes the campaign file over pieces that are there and on the disk, in order, which have all arrangements. Every
/// digest in it is that of a file with rows of its own. `most`: as PieceRows has it. Removes the pieces that it does
/// not refer to, or these where it cannot be written. The rest as publish().
void publish_over_pieces(const std::filesystem::path& campaign_file, const Campaign& campaign,
                         std::span<const FilePiece> pieces, const FoundSizes& most, std::span<const Session> sessions,
                         std::span<const CalibrationRecord> calibrations, const DigestsOver& digests);

/// Makes the folder of the pieces. Throws RunError where it cannot be made.
void make_piece_folder(const std::filesystem::path& campaign_file);

/// Removes the pieces beside a campaign file, all but these, and their folder if nothing is left in it.
void remove_pieces(const std::filesystem::path& campaign_file, std::span<const FilePiece> but = {});

/// Bytes of a campaign file that is there, with its pieces.
std::uintmax_t size_with_pieces(const std::filesystem::path& campaign_file);

/// Removes these.
void remove_those(const std::filesystem::path& campaign_file, std::span<const FilePiece> pieces);

/// The pieces that an open campaign file refers to; none of one with rows of its own.
std::vector<FilePiece> pieces_of(std::int64_t file);

/// Where a piece lies.
std::filesystem::path path_of_piece(const std::filesystem::path& campaign_file, const FilePiece& piece);

/// Opens the pieces, so that HDF5 finds them open. Throws InputError where one is not there or not the one that the
/// file was made with, and RunError where it is damaged: HDF5 itself would give NaN for its rows.
std::vector<hdf5::Handle> open_pieces(const std::filesystem::path& campaign_file, std::span<const FilePiece> pieces);

}  // namespace floes
