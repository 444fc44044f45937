#include "core/bytes.hpp"

#include <cstring>
#include <ostream>

#include "core/error.hpp"

namespace floes {

namespace {

template <class Integer>
Integer little_endian(Integer value) {
    if constexpr (std::endian::native == std::endian::little) return value;
    Integer swapped = 0;
    for (std::size_t k = 0; k < sizeof(Integer); ++k) swapped = (swapped << 8) | ((value >> (8 * k)) & 0xff);
    return swapped;
}

template <class Integer>
void append(Bytes& bytes, Integer value) {
    const Integer ordered = little_endian(value);
    const auto* first = reinterpret_cast<const std::byte*>(&ordered);
    bytes.insert(bytes.end(), first, first + sizeof(Integer));
}

template <class Integer>
Integer extract(std::span<const std::byte> bytes) {
    Integer value = 0;
    std::memcpy(&value, bytes.data(), sizeof(Integer));
    return little_endian(value);
}

}  // namespace

void ByteWriter::u32(std::uint32_t value) {
    append(bytes_, value);
}
void ByteWriter::u64(std::uint64_t value) {
    append(bytes_, value);
}
void ByteWriter::blob(std::span<const std::byte> value) {
    u64(value.size());
    bytes_.insert(bytes_.end(), value.begin(), value.end());
}

void ByteWriter::doubles(std::span<const double> values) {
    u64(values.size());
    for (const double value : values) f64(value);
}

std::span<const std::byte> ByteReader::take(std::size_t size) {
    if (size > rest_.size())
        throw RunError("a stored record ends before its contents do; it was damaged or written by another version");
    const auto taken = rest_.first(size);
    rest_ = rest_.subspan(size);
    return taken;
}

std::uint32_t ByteReader::u32() {
    return extract<std::uint32_t>(take(4));
}
std::uint64_t ByteReader::u64() {
    return extract<std::uint64_t>(take(8));
}
std::size_t ByteReader::count(std::size_t bytes_each) {
    const std::uint64_t number = u64();
    if (number > rest_.size() / bytes_each)
        throw RunError("a stored record has a count that exceeds its length; it was damaged");
    return static_cast<std::size_t>(number);
}

std::string ByteReader::text() {
    const auto taken = take(count(1));
    return {reinterpret_cast<const char*>(taken.data()), taken.size()};
}

Bytes ByteReader::blob() {
    const auto taken = take(count(1));
    return {taken.begin(), taken.end()};
}

std::vector<double> ByteReader::doubles() {
    std::vector<double> values(count(sizeof(double)));
    for (double& value : values) value = f64();
    return values;
}

void write_base64(std::ostream& text, std::span<const std::byte> bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string block;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = bytes.size() - i;
        const auto byte = [&](std::size_t k) { return k < left ? std::to_integer<unsigned>(bytes[i + k]) : 0; };
        const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
        block += digits[three >> 18];
        block += digits[three >> 12 & 63];
        block += left > 1 ? digits[three >> 6 & 63] : '=';
        block += left > 2 ? digits[three & 63] : '=';
        if (block.size() < 1 << 16) continue;
        text << block;
        block.clear();
    }
    text << block;
}

}  // namespace floes
