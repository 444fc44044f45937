#include "core/digest.hpp"

#include <gtest/gtest.h>

#include <set>

namespace floes {
namespace hash_test {

// The values that the XXH3 specification publishes for the empty input with seed 0.
TEST(Hash, EmptyTextHasThePublishedDigest) {
    EXPECT_EQ(digest64(""), 0x2d06800538d394c2ull);
    EXPECT_EQ(digest_hex(""), "99aa06d3014798d86001c324468d497f");
}

TEST(Hash, DigestIsThirtyTwoHexDigits) {
    for (int length = 0; length < 300; ++length) {
        const std::string digest = digest_hex(std::string(static_cast<std::size_t>(length), 'x'));
        EXPECT_EQ(digest.size(), 32u);
        EXPECT_EQ(digest.find_first_not_of("0123456789abcdef"), std::string::npos);
    }
}

TEST(Hash, OneCharacterChangesTheDigest) {
    std::set<std::string> digests;
    std::set<std::uint64_t> short_digests;
    const std::string text = "ice.thickness_m = 0.033";
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::string changed = text;
        changed[i] = '#';
        digests.insert(digest_hex(changed));
        short_digests.insert(digest64(changed));
    }
    digests.insert(digest_hex(text));
    EXPECT_EQ(digests.size(), text.size() + 1);
    EXPECT_EQ(short_digests.size(), text.size());
}

}  // namespace hash_test
}  // namespace floes
