// Targets: what a text says of them, what is refused, and the two texts that stand in configs.

#include "match/waves.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "findings/cases.hpp"
#include "support/file_bytes.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace targets_test {

using testing::HasSubstr;

std::vector<Target> read(const std::string& text) {
    return read_targets(text, "t.toml");
}

std::vector<Target> of_configs(const std::string& name) {
    return read_targets(file_text(std::string(FLOES_SOURCE_DIR) + "/configs/" + name), name);
}

const Target& find(const std::vector<Target>& targets, const std::string& name) {
    const auto found = std::ranges::find(targets, name, &Target::name);
    if (found == targets.end()) throw InputError("there is no target " + name);
    return *found;
}

const std::string mean = "[[target]]\nquantity = \"mean_load\"\n";

TEST(Targets, HaveWhatTheTextSays) {
    const std::vector<Target> targets = read(
        "[[target]]\nquantity = \"mean_maximum_0.5s\"\ncase = \"E60\"\nvalue = 102\nuncertainty = 1.5\nruns = 3\n"
        "discrepancy = 4.0\nheld_out = true\n" +
        mean + "value = -30.5\n");
    ASSERT_EQ(targets.size(), 2u);
    EXPECT_EQ(targets[0].name(), "E60 mean_maximum_0.5s");
    EXPECT_EQ(targets[0].quantity.averaging, 0.5);
    EXPECT_EQ(targets[0].value, 102);
    EXPECT_EQ(targets[0].uncertainty, 1.5);
    EXPECT_EQ(targets[0].runs, 3);
    EXPECT_EQ(targets[0].discrepancy, 4);
    EXPECT_TRUE(targets[0].held_out);
    EXPECT_EQ(targets[1].name(), "mean_load");
    EXPECT_EQ(targets[1].value, -30.5);
    EXPECT_EQ(targets[1].uncertainty, 0);
    EXPECT_EQ(targets[1].runs, 1);
    EXPECT_EQ(targets[1].discrepancy, 0);
    EXPECT_FALSE(targets[1].held_out);
}

TEST(Targets, AreShownWithTheirUnits) {
    EXPECT_EQ(read(mean + "value = 24.25\n").front().shown(24.25), "24.25 N");
    EXPECT_EQ(read("[[target]]\nquantity = \"failure_ratio\"\nvalue = 22.0\n").front().shown(0.0765, 2), "7.6 %");
    EXPECT_EQ(read("[[target]]\nquantity = \"local_order\"\nvalue = 0.5\n").front().shown(0.5), "0.5");
}

TEST(Targets, OfARatioAreInPercent) {
    const Target ratio =
        read("[[target]]\nquantity = \"failure_ratio\"\nvalue = 22.0\nuncertainty = 0.5\ndiscrepancy = 3\n").front();
    EXPECT_DOUBLE_EQ(ratio.value, 0.22);
    EXPECT_DOUBLE_EQ(ratio.uncertainty, 0.005);
    EXPECT_DOUBLE_EQ(ratio.discrepancy, 0.03);
}

TEST(Targets, MayGiveTheirDiscrepancyInPercentOfTheValue) {
    EXPECT_DOUBLE_EQ(read(mean + "discrepancy_percent = 5\nvalue = -40\n").front().discrepancy, 2);
    EXPECT_DOUBLE_EQ(
        read("[[target]]\nquantity = \"failure_ratio\"\nvalue = 20\ndiscrepancy_percent = 10\n").front().discrepancy,
        0.02);
}

TEST(Targets, AreRefusedInASentence) {
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"", "t.toml: there are no targets; write [[target]] with quantity and value"},
        {"value = 3\n", "t.toml:1: value = 3 is not in a target; begin each target with [[target]]"},
        {"[target]\nvalue = 3\n", "t.toml:2: target.value = 3 is not in a target; begin each target with [[target]]"},
        {"[[targets]]\nvalue = 3\n", "t.toml:1: [[targets]] is not a table of targets; did you mean [[target]]?"},
        {"[[target]]\nvalue = 3\n", "t.toml:1: this [[target]] has no quantity; begin it with quantity ="},
        {"[[target]]\nquantity = 3\n", "t.toml:2: quantity = 3 is not text"},
        {"[[target]]\nquantity = \"mean_laod\"\nvalue = 3\n",
         "t.toml:2: quantity = \"mean_laod\" is not a quantity of a member; did you mean \"mean_load\"?"},
        {"[[target]]\nquantity = \"mean_maximun_0.5s\"\nvalue = 3\n", "did you mean \"mean_maximum_0.5s\"?"},
        {"[[target]]\nquantity = \"\"\nvalue = 3\n", "quantity = \"\" is not a quantity"},
        {mean, "t.toml:1: the target mean_load has no value; give the measured one, in N"},
        {"[[target]]\nquantity = \"failure_ratio\"\n", "give the measured one, in percent"},
        {mean + "value = \"3\"\n", "t.toml:3: value = \"3\" is not a number"},
        {mean + "value = nan\n", "t.toml:3: value = nan is out of range"},
        {mean + "value = 3\nuncertainy = 1\n", "t.toml:4: uncertainy = 1 is not a key; did you mean uncertainty?"},
        {mean + "value = 3\nuncertainty = -1.0\n", "t.toml:4: uncertainty = -1.0 is out of range; allowed: at least 0"},
        {mean + "value = 3\ndiscrepancy = -1.0\n", "t.toml:4: discrepancy = -1.0 is out of range"},
        {mean + "value = 3\ndiscrepancy_percent = -1.0\n", "t.toml:4: discrepancy_percent = -1.0 is out of range"},
        {mean + "value = 3\ndiscrepancy = 1\ndiscrepancy_percent = 2\n",
         "t.toml:5: discrepancy_percent = 2 and discrepancy are both given; keep one"},
        {mean + "value = 0\ndiscrepancy_percent = 10\n",
         "t.toml:4: discrepancy_percent = 10 of value = 0 is no discrepancy; give discrepancy instead, in N"},
        {mean + "value = 3\nruns = 0\n", "t.toml:4: runs = 0 is out of range; allowed: a whole number from 1"},
        {mean + "value = 3\nheld_out = 1\n", "t.toml:4: held_out = 1 is neither true nor false"},
        {"[[target]]\nquantity = \"failure_ratio\"\nvalue = 101\n", "allowed: at least 0 and at most 100"},
        {"[[target]]\nquantity = \"maximum_load\"\nvalue = 0\n", "value = 0 is out of range; allowed: above 0"},
        {mean + "value = 3\n" + mean + "value = 4\n", "t.toml:4: mean_load is a target already, at t.toml:1; keep one"},
    };
    for (const auto& [text, sentence] : wrong)
        EXPECT_THAT(refusal([&, &given = text] { read(given); }), HasSubstr(sentence)) << text;
}

TEST(Targets, OfZeroMayHaveNoDiscrepancyOrOneInTheirUnit) {
    EXPECT_EQ(read(mean + "value = 0\ndiscrepancy_percent = 0\n").front().discrepancy, 0);
    EXPECT_EQ(read(mean + "value = 0\ndiscrepancy = 2\n").front().discrepancy, 2);
}

TEST(Targets, OfOneQuantityMayBeOfTwoCases) {
    EXPECT_EQ(read(mean + "case = \"A\"\nvalue = 3\n" + mean + "case = \"B\"\nvalue = 3\n").size(), 2u);
}

TEST(Table3Targets, AreThePapersFigures) {
    const std::vector<Target> targets = of_configs("targets_table3.toml");
    EXPECT_EQ(targets.size(), 18u);
    for (const PaperRow& row : paper_table3) {
        const std::string name = "E" + std::to_string(std::lround(row.elastic_modulus_mpa));
        const auto value = [&](const std::string& key) { return find(targets, name + " " + key).value; };
        EXPECT_EQ(value("mean_load"), row.mean);
        EXPECT_EQ(value("sd_load"), row.sd);
        EXPECT_EQ(value("mean_maximum"), row.mean_maximum);
        EXPECT_EQ(value("sd_maximum"), row.sd_maximum);
        EXPECT_DOUBLE_EQ(value("failure_ratio"), row.failure_ratio);
    }
    for (const Target& target : targets) {
        EXPECT_EQ(target.runs, 1);
        EXPECT_EQ(target.held_out, target.case_name != "E60") << target.name();
        EXPECT_GT(target.discrepancy, 0) << target.name();
    }
}

// The largest of the maxima of 50 s that the table lists. It fits the mean and the SD of all three: the other two, of
// sum s and sum of squares q, are s/2 ± √(q/2 - s²/4), and neither is larger.
TEST(Table3Targets, HaveALargestLoadThatFitsMeanAndSpreadOfTheMaxima) {
    const std::vector<Target> targets = of_configs("targets_table3.toml");
    const std::vector<std::pair<std::string, std::vector<double>>> maxima{
        {"E30", {46.75, 106.58, 126.84}}, {"E60", {93.10, 98.50, 162.22}}, {"E200", {86.48, 127.36, 150.30}}};
    for (const auto& [name, rising] : maxima) {
        const double largest = find(targets, name + " maximum_load").value;
        const double average = find(targets, name + " mean_maximum").value;
        const double sd = find(targets, name + " sd_maximum").value;
        const double sum = 3 * average - largest;
        const double squares = 3 * (sd * sd + average * average) - largest * largest;
        const double apart = std::sqrt(squares / 2 - sum * sum / 4);
        EXPECT_EQ(largest, rising[2]);
        EXPECT_NEAR(sum / 2 - apart, rising[0], 0.1) << name;
        EXPECT_NEAR(sum / 2 + apart, rising[1], 0.1) << name;
    }
}

TEST(TankTargets, AreTheExperimentsFigures) {
    const std::vector<Target> targets = of_configs("targets_tank.toml");
    const Experiment found;
    ASSERT_EQ(targets.size(), 3u);
    EXPECT_EQ(find(targets, "E60 mean_load").value, found.mean);
    EXPECT_EQ(find(targets, "E60 maximum_load_0.5s").value, found.maximum);
    EXPECT_DOUBLE_EQ(find(targets, "E60 split_ratio").value, found.failure_ratio);
    EXPECT_EQ(found.elastic_modulus_mpa, 60);
}

}  // namespace targets_test
}  // namespace floes
