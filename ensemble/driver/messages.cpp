#include "driver/messages.hpp"

namespace floes {

Bytes encode(const Hello& hello) {
    ByteWriter writer;
    writer.i32(hello.cores);
    writer.text(hello.host);
    writer.text(hello.fingerprint);
    writer.i32(hello.pid);
    return writer.take();
}

Bytes encode(const Assignment& assignment) {
    ByteWriter writer;
    writer.i32(assignment.number);
    writer.i32(assignment.attempt);
    writer.u8(assignment.apart ? 1 : 0);
    return writer.take();
}

Bytes encode(const Answer& answer) {
    ByteWriter writer;
    writer.i32(answer.number);
    Bytes bytes = writer.take();
    const Bytes record = encode(answer.record);
    bytes.insert(bytes.end(), record.begin(), record.end());
    return bytes;
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

Assignment decode_assignment(const Bytes& bytes) {
    ByteReader reader(bytes);
    Assignment assignment;
    assignment.number = reader.i32();
    assignment.attempt = reader.i32();
    assignment.apart = reader.u8() != 0;
    return assignment;
}

Answer decode_answer(const Bytes& bytes) {
    ByteReader reader(bytes);
    const int number = reader.i32();
    return {number, decode_member_record(std::span(bytes).last(reader.left()))};
}

int decode_status(const Bytes& bytes) {
    return ByteReader(bytes).i32();
}

std::string decode_text(const Bytes& bytes) {
    return ByteReader(bytes).text();
}

}  // namespace floes
