#include "core/hash.hpp"

#include <xxhash.h>

#include <span>

#include "core/streaming_digest.hpp"

namespace floes {

std::uint64_t digest64(std::string_view text) {
    return XXH3_64bits(text.data(), text.size());
}

std::string digest_hex(std::string_view text) {
    StreamingDigest digest;
    digest.add(std::as_bytes(std::span(text)));
    return digest.hex();
}

}  // namespace floes
