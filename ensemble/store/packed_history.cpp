#include "store/packed_history.hpp"

#include <zlib.h>

#include <fmt/format.h>
#include <bit>

#include "core/error.hpp"

namespace floes {
namespace {

constexpr std::size_t width = sizeof(double);

Bytes shuffled(std::span<const double> numbers) {
    Bytes bytes(width * numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto bits = std::bit_cast<std::uint64_t>(numbers[i]);
        for (std::size_t k = 0; k < width; ++k) bytes[k * numbers.size() + i] = static_cast<std::byte>(bits >> (8 * k));
    }
    return bytes;
}

std::vector<double> unshuffled(const Bytes& bytes) {
    std::vector<double> numbers(bytes.size() / width);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < width; ++k)
            bits |= std::to_integer<std::uint64_t>(bytes[k * numbers.size() + i]) << (8 * k);
        numbers[i] = std::bit_cast<double>(bits);
    }
    return numbers;
}

}  // namespace

PackedNumbers pack(std::span<const double> numbers) {
    if (numbers.empty()) return {};
    const Bytes plain = shuffled(numbers);
    uLongf size = compressBound(plain.size());
    Bytes chunk(size);
    const int code = compress2(reinterpret_cast<Bytef*>(chunk.data()), &size,
                               reinterpret_cast<const Bytef*>(plain.data()), plain.size(), compression_level);
    if (code != Z_OK) throw RunError(fmt::format("zlib cannot compress a load history: {}.", zError(code)));
    chunk.resize(size);
    chunk.shrink_to_fit();  // it waits in a message
    return {numbers.size(), std::move(chunk)};
}

std::vector<double> unpack(const PackedNumbers& packed) {
    if (packed.count == 0) return {};
    // Deflate makes bytes 1032 times fewer at best, so a damaged count cannot ask for memory.
    constexpr std::uint64_t most_in_a_byte = 1032 / width + 1;
    uLongf size = width * packed.count;
    if (packed.count > most_in_a_byte * packed.chunk.size())
        throw RunError("a stored load history counts more numbers than it has room for; it was damaged");
    Bytes plain(size);
    const int code = uncompress(reinterpret_cast<Bytef*>(plain.data()), &size,
                                reinterpret_cast<const Bytef*>(packed.chunk.data()), packed.chunk.size());
    if (code != Z_OK || size != plain.size())
        throw RunError("a stored load history cannot be decompressed; it was damaged");
    return unshuffled(plain);
}

PackedHistory pack(const LoadHistory& history) {
    return {pack(history.surge), pack(history.sway), pack(history.heave)};
}

LoadHistory unpack(const PackedHistory& packed) {
    return {unpack(packed.surge), unpack(packed.sway), unpack(packed.heave)};
}

}  // namespace floes
