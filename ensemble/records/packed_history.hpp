#pragma once
// Load histories as the campaign file holds them, compressed chunk by chunk. The rank that computes a member packs its
// histories, so that whoever keeps them only moves bytes: a third less of them, in messages, journal and file alike.

#include <cstdint>
#include <span>
#include <vector>

#include "core/bytes.hpp"
#include "simulation/load_history.hpp"

namespace floes {

inline constexpr int compression_level = 4;

/// Numbers, little endian, as one chunk of HDF5's filters shuffle and deflate: first the first byte of each, then the
/// second …, and that as a zlib stream. A few are left as they are: zlib's start costs more than there is to save.
struct PackedNumbers {
    std::uint64_t count = 0;  ///< of the numbers
    Bytes chunk;              ///< empty when there are none

    bool deflated() const { return count >= 128; }
    friend bool operator==(const PackedNumbers&, const PackedNumbers&) = default;
};

/// The same numbers give the same bytes with the same zlib.
PackedNumbers pack(std::span<const double> numbers);

/// The numbers bit for bit. Throws RunError when the chunk is damaged.
std::vector<double> unpack(const PackedNumbers& packed);

struct PackedHistory {
    PackedNumbers surge;
    PackedNumbers sway;
    PackedNumbers heave;
    friend bool operator==(const PackedHistory&, const PackedHistory&) = default;
};

PackedHistory pack(const LoadHistory& history);
LoadHistory unpack(const PackedHistory& packed);

}  // namespace floes
