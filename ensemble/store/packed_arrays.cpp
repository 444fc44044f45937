#include "store/packed_arrays.hpp"

#include <bit>

#include <fmt/format.h>
#include <zlib.h>

#include "core/error.hpp"

namespace floes {

std::uint32_t checksum(std::span<const double> numbers) {
    const Bytes bytes = shuffled(numbers);
    const uLong start = adler32(0, nullptr, 0);
    return static_cast<std::uint32_t>(adler32_z(start, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::uint32_t checksum(const PackedNumbers& packed) {
    constexpr std::size_t size = sizeof(std::uint32_t);
    if (!packed.deflated() || packed.chunk.size() < size) return checksum(unpack(packed));
    std::uint32_t value = 0;  // the most significant byte first
    for (const std::byte one : std::span(packed.chunk).last(size))
        value = value << 8 | std::to_integer<std::uint32_t>(one);
    return value;
}

namespace {

constexpr std::size_t width = sizeof(double);
constexpr std::uint64_t most_numbers = 25'000'000;  // more than a run may have steps; 200 MB

/// The bytes of each number follow each other, or with `by_bytes` the first byte of all numbers comes first.
Bytes bytes_of(std::span<const double> numbers, bool by_bytes) {
    const std::size_t count = numbers.size();
    Bytes bytes(width * count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto bits = std::bit_cast<std::uint64_t>(numbers[i]);
        for (std::size_t k = 0; k < width; ++k)
            bytes[by_bytes ? i + k * count : i * width + k] = static_cast<std::byte>(bits >> (8 * k));
    }
    return bytes;
}

std::vector<double> numbers_of(const Bytes& bytes, bool by_bytes) {
    const std::size_t count = bytes.size() / width;
    std::vector<double> numbers(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < width; ++k)
            bits |= std::to_integer<std::uint64_t>(bytes[by_bytes ? i + k * count : i * width + k]) << (8 * k);
        numbers[i] = std::bit_cast<double>(bits);
    }
    return numbers;
}

Bytes deflated(const Bytes& plain) {
    uLongf size = compressBound(plain.size());
    Bytes chunk(size);
    const int code = compress2(reinterpret_cast<Bytef*>(chunk.data()), &size,
                               reinterpret_cast<const Bytef*>(plain.data()), plain.size(), compression_level);
    if (code != Z_OK) throw RunError(fmt::format("zlib cannot compress the numbers of a member: {}.", zError(code)));
    chunk.resize(size);
    chunk.shrink_to_fit();  // it is kept in a message for a while
    return chunk;
}

/// Decompresses to `size` bytes.
Bytes inflated(const Bytes& chunk, std::size_t size) {
    uLongf found = size;
    Bytes plain(size);
    const int code = uncompress(reinterpret_cast<Bytef*>(plain.data()), &found,
                                reinterpret_cast<const Bytef*>(chunk.data()), chunk.size());
    if (code != Z_OK || found != size)
        throw RunError("the numbers of a stored member cannot be decompressed; it was damaged");
    return plain;
}

}  // namespace

Bytes shuffled(std::span<const double> numbers) {
    return bytes_of(numbers, true);
}

PackedNumbers pack(std::span<const double> numbers) {
    PackedNumbers packed{numbers.size(), {}};
    packed.chunk = bytes_of(numbers, packed.deflated());
    if (packed.deflated()) packed.chunk = deflated(packed.chunk);
    return packed;
}

std::vector<double> unpack(const PackedNumbers& packed) {
    // Deflate compresses by a factor of at most 1032, so a damaged count cannot cause a huge allocation.
    constexpr std::uint64_t most_in_a_byte = 1032 / width + 1;
    const bool possible = packed.deflated() ? packed.count <= most_in_a_byte * packed.chunk.size()
                                            : packed.chunk.size() == width * packed.count;
    if (!possible || packed.count > most_numbers)
        throw RunError("the numbers of a stored member are not as many as stated; it was damaged");
    if (!packed.deflated()) return numbers_of(packed.chunk, false);
    return numbers_of(inflated(packed.chunk, width * packed.count), true);
}

PackedArray pack(const ArrayValues& array) {
    return {array.sizes, pack(std::span<const double>(array.values))};
}

ArrayValues unpack(const PackedArray& packed) {
    return {packed.sizes, unpack(packed.numbers)};
}

PackedArrays take_arrays(MemberResult& result) {
    PackedArrays arrays;
    for (std::size_t k = 0; k < array_outputs.size(); ++k) arrays[k] = pack(array_outputs[k].access.get(result));
    clear_arrays(result);
    return arrays;
}

}  // namespace floes
