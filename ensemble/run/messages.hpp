#pragma once
// Contents of the messages between master and workers. Tags without a function here carry nothing (dismiss,
// stop_request, close, closed), plain text (campaign, trouble) or a number (leave, a farewell that is passed on).

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign_file/pieces.hpp"
#include "core/bytes.hpp"
#include "run/crew.hpp"
#include "store/journal.hpp"
#include "store/member_record.hpp"

namespace floes {

/// A worker introduces itself.
struct Hello {
    int cores = 1;  ///< number of members it computes at a time
    std::string host;
    std::string fingerprint;  ///< of the campaign as it read it
    int pid = 0;              ///< of its process
};

/// A finished member.
struct Answer {
    int number = 0;
    MemberRecord record;
};

/// Who keeps the records of a rank.
struct Post {
    int writer = 0;       ///< rank
    std::string journal;  ///< that this rank opens; empty unless it is the writer
};

/// A member whose record is in a writer's journal.
struct Kept {
    int worker = 0;  ///< rank that computed it
    int number = 0;
    MemberNote note;                     ///< without the number of its key
    JournalContents::Place place;        ///< in the journal of the writer
    std::optional<MemberRecord> record;  ///< for the stop rule, where there is one: without histories
};

/// A piece of the campaign file that a rank is to publish.
struct PieceOrder {
    std::string campaign_file;  ///< absolute, as the next
    std::string journal;
    std::string name;      ///< of the piece
    int arrangements = 0;  ///< of the campaign that is published
    int first = 0;         ///< arrangement of the piece
    FoundSizes most{};     ///< PieceRows::most
    struct Member {
        int attempts = 0;
        bool has_record = false;
        MemberNote note;  ///< without its key; of these two nothing without a record
        JournalContents::Place place;
    };
    std::vector<Member> members;  ///< of all its arrangements
};

/// The datasets of a campaign file over pieces that a rank is to digest.
struct DigestOrder {
    std::string file;
    std::vector<std::string> pieces;
    std::vector<std::string> datasets;
};

/// What became of an order.
struct PieceMade {
    std::string trouble;        ///< empty, or why there is no piece
    double processor_time = 0;  ///< s
    FilePiece piece;
};
struct DigestsMade {
    std::string trouble;
    DatasetDigests digests;
};

Bytes encode(const Hello& hello);
Bytes encode(const Post& post);
Bytes encode(const std::vector<Kept>& kept);
Bytes encode(const PieceOrder& order);
Bytes encode(const DigestOrder& order);
Bytes encode(const PieceMade& made);
Bytes encode(const DigestsMade& made);
Bytes encode(const std::vector<MemberProgress>& progress);
Bytes encode(const std::vector<Assignment>& assignments);
Bytes encode(const std::vector<Answer>& answers);
Bytes encode_status(int exit_status);
Bytes encode_text(std::string_view text);

// Each throws RunError if the bytes are malformed.
Hello decode_hello(const Bytes& bytes);
Post decode_post(const Bytes& bytes);
std::vector<Kept> decode_kept(const Bytes& bytes);
PieceOrder decode_piece_order(const Bytes& bytes);
DigestOrder decode_digest_order(const Bytes& bytes);
PieceMade decode_piece_made(const Bytes& bytes);
DigestsMade decode_digests_made(const Bytes& bytes);
std::vector<MemberProgress> decode_progress(const Bytes& bytes);
std::vector<Assignment> decode_assignments(const Bytes& bytes);
std::vector<Answer> decode_answers(const Bytes& bytes);
int decode_status(const Bytes& bytes);
std::string decode_text(const Bytes& bytes);

}  // namespace floes
