// Packed numbers: a count, and a chunk that is said to hold so many.

#include <cstring>

#include "fuzz/fuzz.hpp"
#include "store/packed_arrays.hpp"

namespace {

void require_same_bits(const std::vector<double>& one, const std::vector<double>& other) {
    floes::fuzz::require(one.size() == other.size(), "packing changed the count");
    if (one.empty()) return;
    floes::fuzz::require(std::memcmp(one.data(), other.data(), one.size() * sizeof(double)) == 0,
                         "packing changed a number");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    floes::ByteReader in(floes::fuzz::as_bytes(data, size));
    if (in.left() < sizeof(std::uint64_t)) return 0;
    floes::PackedNumbers packed{in.u64(), {}};
    const auto rest = floes::fuzz::as_bytes(data, size).subspan(sizeof(std::uint64_t));
    packed.chunk.assign(rest.begin(), rest.end());
    const auto numbers = floes::fuzz::taken([&] { return floes::unpack(packed); });
    if (numbers) {
        floes::fuzz::require(numbers->size() == packed.count, "there are more or fewer numbers than were stated");
        require_same_bits(floes::unpack(floes::pack(*numbers)), *numbers);
    }
    std::vector<double> plain(rest.size() / sizeof(double));
    if (!plain.empty()) std::memcpy(plain.data(), rest.data(), plain.size() * sizeof(double));
    require_same_bits(floes::unpack(floes::pack(plain)), plain);
    return 0;
}
