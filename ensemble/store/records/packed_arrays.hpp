#pragma once
// The arrays of a member as they travel and are stored: packed by the rank that computed it.

#include <cstddef>
#include <vector>

#include "member/array_output.hpp"
#include "records/packed_numbers.hpp"

namespace floes {

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
