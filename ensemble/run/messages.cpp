#include "run/messages.hpp"

#include "core/error.hpp"

namespace floes {

namespace {

constexpr std::size_t assignment_bytes = 4 + 4 + 1;
constexpr std::size_t progress_bytes = 4 + 2 * 8;
constexpr std::size_t least_answer_bytes = 4 + 8;
constexpr std::size_t least_kept_bytes = 3 * 4 + 8 + 8;

/// What `read` takes of a whole message.
template <class Read>
auto whole(const Bytes& bytes, const Read& read) {
    ByteReader reader(bytes);
    auto message = read(reader);
    if (reader.left() != 0) throw RunError("a message is longer than what it says; another version of floes sent it");
    return message;
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
        writer.i32(one.attempt);
        writer.f64(one.wall_time);
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
            one.attempt = reader.i32();
            one.wall_time = reader.f64();
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

int decode_status(const Bytes& bytes) {
    return whole(bytes, [](ByteReader& reader) { return reader.i32(); });
}

std::string decode_text(const Bytes& bytes) {
    return whole(bytes, [](ByteReader& reader) { return reader.text(); });
}

}  // namespace floes
