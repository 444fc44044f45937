#pragma once
// What the pages with scripts are made of: templates and scripts of page_assets/, numbers as compressed streams, JSON.
// A page asks nothing of the network. For this module and its tests.

#include <zlib.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/bytes.hpp"

namespace floes {

/// The content of the file of page_assets/ with this name, of three.js (three.min.js) or of D3 (d3.min.js), as it was
/// when the program was built; nothing if there is none.
std::optional<std::string_view> asset(std::string_view name);

/// Two or four bytes, little endian.
template <typename Number>
void put(Bytes& bytes, Number value) {
    using Bits = std::conditional_t<sizeof(Number) == 2, std::uint16_t, std::uint32_t>;
    const auto bits = std::bit_cast<Bits>(value);
    for (std::size_t k = 0; k < sizeof(Number); ++k) bytes.push_back(static_cast<std::byte>(bits >> (8 * k)));
}

/// Calls `text` for each part of a template and `name` for each {{name}} in it.
void expand(std::string_view pattern, const std::function<void(std::string_view)>& text,
            const std::function<void(std::string_view)>& name);

/// JSON that may stand in a script element.
std::string in_a_script(std::string text);

/// A script element of that id with the bytes in base64; page_assets/streams.js reads it.
void write_stream(std::ostream& page, std::string_view id, std::span<const std::byte> bytes);

/// Compresses a stream of bytes while it is made (zlib's format, which browsers inflate without further code).
class Deflater {
  public:
    Deflater();
    ~Deflater();
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;

    void add(std::span<const std::byte> bytes);
    /// Counts the compressed bytes so far; those that zlib still holds back are not counted.
    std::size_t size() const { return packed_.size(); }
    /// All compressed bytes. The last call.
    Bytes finish();

  private:
    void feed(std::span<const std::byte> bytes, int flush);

    z_stream state_{};
    Bytes packed_;
};

/// Bytes that are all there, compressed.
Bytes deflated(std::span<const std::byte> bytes);

}  // namespace floes
