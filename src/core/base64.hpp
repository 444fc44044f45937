#pragma once
// Bytes as text, RFC 4648.

#include <cstddef>
#include <iosfwd>
#include <span>

namespace floes {

void write_base64(std::ostream& text, std::span<const std::byte> bytes);

}  // namespace floes
