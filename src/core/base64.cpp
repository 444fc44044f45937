#include "core/base64.hpp"

#include <ostream>
#include <string>

namespace floes {

void write_base64(std::ostream& text, std::span<const std::byte> bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string block;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = bytes.size() - i;
        const auto byte = [&](std::size_t k) { return k < left ? std::to_integer<unsigned>(bytes[i + k]) : 0; };
        const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
        block += digits[three >> 18];
        block += digits[three >> 12 & 63];
        block += left > 1 ? digits[three >> 6 & 63] : '=';
        block += left > 2 ? digits[three & 63] : '=';
        if (block.size() < 1 << 16) continue;
        text << block;
        block.clear();
    }
    text << block;
}

}  // namespace floes
