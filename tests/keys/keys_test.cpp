#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/error.hpp"
#include "keys/key.hpp"
#include "keys/meant.hpp"
#include "keys/read.hpp"
#include "keys/write.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace keys_test {

enum class Colour { blue, white };

/// One field of each kind.
struct Sample {
    double thickness = 0.033;
    double strength = 36.4e3;
    int count = 3;
    bool wet = true;
    Colour colour = Colour::white;
    std::string label = "a \"b\"";
    std::vector<double> levels{20e3, 50e3};
    std::vector<std::vector<double>> points{{-0.443, 0.171}, {0.122, 0.736}};
};

Keys describe(Sample& sample) {
    Keys keys;
    keys.push_back(
        number_key("ice.thickness_m", sample.thickness, unit::one, above(0).at_most(10), "Table 1", "Thickness."));
    keys.push_back(
        number_key("ice.strength_kPa", sample.strength, unit::kilopascal, at_least(0), "Table 1", "Strength."));
    keys.push_back(numbers_key("ice.levels_kPa", sample.levels, unit::kilopascal, at_least(0), "none", "Levels."));
    keys.push_back(integer_key("floe.count", sample.count, 1, 10, "none", "Number."));
    keys.push_back(switch_key("floe.wet", sample.wet, "none", "Wet or dry."));
    keys.push_back(word_key("floe.colour", sample.colour, {"blue", "white"}, "none", "Colour."));
    keys.push_back(text_key("floe.label", sample.label, "none", "Label."));
    keys.push_back({"floe.points_m",
                    RowsField{{{"height_m", unit::one, at_least(-1)}, {"radius_m", unit::one, at_least(0)}},
                              [&sample] { return sample.points; },
                              [&sample](const auto& rows) { sample.points = rows; }},
                    "none", "Points."});
    return keys;
}

void read(Sample& sample, const std::string& text) {
    const Keys keys = describe(sample);
    for (const Entry& entry : parse_document(text, "a.toml").entries) assign_known(keys, entry);
}

std::string message(const std::string& text) {
    Sample sample;
    return refusal_or("accepted", [&] { read(sample, text); });
}

TEST(Keys, WriteThenReadGivesEqualFields) {
    Sample written;
    written.thickness = 0.1 + 0.2;
    written.strength = 12345.678901234567 * 1e3;
    written.count = 7;
    written.wet = false;
    written.colour = Colour::blue;
    written.label = "tab\t, \\ and \"quotes\"";
    written.levels = {0.1e3, 1e3 / 3.0};
    written.points.assign(9, {1.0 / 3.0, 2.0 / 3.0});  // long enough to be broken into lines
    for (const Comments comments : {Comments::none, Comments::all}) {
        Sample read_back;
        read(read_back, write_tables(describe(written), {{"ice", "Ice."}}, comments));
        EXPECT_EQ(canonical_text(describe(read_back)), canonical_text(describe(written)));
        EXPECT_EQ(read_back.points, written.points);
        EXPECT_EQ(read_back.levels, written.levels);
        EXPECT_EQ(read_back.label, written.label);
    }
}

TEST(Keys, UnitIsAppliedBothWays) {
    Sample sample;
    read(sample, "[ice]\nstrength_kPa = 72.8\n");
    EXPECT_DOUBLE_EQ(sample.strength, 72800.0);
    EXPECT_EQ(literal(describe(sample)[1]), "72.8");
    EXPECT_EQ(exact_text(describe(sample)[1]), "72800.0");
}

TEST(Keys, WholeNumbersServeAsNumbers) {
    Sample sample;
    read(sample, "ice.thickness_m = 1\n");
    EXPECT_EQ(sample.thickness, 1.0);
}

TEST(Keys, EmptyKnownTableIsHarmless) {
    EXPECT_EQ(message("[ice]\n"), "accepted");
}

TEST(Keys, EveryMessageIsOneSentence) {
    const std::pair<const char*, const char*> cases[] = {
        {"\n\n[ice]\nthicknes_m = 0.03\n",
         "a.toml:4: ice.thicknes_m = 0.03 is not a key; did you mean ice.thickness_m?"},
        {"thickness_m = 0.03\n", "a.toml:1: thickness_m = 0.03 is not a key; did you mean ice.thickness_m?"},
        {"[floe]\nstrength_kPa = 1.0\n",
         "a.toml:2: floe.strength_kPa = 1.0 is not a key; did you mean ice.strength_kPa?"},
        {"ice.strength = 1.0\n", "a.toml:1: ice.strength = 1.0 is not a key; did you mean ice.strength_kPa?"},
        {"floe.strength = 1.0\n", "a.toml:1: floe.strength = 1.0 is not a key; did you mean ice.strength_kPa?"},
        {"[icee]\n", "a.toml:1: [icee] is not a table of keys; did you mean [ice]?"},
        {"ice = 3\n", "a.toml:1: ice = 3 is a table of keys, not a key; write [ice] with its keys below"},
        {"ice.thickness_m = \"thin\"\n",
         "a.toml:1: ice.thickness_m = \"thin\" is not a number; allowed: above 0 and at most 10"},
        {"ice.thickness_m = 1979-05-27\n",
         "a.toml:1: ice.thickness_m = a date or time is not a number; allowed: above 0 and at most 10"},
        {"ice.thickness_m = 0.0\n", "a.toml:1: ice.thickness_m = 0.0 is out of range; allowed: above 0 and at most 10"},
        {"ice.thickness_m = 10.5\n",
         "a.toml:1: ice.thickness_m = 10.5 is out of range; allowed: above 0 and at most 10"},
        {"ice.thickness_m = nan\n", "a.toml:1: ice.thickness_m = nan is out of range; allowed: above 0 and at most 10"},
        {"ice.strength_kPa = inf\n", "a.toml:1: ice.strength_kPa = inf is out of range; allowed: at least 0"},
        {"ice.strength_kPa = 1e308\n", "a.toml:1: ice.strength_kPa = 1e+308 is out of range; allowed: at least 0"},
        {"floe.count = 2.0\n",
         "a.toml:1: floe.count = 2.0 is not a whole number; allowed: a whole number from 1 to 10"},
        {"floe.count = 11\n", "a.toml:1: floe.count = 11 is out of range; allowed: a whole number from 1 to 10"},
        {"floe.wet = 1\n", "a.toml:1: floe.wet = 1 is neither true nor false; allowed: true or false"},
        {"floe.colour = \"whit\"\n",
         "a.toml:1: floe.colour = \"whit\" is not a word of this key; allowed: \"blue\" or \"white\"; did you mean "
         "\"white\"?"},
        {"floe.colour = \"transparent\"\n",
         "a.toml:1: floe.colour = \"transparent\" is not a word of this key; allowed: \"blue\" or \"white\" (Colour)"},
        {"floe.colour = true\n",
         "a.toml:1: floe.colour = true is not a word in quotes; allowed: \"blue\" or \"white\""},
        {"floe.label = 5\n", "a.toml:1: floe.label = 5 is not text; allowed: text in quotes"},
        {"ice.levels_kPa = 5\n",
         "a.toml:1: ice.levels_kPa = 5 is not a list; allowed: a list of numbers, each at least 0"},
        {"ice.levels_kPa = [5, \"a\"]\n",
         "a.toml:1: ice.levels_kPa = [5, \"a\"] has \"a\", which is not a number; allowed: a list of numbers, each at "
         "least 0"},
        {"ice.levels_kPa = [5, -1]\n",
         "a.toml:1: ice.levels_kPa = [5, -1] has -1, out of range; allowed: a list of numbers, each at least 0"},
        {"floe.points_m = 5\n",
         "a.toml:1: floe.points_m = 5 is not a list; allowed: a list of [height_m, radius_m], height_m at least -1, "
         "radius_m at "
         "least 0"},
        {"floe.points_m = [[0.0, 1.0], [1.0]]\n",
         "a.toml:1: floe.points_m[1] = [1.0] is not a row of 2 numbers; allowed: a list of [height_m, radius_m], "
         "height_m at "
         "least -1, radius_m at least 0"},
        {"floe.points_m = [[0.0, \"a\"]]\n",
         "a.toml:1: floe.points_m[0] = [0.0, \"a\"] has a radius_m that is not a number; allowed: a list of [height_m, "
         "radius_m], height_m at least -1, radius_m at least 0"},
        {"floe.points_m = [[-2, 1]]\n",
         "a.toml:1: floe.points_m[0] = [-2, 1] has a height_m out of range; allowed: a list of [height_m, radius_m], "
         "height_m "
         "at least -1, radius_m at least 0"},
        {"[ice]\nthickness_m = 1.0\nstrength_kPa = 2.0\nthickness_m = 3.0\n",
         "a.toml:4: ice.thickness_m is given twice, first at a.toml:2; keep one"},
        {"ice.thickness_m = 1.0\nice.thickness_m = 3.0\n",
         "a.toml:2: ice.thickness_m is given twice, first at a.toml:1; keep one"},
        {"[ice]\nthickness_m = 1.0\n[ice]\n", "a.toml:3: [ice] is given twice, first at a.toml:1; keep one"},
        {"ice.strength_kPa = 1.0\n[ice]\nthickness_m = 1.0\n",
         "a.toml:2: [ice] is given twice, first at a.toml:1; keep one"},
        {"\"ice.thickness_m\" = 1.0\n[floe]\n[ice]\nthickness_m = 1.0\n",
         "a.toml:4: ice.thickness_m is given twice, first at a.toml:1; keep one"},
        {"[ice]\nstrength_kPa = 1.0\n[[case]]\nstrength_kPa = 1\nstrength_kPa = 2\n",
         "a.toml:5: case.strength_kPa is given twice, first at a.toml:4; keep one"},
        {"[[case]]\n\"ice.strength_kPa\" = 1\nice.strength_kPa = 2\n",
         "a.toml:3: ice.strength_kPa is given twice, first at a.toml:2; keep one"},
        {"\xFF\xFE[", "a.toml: this is text in UTF-16; save it in UTF-8"},
        {"[ice]\nthickness_m = 0,033  # thin\n", "a.toml:2: thickness_m = 0,033: write 0.033, with a point"},
        {"[ice]\nthickness_m = \n",
         "a.toml:2:15: this is not TOML (parsing key-value pair: expected value, saw '\\n')"},
    };
    for (const auto& [text, expected] : cases) EXPECT_EQ(message(text), expected) << text;
}

TEST(Keys, FirstMistakeInTheTextIsReported) {
    EXPECT_EQ(message("[z]\nb = 1\n[a]\nb = 2\n").substr(0, 17), "a.toml:2: z.b = 1");
}

TEST(Keys, OverridesAreTomlOrABareWord) {
    EXPECT_EQ(parse_override("a.b=0.5", "--set").value, Value{0.5});
    EXPECT_EQ(parse_override(" a.b = [[1, 2]] ", "--set").path, "a.b");
    EXPECT_EQ(parse_override("a.b=open", "--set").value, Value{std::string("open")});
    EXPECT_EQ(parse_override("a.b=\"open\"", "--set").value, Value{std::string("open")});
    EXPECT_EQ(parse_override("a.b=x=y", "--set").value, Value{std::string("x=y")});
    EXPECT_EQ(parse_override("a.b=1\nc=2", "--set").value, Value{std::string("1\nc=2")});
    for (const char* wrong : {"a.b", "=3", " = 3", ""})
        EXPECT_THROW(parse_override(wrong, "--set"), InputError) << wrong;
}

TEST(Keys, InfinityIsAllowedWhereTheRangeSaysSo) {
    const Range depth = at_least(0).at_most(10).or_infinity();
    EXPECT_EQ(to_text(depth), "at least 0 and at most 10, or inf");
    EXPECT_TRUE(depth.contains(HUGE_VAL));
    for (const double outside : {-HUGE_VAL, std::nan(""), 10.1}) EXPECT_FALSE(depth.contains(outside)) << outside;
    double field = 1;
    const Keys keys{number_key("ice.depth_m", field, unit::one, depth, "none", "Depth.")};
    assign_known(keys, {"ice.depth_m", Value{HUGE_VAL}, "a.toml:1"});
    EXPECT_EQ(field, HUGE_VAL);
    EXPECT_EQ(literal(keys[0]), "inf");
}

TEST(Keys, DifferencesNameTheKey) {
    Sample there;
    Sample here;
    EXPECT_TRUE(key_differences(describe(there), describe(here)).empty());
    here.strength = 40e3;
    here.colour = Colour::blue;
    const std::vector<std::string> expected{"ice.strength_kPa: 36.4 there, 40.0 here",
                                            "floe.colour: \"white\" there, \"blue\" here"};
    EXPECT_EQ(key_differences(describe(there), describe(here)), expected);
}

TEST(Literal, ReadsBackToTheSameValue) {
    for (const double unit : {1.0, 0.01, 1e3, 1e6, unit::degree}) {
        for (int i = 1; i <= 2000; ++i) {
            const double from_text = 0.017 * i;
            const double in_si = from_text * unit;
            EXPECT_EQ(std::stod(number_literal(in_si, unit)) * unit, in_si);
        }
    }
}

TEST(Literal, IsShortAndAlwaysANumberOfToml) {
    EXPECT_EQ(number_literal(36.4e3, unit::kilopascal), "36.4");
    EXPECT_EQ(number_literal(0.75, unit::percent), "75.0");
    EXPECT_EQ(number_literal(30 * unit::degree, unit::degree), "30.0");
    EXPECT_EQ(number_literal(1e-10), "1e-10");
    EXPECT_EQ(number_literal(-3), "-3.0");
    EXPECT_EQ(text_literal("a\n\"b\"\\"), "\"a\\u000a\\\"b\\\"\\\\\"");
}

TEST(EditDistance, CountsEdits) {
    EXPECT_EQ(edit_distance("", "abc"), 3u);
    EXPECT_EQ(edit_distance("thickness", "thickness"), 0u);
    EXPECT_EQ(edit_distance("thicknes", "thickness"), 1u);
    EXPECT_EQ(edit_distance("thikcness", "thickness"), 1u);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(Document, KeepsTheOrderOfTheText) {
    const Document document =
        parse_document("z = 1\na = 2\n[m]\nx = 3\n[[case]]\nb.c = 4\na = 5\n[[case]]\n[[case]]\nq = 6\n", "f");
    std::vector<std::string> paths;
    for (const Entry& entry : document.entries) paths.push_back(entry.path);
    EXPECT_EQ(paths, (std::vector<std::string>{"z", "a", "m.x"}));
    ASSERT_EQ(document.blocks.size(), 3u);
    EXPECT_EQ(document.blocks[0].entries[0].path, "b.c");
    EXPECT_EQ(document.blocks[0].entries[1].where, "f:7");
    EXPECT_EQ(document.blocks[2].where, "f:9");
}

// Outlines of a thousand floes once made a line of 14 kB.
TEST(Differences, OfLongValuesAreTheFirstOfThem) {
    const auto line = [](const std::function<void(Sample&)>& change) {
        Sample there, here;
        for (Sample* one : {&there, &here}) {
            one->points.assign(400, {0.125, 0.5});
            one->levels.assign(300, 20e3);
            one->label = std::string(300, 'x') + "é" + std::string(300, 'y');
        }
        change(here);
        const std::vector<std::string> lines = key_differences(describe(there), describe(here));
        EXPECT_EQ(lines.size(), 1u);
        return lines.at(0);
    };
    EXPECT_EQ(line([](Sample& here) { here.points[6][1] = here.points[8][0] = 0.75; }),
              "floe.points_m: row 7, the first of 2 that differ, is [0.125, 0.5] there, [0.125, 0.75] here");
    EXPECT_EQ(line([](Sample& here) { here.points.resize(399); }),
              "floe.points_m: row 400 is [0.125, 0.5] there, none here (the list has 400 rows there, 399 here)");
    EXPECT_EQ(line([](Sample& here) { here.levels[2] = 21e3; }), "ice.levels_kPa: number 3 is 20.0 there, 21.0 here");
    const std::string of_text = line([](Sample& here) { here.label.replace(300, 2, "è"); });
    EXPECT_TRUE(of_text.starts_with("floe.label: from letter 302 on, …éyyy")) << of_text;
    EXPECT_LT(of_text.size(), 250u);
    EXPECT_EQ(line([](Sample& here) { here.count = 4; }), "floe.count: 3 there, 4 here");
}

}  // namespace keys_test
}  // namespace floes
