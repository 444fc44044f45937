#pragma once
// A campaign file over pieces, as several writers publish it.

#include <filesystem>
#include <string>
#include <vector>

#include "campaign_file/pieces.hpp"
#include "store/member_record.hpp"

namespace floes {

/// The pieces of session `session`, so many, on the disk.
inline std::vector<FilePiece> publish_pieces(const std::filesystem::path& path, const Campaign& campaign,
                                             const std::vector<MemberRecord>& records, int count,
                                             std::size_t session = 1) {
    const StoredMembers members(records);
    const auto matched = match_records(campaign, members.notes());
    const std::vector<int> attempts = last_attempts(campaign, members.notes());
    FoundSizes most{};
    for (const auto& record : matched)
        if (record && members.notes()[*record].done()) add_found(most, members.notes()[*record]);
    make_piece_folder(path);
    std::vector<FilePiece> pieces;
    for (int k = 0; k < count; ++k) {
        const auto [first, arrangements] = arrangements_of_piece(campaign.arrangements, count, k);
        const auto cases = std::ssize(campaign.cases);
        const auto rows_of = [&, from = first * cases, to = (first + arrangements) * cases](const auto& all) {
            return std::vector(all.begin() + from, all.begin() + to);
        };
        pieces.push_back(
            publish_piece(path, piece_name(path, session, k + 1), campaign, members,
                          {.first = first, .records = rows_of(matched), .attempts = rows_of(attempts), .most = most}));
    }
    return pieces;
}

inline void publish_in_pieces(const std::filesystem::path& path, const Campaign& campaign,
                              const std::vector<MemberRecord>& records, int count,
                              const std::vector<Session>& sessions = {},
                              const std::vector<CalibrationRecord>& calibrations = {}, std::size_t session = 1) {
    const std::vector<FilePiece> pieces = publish_pieces(path, campaign, records, count, session);
    FoundSizes most{};
    for (const MemberRecord& record : records) {
        MemberNotes notes;
        notes.add(record);
        if (notes[0].done()) add_found(most, notes[0]);
    }
    publish_over_pieces(path, campaign, pieces, most, sessions, calibrations,
                        [&](const std::filesystem::path& file, const std::vector<std::string>& datasets) {
                            return digests_over_pieces(file, pieces, datasets);
                        });
}

}  // namespace floes
