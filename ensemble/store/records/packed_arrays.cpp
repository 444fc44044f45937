#include "records/packed_arrays.hpp"

namespace floes {

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
