#include "core/digest.hpp"

#include <gtest/gtest.h>

#include "core/text.hpp"

namespace floes {
namespace streaming_digest_test {

TEST(StreamingDigest, IsThatOfAllBytes) {
    const std::string text(1000, 'x');
    StreamingDigest digest;
    digest.add(std::as_bytes(std::span(text).first(7)));
    digest.add(std::as_bytes(std::span(text).subspan(7)));
    EXPECT_EQ(digest.hex(), digest_hex(text));
    StreamingDigest two;
    two.add_text("ab");
    two.add_text("c");
    StreamingDigest others;
    others.add_text("a");
    others.add_text("bc");
    EXPECT_NE(two.hex(), others.hex());
}

TEST(Utf8, IsToldFromOtherBytes) {
    for (const char* good : {"", "floe", "Σ ≤ 10 m/s", "\xf0\x9f\xa7\x8a"}) EXPECT_TRUE(is_utf8(good)) << good;
    for (const char* bad : {"\xff", "a\x80", "\xc3", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80"})
        EXPECT_FALSE(is_utf8(bad));
}

TEST(Utf8, IsCutBetweenLetters) {
    const std::string text = "aΣ🧊b";  // of 1, 2, 4 and 1 bytes
    const std::size_t ends[]{0, 1, 1, 3, 3, 3, 3, 7, 8, 8};
    for (std::size_t most = 0; most < std::size(ends); ++most)
        EXPECT_EQ(beginning(text, most), text.substr(0, ends[most])) << most;
    EXPECT_EQ(beginning("\x80\x80\x80\x80\x80\x80", 5).size(), 5u) << "not UTF-8: anywhere";
}

}  // namespace streaming_digest_test
}  // namespace floes
