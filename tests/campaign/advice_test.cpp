// What is allowed but odd, and that what is usual is not.

#include "campaign/advice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "campaign/read.hpp"

namespace floes {
namespace advice_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> advice_for(const std::string& text) {
    return advice(read_campaign({text, "a.toml", {}, true}, nullptr));
}

TEST(Advice, HasNothingToSayOfTheDefaults) {
    EXPECT_THAT(advice_for(""), IsEmpty());
}

TEST(Advice, SaysWhatIsOdd) {
    const std::pair<const char*, const char*> odd[]{
        {"floe.element_m = 0.6", "case E60: floe.element_m = 0.6 is not below 0.377 m, the characteristic length"},
        {"floe.element_m = 0.02",
         "ice.thickness_m = 0.033 is more than floe.element_m = 0.02; elements that are thicker"},
        {"field.concentration_percent = 3", "field.concentration_percent = 3.0 leaves the field of 472.5 m almost"},
        {"ice.bending_strength_kPa = 0.5", "ice.bending_strength_kPa = 0.5 is unlike any ice"},
        {"ice.compressive_strength_kPa = 30", "ice is several times stronger in compression"},
        {"general.iterations = 1", "general.iterations = 1 leaves contacts unsolved"},
        {"general.time_step_s = 0.1", "structure.speed_m_s = 0.07 take the structure 0.007 m on in each step"},
    };
    for (const auto& [text, sentence] : odd) EXPECT_THAT(advice_for(text), ElementsAre(HasSubstr(sentence))) << text;
}

TEST(Advice, NamesTheOtherCasesOfOneOddity) {
    EXPECT_THAT(advice_for("general.iterations = 5\n[[case]]\nname = \"a\"\n[[case]]\nname = \"b\"\n"
                           "general.iterations = 20\n[[case]]\nname = \"c\"\n"),
                ElementsAre(testing::AllOf(HasSubstr("case a: general.iterations = 5"),
                                           testing::EndsWith("The same holds for c."))));
}

}  // namespace advice_test
}  // namespace floes
