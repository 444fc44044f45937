#include "run/messages.hpp"

#include "core/error.hpp"

namespace floes {

namespace {

constexpr std::size_t assignment_bytes = 4 + 4 + 1;
constexpr std::size_t progress_bytes = 4 + 2 * 8;
constexpr std::size_t least_answer_bytes = 4 + 8;
constexpr std::size_t note_bytes = 8 + 4 + 4 + 4 * found_axes.size() + 1;
constexpr std::size_t place_bytes = 4 + 8 + 8;
constexpr std::size_t least_kept_bytes = 2 * 4 + note_bytes + place_bytes + 8;
constexpr std::size_t least_piece_member_bytes = 4 + 1;
constexpr std::size_t text_bytes = 8;  // of an empty one

/// What `read` takes of a whole message.
template <class Read>
auto whole(const Bytes& bytes, const Read& read) {
    ByteReader reader(bytes);
    auto message = read(reader);
    if (reader.left() != 0) throw RunError("a message is longer than what it says; another version of floes sent it");
    return message;
}

void put(ByteWriter& writer, const MemberNote& note) {
    writer.f64(note.wall_time);
    writer.i32(note.arrangement);
    writer.i32(note.attempt);
    for (const int one : note.found) writer.i32(one);
    writer.u8(note.done() ? 1 : 0);
}

MemberNote take_note(ByteReader& reader) {
    MemberNote note;
    note.wall_time = reader.f64();
    note.arrangement = reader.i32();
    note.attempt = reader.i32();
    for (int& one : note.found) one = reader.i32();
    note.status = reader.u8() == 1 ? MemberStatus::done : MemberStatus::failed;
    return note;
}

void put(ByteWriter& writer, const JournalContents::Place& place) {
    writer.i32(place.piece);
    writer.u64(place.offset);
    writer.u64(place.size);
}

JournalContents::Place take_place(ByteReader& reader) {
    JournalContents::Place place;
    place.piece = reader.i32();
    place.offset = reader.u64();
    place.size = reader.u64();
    return place;
}

void put(ByteWriter& writer, const FoundSizes& sizes) {
    for (const std::size_t one : sizes) writer.u64(one);
}

FoundSizes take_sizes(ByteReader& reader) {
    FoundSizes sizes{};
    for (std::size_t& one : sizes) one = reader.u64();
    return sizes;
}

void put(ByteWriter& writer, const std::vector<std::string>& texts) {
    writer.u64(texts.size());
    for (const std::string& text : texts) writer.text(text);
}

std::vector<std::string> take_texts(ByteReader& reader) {
    std::vector<std::string> texts(reader.count(text_bytes));
    for (std::string& text : texts) text = reader.text();
    return texts;
}

}  // namespace

Bytes encode(const Hello& hello) {
    ByteWriter writer;
    writer.i32(hello.cores);
    writer.text(hello.host);
    writer.text(hello.fingerprint);
    writer.i32(hello.pid);
    return writer.take();
}

Bytes encode(const Post& post) {
    ByteWriter writer;
    writer.i32(post.writer);
    writer.text(post.journal);
    return writer.take();
}

Bytes encode(const std::vector<Kept>& kept) {
    ByteWriter writer;
    writer.u64(kept.size());
    for (const Kept& one : kept) {
        writer.i32(one.worker);
        writer.i32(one.number);
        put(writer, one.note);
        put(writer, one.place);
        writer.blob(one.record ? encode(*one.record) : Bytes{});
    }
    return writer.take();
}

Bytes encode(const std::vector<Assignment>& assignments) {
    ByteWriter writer;
    writer.u64(assignments.size());
    for (const Assignment& assignment : assignments) {
        writer.i32(assignment.number);
        writer.i32(assignment.attempt);
        writer.u8(assignment.apart ? 1 : 0);
    }
    return writer.take();
}

Bytes encode(const std::vector<MemberProgress>& progress) {
    ByteWriter writer;
    writer.u64(progress.size());
    for (const MemberProgress& one : progress) {
        writer.i32(one.number);
        writer.f64(one.time);
        writer.f64(one.end);
    }
    return writer.take();
}

Bytes encode(const std::vector<Answer>& answers) {
    ByteWriter writer;
    writer.u64(answers.size());
    for (const Answer& answer : answers) {
        writer.i32(answer.number);
        writer.blob(encode(answer.record));
    }
    return writer.take();
}

Bytes encode_status(int exit_status) {
    ByteWriter writer;
    writer.i32(exit_status);
    return writer.take();
}

Bytes encode_text(std::string_view text) {
    ByteWriter writer;
    writer.text(text);
    return writer.take();
}

Hello decode_hello(const Bytes& bytes) {
    return whole(bytes, [](ByteReader& reader) {
        Hello hello;
        hello.cores = reader.i32();
        hello.host = reader.text();
        hello.fingerprint = reader.text();
        hello.pid = reader.i32();
        return hello;
    });
}

Post decode_post(const Bytes& bytes) {
    return whole(bytes, [](ByteReader& reader) {
        Post post;
        post.writer = reader.i32();
        post.journal = reader.text();
        return post;
    });
}

std::vector<Kept> decode_kept(const Bytes& bytes) {
    return whole(bytes, [](ByteReader& reader) {
        const std::size_t count = reader.count(least_kept_bytes);
        std::vector<Kept> kept;  // grows with what is there, as the answers
        while (kept.size() < count) {
            Kept& one = kept.emplace_back();
            one.worker = reader.i32();
            one.number = reader.i32();
            one.note = take_note(reader);
            one.place = take_place(reader);
            if (const Bytes record = reader.blob(); !record.empty()) one.record = decode_member_record(record);
        }
        return kept;
    });
}

std::vector<MemberProgress> decode_progress(const Bytes& bytes) {
    return whole(bytes, [](ByteReader& reader) {
        std::vector<MemberProgress> progress(reader.count(progress_bytes));
        for (MemberProgress& one : progress) {
            one.number = reader.i32();
            one.time = reader.f64();
            one.end = reader.f64();
        }
        return progress;
    });
}

std::vector<Assignment> decode_assignments(const Bytes& bytes) {
    return whole(bytes, [](ByteReader& reader) {
        std::vector<Assignment> assignments(reader.count(assignment_bytes));
        for (Assignment& assignment : assignments) {
            assignment.number = reader.i32();
            assignment.attempt = reader.i32();
            const std::uint8_t apart = reader.u8();
            if (apart > 1) throw RunError("an assignment is neither apart nor not; another version of floes sent it");
            assignment.apart = apart == 1;
        }
        return assignments;
    });
}

std::vector<Answer> decode_answers(const Bytes& bytes) {
    return whole(bytes, [](ByteReader& reader) {
        const std::size_t count = reader.count(least_answer_bytes);
        std::vector<Answer> answers;  // grows with what is there: an answer is far larger than its fewest bytes
        while (answers.size() < count) {
            const int number = reader.i32();
            answers.push_back({number, decode_member_record(reader.blob())});
        }
        return answers;
    });
}

Bytes encode(const PieceOrder& order) {
    ByteWriter writer;
    writer.text(order.campaign_file);
    writer.text(order.journal);
    writer.text(order.name);
    writer.i32(order.arrangements);
    writer.i32(order.first);
    put(writer, order.most);
    writer.u64(order.members.size());
    for (const PieceOrder::Member& one : order.members) {
        writer.i32(one.attempts);
        writer.u8(one.has_record ? 1 : 0);
        if (!one.has_record) continue;
        put(writer, one.note);
        put(writer, one.place);
    }
    return writer.take();
}

PieceOrder decode_piece_order(const Bytes& bytes) {
    return whole(bytes, [](ByteReader& reader) {
        PieceOrder order;
        order.campaign_file = reader.text();
        order.journal = reader.text();
        order.name = reader.text();
        order.arrangements = reader.i32();
        order.first = reader.i32();
        order.most = take_sizes(reader);
        order.members.resize(reader.count(least_piece_member_bytes));
        for (PieceOrder::Member& one : order.members) {
            one.attempts = reader.i32();
            one.has_record = reader.u8() == 1;
            if (!one.has_record) continue;
            one.note = take_note(reader);
            one.place = take_place(reader);
        }
        return order;
    });
}

Bytes encode(const DigestOrder& order) {
    ByteWriter writer;
    writer.text(order.file);
    put(writer, order.pieces);
    put(writer, order.datasets);
    return writer.take();
}

DigestOrder decode_digest_order(const Bytes& bytes) {
    return whole(bytes, [](ByteReader& reader) {
        DigestOrder order;
        order.file = reader.text();
        order.pieces = take_texts(reader);
        order.datasets = take_texts(reader);
        return order;
    });
}

Bytes encode(const PieceMade& made) {
    ByteWriter writer;
    writer.text(made.trouble);
    writer.f64(made.processor_time);
    writer.text(made.piece.file);
    writer.text(made.piece.digest);
    writer.i32(made.piece.first);
    writer.i32(made.piece.count);
    put(writer, made.piece.found);
    return writer.take();
}

PieceMade decode_piece_made(const Bytes& bytes) {
    return whole(bytes, [](ByteReader& reader) {
        PieceMade made;
        made.trouble = reader.text();
        made.processor_time = reader.f64();
        made.piece.file = reader.text();
        made.piece.digest = reader.text();
        made.piece.first = reader.i32();
        made.piece.count = reader.i32();
        made.piece.found = take_sizes(reader);
        return made;
    });
}

Bytes encode(const DigestsMade& made) {
    ByteWriter writer;
    writer.text(made.trouble);
    writer.u64(made.digests.size());
    for (const auto& [path, digest] : made.digests) {
        writer.text(path);
        writer.text(digest);
    }
    return writer.take();
}

DigestsMade decode_digests_made(const Bytes& bytes) {
    return whole(bytes, [](ByteReader& reader) {
        DigestsMade made;
        made.trouble = reader.text();
        for (std::size_t left = reader.count(2 * text_bytes); left > 0; --left) {
            std::string path = reader.text();
            made.digests[std::move(path)] = reader.text();
        }
        return made;
    });
}

int decode_status(const Bytes& bytes) {
    return whole(bytes, [](ByteReader& reader) { return reader.i32(); });
}

std::string decode_text(const Bytes& bytes) {
    return whole(bytes, [](ByteReader& reader) { return reader.text(); });
}

}  // namespace floes
