#include "records/packed_checksum.hpp"

#include <zlib.h>

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

}  // namespace floes
