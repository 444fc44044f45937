#pragma once
// Numbers as stored in the campaign file, compressed chunk by chunk. The rank that computes a member packs its own, so
// that the master only moves bytes, and a third fewer in messages, journal and file alike.

#include <cstdint>
#include <span>
#include <vector>

#include "core/bytes.hpp"

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

}  // namespace floes
