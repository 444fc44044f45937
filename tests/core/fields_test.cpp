#include "core/fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace floes {
namespace fields_test {

struct Part {
    std::string name;
    double size = 0;
    static constexpr auto fields() { return std::tuple(&Part::name, &Part::size); }
    friend bool operator==(const Part&, const Part&) = default;
};

struct Whole {
    int number = 0;
    bool good = false;
    std::array<std::size_t, 2> places{};
    std::vector<Part> parts;
    std::map<std::string, Part> named;
    Bytes bytes;
    static constexpr auto fields() {
        return std::tuple(&Whole::number, &Whole::good, &Whole::places, &Whole::parts, &Whole::named, &Whole::bytes);
    }
    friend bool operator==(const Whole&, const Whole&) = default;
};

TEST(Fields, ComeBackInTheirOrder) {
    const Whole whole{-3, true, {4, 5}, {{"a", 0.5}, {"", -1}}, {{"k", {"b", 2}}}, {std::byte{7}}};
    ByteWriter out;
    put(out, whole);
    ByteWriter by_hand;
    by_hand.i32(-3);
    by_hand.u8(1);
    EXPECT_TRUE(std::ranges::equal(out.bytes().first(5), by_hand.bytes()));
    ByteReader in(out.bytes());
    Whole same;
    take(in, same);
    EXPECT_EQ(same, whole);
    EXPECT_EQ(in.left(), 0u);
}

TEST(Fields, RefuseWhatCannotBe) {
    ByteWriter out;
    out.u64(std::uint64_t{1} << 60U);  // elements, none of which is there
    ByteReader in(out.bytes());
    std::vector<Part> parts;
    EXPECT_THROW(take(in, parts), RunError);
    const Bytes two{std::byte{2}};
    ByteReader neither(two);
    bool good = false;
    EXPECT_THROW(take(neither, good), RunError);
}

}  // namespace fields_test
}  // namespace floes
