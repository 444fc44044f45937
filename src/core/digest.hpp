#pragma once
// Digests of text (XXH3): the same on every machine, so they may be stored in files and compared between ranks. Not
// cryptographic.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace floes {

/// 64-bit digest, XXH3-64 with seed 0.
std::uint64_t digest64(std::string_view text);

/// 128-bit digest, XXH3-128 with seed 0, as 32 lower-case hex digits, most significant first.
std::string digest_hex(std::string_view text);

// The digest of bytes that come in parts (XXH3): the same as digest_hex() of all of them.

class StreamingDigest {
  public:
    StreamingDigest();
    ~StreamingDigest();
    StreamingDigest(StreamingDigest&&) noexcept;

    void add(std::span<const std::byte> bytes);
    /// The length (u64, little endian), then the text: two texts are not one.
    void add_text(std::string_view text);
    /// The digest of all bytes so far, as 32 hex digits.
    std::string hex() const;

  private:
    class State;
    std::unique_ptr<State> state_;
};

}  // namespace floes
