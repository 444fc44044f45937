#pragma once
// Compresses a stream of bytes while it is made (zlib's format, which browsers inflate without further code).

#include <cstddef>
#include <memory>
#include <span>

#include "core/bytes.hpp"

namespace floes {

class Deflater {
  public:
    Deflater();
    ~Deflater();
    Deflater(Deflater&&) noexcept;

    void add(std::span<const std::byte> bytes);
    /// Of the compressed bytes so far; those that zlib still holds back are not counted.
    std::size_t size() const;
    /// All compressed bytes. The last call.
    Bytes finish();

  private:
    class Stream;
    std::unique_ptr<Stream> stream_;
};

}  // namespace floes
