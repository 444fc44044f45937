#pragma once
// Numbers as stored in the campaign file, compressed chunk by chunk. The rank that computes a member packs its own, so
// that the master only moves bytes, and a third fewer in messages, journal and file alike.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/bytes.hpp"
#include "member/array_output.hpp"

namespace floes {

inline constexpr int compression_level = 4;

/// Little-endian numbers as one chunk of HDF5's filters shuffle and deflate: the first byte of each, then the second …,
/// compressed by zlib. Small sets are left uncompressed, because starting zlib costs more than it saves.
struct PackedNumbers {
    std::uint64_t count = 0;  ///< of the numbers
    Bytes chunk;              ///< empty if there are no numbers

    bool deflated() const { return count >= 128; }
    friend bool operator==(const PackedNumbers&, const PackedNumbers&) = default;
};

/// The same numbers give the same bytes with the same zlib.
PackedNumbers pack(std::span<const double> numbers);

/// The numbers' bytes as the chunk has them before it is compressed: the first byte of each, then the second …
Bytes shuffled(std::span<const double> numbers);

/// The numbers bit for bit. Throws RunError if the chunk is damaged.
std::vector<double> unpack(const PackedNumbers& packed);

// A checksum of packed numbers that costs no unpacking.

/// Adler-32 of the numbers' bytes, shuffled as in a chunk: what zlib keeps at the end of a compressed chunk.
std::uint32_t checksum(const PackedNumbers& packed);
std::uint32_t checksum(std::span<const double> numbers);

// The arrays of a member as they travel and are stored: packed by the rank that computed it.

struct PackedArray {
    std::vector<std::size_t> sizes;  ///< one for each axis
    PackedNumbers numbers;

    bool empty() const { return numbers.count == 0; }
    friend bool operator==(const PackedArray&, const PackedArray&) = default;
};

/// One for each of array_outputs, in their order; empty where the member does not have the array.
using PackedArrays = std::array<PackedArray, array_outputs.size()>;

PackedArray pack(const ArrayValues& array);
/// Throws RunError if the numbers are damaged.
ArrayValues unpack(const PackedArray& packed);

/// Packs the arrays of the result and takes them out of it.
PackedArrays take_arrays(MemberResult& result);

}  // namespace floes
