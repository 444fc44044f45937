#include "core/random.hpp"

#include <Random123/philox.h>

#include "core/contract.hpp"

namespace floes {

namespace {

std::uint32_t low_word(std::uint64_t value) {
    return static_cast<std::uint32_t>(value);
}
std::uint32_t high_word(std::uint64_t value) {
    return static_cast<std::uint32_t>(value >> 32);
}
std::uint64_t join(std::uint32_t low, std::uint32_t high) {
    return low | static_cast<std::uint64_t>(high) << 32;
}

}  // namespace

PhiloxCounter philox(const PhiloxCounter& counter, const PhiloxKey& key) {
    const r123::Philox4x32_R<10>::ctr_type words =
        r123::Philox4x32_R<10>{}({{counter[0], counter[1], counter[2], counter[3]}}, {{key[0], key[1]}});
    return {words[0], words[1], words[2], words[3]};
}

RandomStream::RandomStream(std::uint64_t seed, std::uint32_t arrangement, StreamId stream, std::uint64_t geometry)
    : key_{}, arrangement_(arrangement), stream_(static_cast<std::uint32_t>(stream)) {
    const PhiloxCounter derived =
        philox({arrangement_, stream_, low_word(geometry), high_word(geometry)}, {low_word(seed), high_word(seed)});
    key_ = {derived[0], derived[1]};
}

void RandomStream::refill() {
    const std::uint64_t first_block = draws_ / 2;
    for (std::uint64_t i = 0; i < words_.size() / 2; ++i) {
        const std::uint64_t block = first_block + i;
        const PhiloxCounter words = philox({low_word(block), high_word(block), arrangement_, stream_}, key_);
        words_[2 * i] = join(words[0], words[1]);
        words_[2 * i + 1] = join(words[2], words[3]);
    }
}

std::uint32_t RandomStream::below(std::uint32_t n) {
    FLOES_EXPECTS(n >= 1);
    std::uint64_t product = (next() >> 32) * n;
    if (low_word(product) < n) {
        const std::uint32_t surplus = -n % n;  // 2^32 mod n: this many low words would favour small results
        while (low_word(product) < surplus) product = (next() >> 32) * n;
    }
    return high_word(product);
}

}  // namespace floes
