// Texts that would take more time, stack or memory than there is: most were found by fuzzing.

#include "keys/document.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <ctime>

#include "keys/key.hpp"
#include "keys/meant.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace text_limits_test {

using testing::HasSubstr;

std::string repeated(const std::string& text, std::size_t times) {
    std::string all;
    for (std::size_t k = 0; k < times; ++k) all += text;
    return all;
}

std::string refused(const std::string& text) {
    return refusal([&] { parse_document(text, "a.toml"); });
}

// toml++ takes tables apart by recursion: the stack was not deep enough.
TEST(TextLimits, AKeyOfManyPartsIsRefused) {
    const std::string key = repeated("a.", 100'000) + "a";
    const std::string sentence =
        "a.toml: a key with 100001 parts between dots is none of floes; ours have three at most";
    EXPECT_EQ(refused(key + " = 1"), sentence);
    EXPECT_EQ(refused("[" + key + "]"), sentence);
    EXPECT_EQ(refused("x = {" + key + " = 1}"), sentence);
    EXPECT_EQ(refused("x = \"a \\\" # b\" # c\n" + key + " = 1"), sentence);
    EXPECT_EQ(refused("x = {y = \"\"\"a\"\"\"\", " + key + " = 1}"), sentence) << "a quote just before the end";
    EXPECT_EQ(refused("x = {y = '''\n''', " + key + " = 1}"), sentence);
    EXPECT_THAT(refusal([&] { parse_override("ice.thickness_m={" + key + "=1}", "--set"); }),
                HasSubstr("--set ice.thickness_m: a key with 100001 parts"));
}

TEST(TextLimits, DotsOfTextsAndCommentsAreNotThoseOfKeys) {
    const std::string dots(100, '.');
    for (const std::string& text :
         std::vector<std::string>{"# " + dots, "x = \"" + dots + "\"", "x = '" + dots + "'",
                                  "x = \"\"\"\n" + dots + "\n\"\"\"", "x = [0.1, 0.2]\na.b.c = 0.1"})
        EXPECT_NO_THROW(parse_document(text, "a.toml")) << text;
}

// U+FEF7 and its neighbours outside texts and comments: toml++ ran into what its authors took for unreachable.
TEST(TextLimits, CharactersBeyondAsciiAreForTextsAndComments) {
    for (const char* value :
         {"\xEF\xBB\xB7", "\"\"\"a \\\xEF\xBB\xB7\"\"\"", "30e2\"\xC3\xA8\"", "39--inf'\xEF\xBB\xBE'",
          "24\"\"\"\"\"ons='21at\xEF\xBB\xBEs=11", "03['\xEF\xAF\xBB;''[", "{\xEF\xBB\xB7 = 1}"})
        EXPECT_THAT(refused(fmt::format("\nx = {}", value)),
                    testing::MatchesRegex("a.toml:2:[0-9]+: this is not TOML .*"))
            << value;
    EXPECT_NO_THROW(
        parse_document("x = [ \"\xC3\xA8\",\n'\xC3\xA8']\ny = {z =\t'\xC3\xA8'}\r\n'\xC3\xA8' = 1", "a.toml"));
    EXPECT_EQ(parse_override("campaign.name=\xEF\xBB\xB7", "--set").value, Value{"\xEF\xBB\xB7"}) << "a word";
    EXPECT_NO_THROW(parse_document("\xEF\xBB\xBFx = \"\xEF\xBB\xB7\" # \xEF\xBB\xB7\n\"Σ\" = 'σ'", "a.toml"));
}

TEST(TextLimits, MoreThanCanBeHeldIsRefused) {
    EXPECT_THAT(refused(std::string(longest_text + 1, '\n')), HasSubstr("is too long; allowed: 67108864 bytes"));
    EXPECT_THAT(refused("x = [" + std::string(4'000'001, ',') + "]"),
                HasSubstr("4000001 lines and commas has more values than can be held; allowed: 4000000"));
}

TEST(TextLimits, ALongKeyIsRefusedAndNotRepeated) {
    const std::string key(1'000'000, 'a');
    EXPECT_EQ(refused("\n" + key + " = 1"),
              "a.toml:2: \"aaaaaaaaaaaaaaaaaaaa\"... is a key of more than 200 characters, and none of floes");
    EXPECT_EQ(refusal([&] { parse_override(key + "=1", "--set"); }),
              "--set: \"aaaaaaaaaaaaaaaaaaaa\"... is a key of more than 200 characters, and none of floes");
}

TEST(TextLimits, LongTextsAreCutShortInMessages) {
    EXPECT_EQ(to_text({std::string(200, 'a')}).size(), 202u);
    EXPECT_EQ(to_text({std::string(201, 'a')}), "\"" + std::string(60, 'a') + "\"...");
    EXPECT_EQ(to_text({"a" + repeated("Σ", 200)}), "\"a" + repeated("Σ", 29) + "\"...") << "no letter cut apart";
    EXPECT_EQ(refused("\"a" + repeated("Σ", 200) + "\" = 1"),
              "a.toml:1: \"a" + repeated("Σ", 9) + "\"... is a key of more than 200 characters, and none of floes");
}

// Before, a name of a megabyte took half a minute.
TEST(TextLimits, LongWordsAreComparedByTheirBeginning) {
    const std::clock_t begin = std::clock();  // of the processor
    EXPECT_EQ(edit_distance(std::string(10'000'000, 'a'), "ab"), 199u);
    EXPECT_LT(std::clock() - begin, 5 * CLOCKS_PER_SEC);
}

// Its resolved configuration could not be read again.
TEST(TextLimits, AnOverrideThatIsNotUtf8IsRefused) {
    EXPECT_EQ(refusal([] { parse_override("campaign.name=\xff", "--set"); }),
              "--set: this is not text in UTF-8, as configurations are");
    EXPECT_EQ(refusal([] { parse_override("\xff=word", "--set"); }),
              "--set: this is not text in UTF-8, as configurations are");
    EXPECT_EQ(parse_override("campaign.name=Σ\n", "--set").value, Value{"Σ\n"});
}

TEST(Keys, PresetsAreReadFirstAndPartsLast) {
    double number = 0;
    const Keys keys{preset_key(number_key("b", number, 1, {}, "", "")), number_key("a", number, 1, {}, "", ""),
                    part_key(number_key("c", number, 1, {}, "", ""))};
    std::vector<Entry> entries;
    for (const char* path : {"c", "x", "a", "b", "y", "c", "b"}) entries.push_back({path, {true}, ""});
    std::string order;
    for (const Entry& entry : in_order_of_reading(keys, entries)) order += entry.path;
    EXPECT_EQ(order, "bbxaycc");
}

}  // namespace text_limits_test
}  // namespace floes
