#include "draw/page_parts.hpp"

#include <array>
#include <ostream>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace floes {

void expand(std::string_view pattern, const std::function<void(std::string_view)>& text,
            const std::function<void(std::string_view)>& name) {
    for (std::size_t at = 0;;) {
        const std::size_t open = pattern.find("{{", at);
        text(pattern.substr(at, open - at));
        if (open == std::string_view::npos) return;
        const std::size_t close = pattern.find("}}", open);
        name(pattern.substr(open + 2, close - open - 2));
        at = close + 2;
    }
}

std::string in_a_script(std::string text) {
    replace_all(text, "<", "\\u003c");  // as "</script" and "<!--" end or swallow what follows
    return text;
}

void write_stream(std::ostream& page, std::string_view id, std::span<const std::byte> bytes) {
    page << fmt::format("<script type=\"application/octet-stream\" id=\"{}\">", id);
    write_base64(page, bytes);
    page << "</script>\n";
}

Deflater::Deflater() {
    if (deflateInit(&state_, Z_DEFAULT_COMPRESSION) != Z_OK) throw RunError("zlib has no memory to compress with");
}

Deflater::~Deflater() {
    deflateEnd(&state_);
}

void Deflater::feed(std::span<const std::byte> bytes, int flush) {
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

void Deflater::add(std::span<const std::byte> bytes) {
    feed(bytes, Z_NO_FLUSH);
}

Bytes Deflater::finish() {
    feed({}, Z_FINISH);
    return std::move(packed_);
}

Bytes deflated(std::span<const std::byte> bytes) {
    Deflater all;
    all.add(bytes);
    return all.finish();
}

}  // namespace floes
