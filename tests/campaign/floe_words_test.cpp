#include "campaign/advice.hpp"

#include <gtest/gtest.h>

#include "campaign/read.hpp"

namespace floes {
namespace floe_words_test {

std::vector<std::string> words(const std::string& text) {
    return floe_words(read_campaign({text, "a.toml", {}, true}, nullptr));
}

TEST(FloeWords, SayNothingOfFloesThatAreAlike) {
    EXPECT_EQ(words("field.floes = 189\n"), std::vector<std::string>{});
}

TEST(FloeWords, SayWhatAListCameTo) {
    // 126 x 0.16 m² + 63 x 0.64 m² = 60.48 m², of 0.75 x 4.8 m.
    EXPECT_EQ(words("[sizes]\nlaw = \"list\"\nlist_m = [[0.4, 0.4, 66.6667], [0.8, 0.8, 33.3333]]\n"),
              std::vector<std::string>{
                  "case E60: 189 floes, sides of their squares 0.4 to 0.8 m, mean 0.5333 m, half of the area in floes "
                  "of 0.8 m and more; 0.4 m x 0.4 m: 66.7 % of the floes, 33.3 % of the area; 0.8 m x 0.8 m: 33.3 % of "
                  "the floes, 66.7 % of the area; 1512 elements of 0.2 m; the field is 16.8 m long."});
}

TEST(FloeWords, SayWhatTheBrineGives) {
    EXPECT_EQ(words("[brine]\nsalinity_ppt = 5.0\n"),
              std::vector<std::string>{"case E60: all floes have 461.4 kPa in bending and 8180 MPa."});
}

TEST(FloeWords, SayACaseOnceAndWhatWasDrawn) {
    const auto found = words(
        "[spread]\nthickness = \"uniform\"\nthickness_cov = 0.1\n[[case]]\nname = \"a\"\n[[case]]\nname = \"b\"\n");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].starts_with("case a: in arrangement 0 the floes have on average thickness 0.03")) << found[0];
    EXPECT_EQ(found[0].find("strength"), std::string::npos);
}

// Bad input ends in a sentence with file, line and key.
TEST(FloeWords, AreNotReachedByBadInput) {
    const auto refusal = [](const std::string& text) -> std::string {
        try {
            words(text);
        } catch (const std::exception& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_EQ(refusal("[sizes]\nlaw = \"list\"\nlist_m = [[0.4, 0.4, 60.0], [0.8, 0.8, 33.0]]\n"),
              "a.toml:3: the shares of sizes.list_m sum to 93 %; they are to sum to 100 %");
    EXPECT_EQ(refusal("[sizes]\nexponent = 2.0\n"),
              "a.toml:2: sizes.exponent = 2.0 has no effect: it needs sizes.law = \"power_law\". Add that, or leave "
              "sizes.exponent out.");
    EXPECT_EQ(refusal("[spread]\nstrength = \"normal\"\nstrength_within = [2.0, 1.0]\n"),
              "a.toml:3: spread.strength_within = [2.0, 1.0] is not two rising factors, such as [0.5, 2.0]");
}

}  // namespace floe_words_test
}  // namespace floes
