#include "core/digest.hpp"

#include <new>

#include <fmt/format.h>
#include <xxhash.h>

#include "core/bytes.hpp"

namespace floes {

std::uint64_t digest64(std::string_view text) {
    return XXH3_64bits(text.data(), text.size());
}

std::string digest_hex(std::string_view text) {
    StreamingDigest digest;
    digest.add(std::as_bytes(std::span(text)));
    return digest.hex();
}

class StreamingDigest::State {
  public:
    State() : state_(XXH3_createState()) {
        if (state_ == nullptr) throw std::bad_alloc();
        XXH3_128bits_reset(state_);
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() { XXH3_freeState(state_); }
    XXH3_state_t* get() const { return state_; }

  private:
    XXH3_state_t* state_;
};

StreamingDigest::StreamingDigest() : state_(std::make_unique<State>()) {}
StreamingDigest::~StreamingDigest() = default;
StreamingDigest::StreamingDigest(StreamingDigest&&) noexcept = default;

void StreamingDigest::add(std::span<const std::byte> bytes) {
    XXH3_128bits_update(state_->get(), bytes.data(), bytes.size());
}

void StreamingDigest::add_text(std::string_view text) {
    ByteWriter writer;
    writer.text(text);
    add(writer.bytes());
}

std::string StreamingDigest::hex() const {
    const XXH128_hash_t digest = XXH3_128bits_digest(state_->get());
    return fmt::format("{:016x}{:016x}", digest.high64, digest.low64);
}

}  // namespace floes
