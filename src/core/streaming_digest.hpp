#pragma once
// The digest of bytes that come in parts (XXH3): the same as digest_hex() of all of them.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace floes {

class StreamingDigest {
  public:
    StreamingDigest();
    ~StreamingDigest();
    StreamingDigest(StreamingDigest&&) noexcept;

    void add(std::span<const std::byte> bytes);
    /// The length (u64, little endian), then the text: two texts are not one.
    void add_text(std::string_view text);
    /// Of all bytes so far, as 32 hex digits.
    std::string hex() const;

  private:
    class State;
    std::unique_ptr<State> state_;
};

}  // namespace floes
