#include "core/hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

namespace floes {

std::uint64_t digest64(std::string_view text) {
    return XXH3_64bits(text.data(), text.size());
}

std::string digest_hex(std::string_view text) {
    const XXH128_hash_t digest = XXH3_128bits(text.data(), text.size());
    return fmt::format("{:016x}{:016x}", digest.high64, digest.low64);
}

}  // namespace floes
