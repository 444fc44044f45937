#include "driver/messages.hpp"

namespace floes {

namespace {

constexpr std::size_t assignment_bytes = 4 + 4 + 1;
constexpr std::size_t least_answer_bytes = 4 + 8;

}  // namespace

Bytes encode(const Hello& hello) {
    ByteWriter writer;
    writer.i32(hello.cores);
    writer.text(hello.host);
    writer.text(hello.fingerprint);
    writer.i32(hello.pid);
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
    ByteReader reader(bytes);
    Hello hello;
    hello.cores = reader.i32();
    hello.host = reader.text();
    hello.fingerprint = reader.text();
    hello.pid = reader.i32();
    return hello;
}

std::vector<Assignment> decode_assignments(const Bytes& bytes) {
    ByteReader reader(bytes);
    std::vector<Assignment> assignments(reader.count(assignment_bytes));
    for (Assignment& assignment : assignments) {
        assignment.number = reader.i32();
        assignment.attempt = reader.i32();
        assignment.apart = reader.u8() != 0;
    }
    return assignments;
}

std::vector<Answer> decode_answers(const Bytes& bytes) {
    ByteReader reader(bytes);
    std::vector<Answer> answers(reader.count(least_answer_bytes));
    for (Answer& answer : answers) {
        answer.number = reader.i32();
        answer.record = decode_member_record(reader.blob());
    }
    return answers;
}

int decode_status(const Bytes& bytes) {
    return ByteReader(bytes).i32();
}

std::string decode_text(const Bytes& bytes) {
    return ByteReader(bytes).text();
}

}  // namespace floes
