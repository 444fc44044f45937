#include "player/deflater.hpp"

#include <zlib.h>

#include <array>

#include "core/error.hpp"

namespace floes {

class Deflater::Stream {
  public:
    Stream() {
        if (deflateInit(&state_, Z_DEFAULT_COMPRESSION) != Z_OK) throw RunError("zlib has no memory to compress with");
    }
    ~Stream() { deflateEnd(&state_); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    void feed(std::span<const std::byte> bytes, int flush) {
        // zlib's interface takes a pointer to what it only reads.
        state_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data()));
        state_.avail_in = static_cast<uInt>(bytes.size());
        std::array<std::byte, 1 << 16> room;
        do {
            state_.next_out = reinterpret_cast<Bytef*>(room.data());
            state_.avail_out = static_cast<uInt>(room.size());
            deflate(&state_, flush);
            packed_.insert(packed_.end(), room.begin(), room.end() - state_.avail_out);
        } while (state_.avail_out == 0);
    }

    Bytes& packed() { return packed_; }

  private:
    z_stream state_{};
    Bytes packed_;
};

Deflater::Deflater() : stream_(std::make_unique<Stream>()) {}
Deflater::~Deflater() = default;
Deflater::Deflater(Deflater&&) noexcept = default;

void Deflater::add(std::span<const std::byte> bytes) {
    stream_->feed(bytes, Z_NO_FLUSH);
}

std::size_t Deflater::size() const {
    return stream_->packed().size();
}

Bytes Deflater::finish() {
    stream_->feed({}, Z_FINISH);
    return std::move(stream_->packed());
}

}  // namespace floes
