#pragma once
// Values to bytes and back: little endian, doubles bit by bit, every length checked before use. Journal records and
// messages between ranks are made of these.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace floes {

using Bytes = std::vector<std::byte>;

/// Appends values to a byte buffer.
class ByteWriter {
  public:
    void u8(std::uint8_t value) { bytes_.push_back(std::byte{value}); }
    void u32(std::uint32_t value);
    void u64(std::uint64_t value);
    void i32(std::int32_t value) { u32(static_cast<std::uint32_t>(value)); }
    void f64(double value) { u64(std::bit_cast<std::uint64_t>(value)); }          ///< all 64 bits, NaN payload included
    void text(std::string_view value) { blob(std::as_bytes(std::span(value))); }  ///< length (u64), then the bytes
    void doubles(std::span<const double> values);                                 ///< count (u64), then the values
    void blob(std::span<const std::byte> value);                                  ///< length (u64), then the bytes

    std::span<const std::byte> bytes() const { return bytes_; }
    Bytes take() { return std::move(bytes_); }

  private:
    Bytes bytes_;
};

/// Reads values from the front of a byte buffer. Throws RunError if it ends too early; a wrong length never allocates
/// more than the bytes that exist.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

    std::uint8_t u8() { return std::to_integer<std::uint8_t>(take(1)[0]); }
    std::uint32_t u32();
    std::uint64_t u64();
    std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
    double f64() { return std::bit_cast<double>(u64()); }
    std::string text();
    std::vector<double> doubles();
    Bytes blob();
    /// A count of items of at least `bytes_each` bytes; throws if the rest of the buffer is too short for them.
    std::size_t count(std::size_t bytes_each);

    std::size_t left() const { return rest_.size(); }

  private:
    std::span<const std::byte> take(std::size_t size);

    std::span<const std::byte> rest_;
};

// Bytes as text, RFC 4648.

void write_base64(std::ostream& text, std::span<const std::byte> bytes);

}  // namespace floes
