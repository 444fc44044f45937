#pragma once
// Digests of text (XXH3): the same on every machine, so they may be stored in files and compared between ranks. Not
// cryptographic.

#include <cstdint>
#include <string>
#include <string_view>

namespace floes {

/// 64-bit digest, XXH3-64 with seed 0.
std::uint64_t digest64(std::string_view text);

/// 128-bit digest, XXH3-128 with seed 0, as 32 lower-case hex digits, most significant first.
std::string digest_hex(std::string_view text);

}  // namespace floes
