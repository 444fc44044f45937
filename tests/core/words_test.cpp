#include "core/words.hpp"

#include <gtest/gtest.h>

namespace floes {
namespace words_test {

Words towed(double speed) {
    return Words::of("towed at {:.4g} m/s", speed);
}

std::string ranges(const std::vector<Words>& all) {
    const std::optional<Words> found = Words::with_ranges(all);
    return found ? found->text() : "none";
}

TEST(Words, AreWhatFormatMakesOfThem) {
    EXPECT_EQ(Words::of("{} of {:.2f} m, {}", 3, 0.5, "thick").text(), "3 of 0.50 m, thick");
    EXPECT_EQ((Words("it is ") + towed(0.2) + ".").text(), "it is towed at 0.2 m/s.");
    EXPECT_EQ(
        Words::of("{}; {}", Words::counted(1, "floe"), Words::joined({Words::counted(2, "line"), "a turret"}, ", "))
            .text(),
        "1 floe; 2 lines, a turret");
}

TEST(Words, ThatDifferInNumbersOnlyAreOneWithTheirRanges) {
    EXPECT_EQ(ranges({towed(0.2), towed(0.05), towed(0.1)}), "towed at 0.05 to 0.2 m/s");
    EXPECT_EQ(ranges({towed(12000), towed(-0.5)}), "towed at -0.5 to 1.2e+04 m/s");
    EXPECT_EQ(ranges({towed(0.1), towed(0.10000001)}), "towed at 0.1 m/s");
    EXPECT_EQ(ranges({towed(0.2), "led along a path"}), "none");
    EXPECT_EQ(ranges({"preset p1", "preset p2"}), "none");
    EXPECT_EQ(ranges({Words::counted(1, "floe"), Words::counted(2, "floe")}), "none");
    EXPECT_EQ(ranges({}), "none");
}

}  // namespace words_test
}  // namespace floes
