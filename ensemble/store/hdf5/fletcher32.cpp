#include "hdf5/fletcher32.hpp"

#include <algorithm>
#include <span>

namespace floes::hdf5 {
namespace {

std::uint32_t folded(std::uint32_t sum) {
    return (sum & 0xffff) + (sum >> 16);
}

}  // namespace

void append_fletcher32(Bytes& chunk) {
    constexpr std::size_t most = 360;  // words that can be added before the sums have to be reduced
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    const auto word = [&](std::size_t at) {  // big endian; an odd last byte is the high one
        const auto first = std::to_integer<std::uint32_t>(chunk[at]);
        return first << 8 | (at + 1 < chunk.size() ? std::to_integer<std::uint32_t>(chunk[at + 1]) : 0);
    };
    for (std::size_t at = 0; at < chunk.size();) {
        for (const std::size_t end = std::min(at + 2 * most, chunk.size()); at < end; at += 2) {
            low += word(at);
            high += low;
        }
        low = folded(low);
        high = folded(high);
    }
    ByteWriter sum;
    sum.u32(folded(high) << 16 | folded(low));
    chunk.insert(chunk.end(), sum.bytes().begin(), sum.bytes().end());
}

}  // namespace floes::hdf5
