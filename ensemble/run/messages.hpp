#pragma once
// Contents of the messages between master and workers. Tags without a content here carry nothing (dismiss,
// stop_request, close, closed), plain text (campaign, trouble) or a number (leave, a farewell that is passed on).

#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "campaign_file/pieces.hpp"
#include "core/error.hpp"
#include "core/fields.hpp"
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

    static constexpr auto fields() { return std::tuple(&Hello::cores, &Hello::host, &Hello::fingerprint, &Hello::pid); }
};

/// A finished member.
struct Answer {
    int number = 0;
    MemberRecord record;

    static constexpr auto fields() { return std::tuple(&Answer::number, &Answer::record); }
};

/// Who keeps the records of a rank.
struct Post {
    int writer = 0;       ///< rank
    std::string journal;  ///< that this rank opens; empty unless it is the writer

    static constexpr auto fields() { return std::tuple(&Post::writer, &Post::journal); }
};

/// A member whose record is in a writer's journal.
struct Kept {
    int worker = 0;  ///< rank that computed it
    int number = 0;
    MemberNote note;                     ///< without the number of its key
    JournalContents::Place place;        ///< in the journal of the writer
    std::optional<MemberRecord> record;  ///< for the stop rule, where there is one: without histories

    static constexpr auto fields() {
        return std::tuple(&Kept::worker, &Kept::number, &Kept::note, &Kept::place, &Kept::record);
    }
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

        static constexpr auto fields() {
            return std::tuple(&Member::attempts, &Member::has_record, &Member::note, &Member::place);
        }
    };
    std::vector<Member> members;  ///< of all its arrangements

    static constexpr auto fields() {
        using Order = PieceOrder;
        return std::tuple(&Order::campaign_file, &Order::journal, &Order::name, &Order::arrangements, &Order::first,
                          &Order::most, &Order::members);
    }
};

/// The datasets of a campaign file over pieces that a rank is to digest.
struct DigestOrder {
    std::string file;
    std::vector<std::string> pieces;
    std::vector<std::string> datasets;

    static constexpr auto fields() {
        return std::tuple(&DigestOrder::file, &DigestOrder::pieces, &DigestOrder::datasets);
    }
};

/// What became of an order.
struct PieceMade {
    std::string trouble;        ///< empty, or why there is no piece
    double processor_time = 0;  ///< s
    FilePiece piece;

    static constexpr auto fields() {
        return std::tuple(&PieceMade::trouble, &PieceMade::processor_time, &PieceMade::piece);
    }
};
struct DigestsMade {
    std::string trouble;
    DatasetDigests digests;

    static constexpr auto fields() { return std::tuple(&DigestsMade::trouble, &DigestsMade::digests); }
};

/// Of what is declared elsewhere; notes go without their key.
constexpr auto fields_of(std::type_identity<Assignment>) {
    return std::tuple(&Assignment::number, &Assignment::attempt, &Assignment::apart);
}
constexpr auto fields_of(std::type_identity<MemberProgress>) {
    return std::tuple(&MemberProgress::number, &MemberProgress::time, &MemberProgress::end);
}
constexpr auto fields_of(std::type_identity<MemberNote>) {
    return std::tuple(&MemberNote::wall_time, &MemberNote::arrangement, &MemberNote::attempt, &MemberNote::found,
                      &MemberNote::status);
}
constexpr auto fields_of(std::type_identity<JournalContents::Place>) {
    using Place = JournalContents::Place;
    return std::tuple(&Place::piece, &Place::offset, &Place::size);
}
constexpr auto fields_of(std::type_identity<FilePiece>) {
    return std::tuple(&FilePiece::file, &FilePiece::digest, &FilePiece::first, &FilePiece::count, &FilePiece::found);
}
void put_value(ByteWriter& out, MemberStatus status);
void take_value(ByteReader& in, MemberStatus& status);
void put_value(ByteWriter& out, const MemberRecord& record);
void take_value(ByteReader& in, MemberRecord& record);
void put_value(ByteWriter& out, const std::optional<MemberRecord>& record);
void take_value(ByteReader& in, std::optional<MemberRecord>& record);

/// One of the above, a list of these, a text, or a number.
template <class Message>
Bytes encode(const Message& message) {
    ByteWriter writer;
    put(writer, message);
    return writer.take();
}

/// Throws RunError if the bytes are malformed.
template <class Message>
Message decode(const Bytes& bytes) {
    ByteReader reader(bytes);
    Message message{};
    take(reader, message);
    if (reader.left() != 0) throw RunError("a message is longer than what it says; another version of floes sent it");
    return message;
}

}  // namespace floes
