#pragma once
// A checksum of packed numbers that costs no unpacking.

#include <cstdint>
#include <span>

#include "records/packed_numbers.hpp"

namespace floes {

/// Adler-32 of the numbers' bytes, shuffled as in a chunk: what zlib keeps at the end of a compressed chunk.
std::uint32_t checksum(const PackedNumbers& packed);
std::uint32_t checksum(std::span<const double> numbers);

}  // namespace floes
