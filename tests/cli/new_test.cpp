// floes new: what it writes is accepted, says units and ranges, and is the case that it says it is.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

#include "campaign/campaign.hpp"
#include "campaign/campaign_keys.hpp"
#include "cli/given.hpp"
#include "cli/verb_output.hpp"
#include "core/error.hpp"
#include "scenario/keys.hpp"
#include "support/file_bytes.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace new_test {

using testing::HasSubstr;
using testing::Not;

class New : public testing::Test {
  protected:
    std::string make(const std::string& options) {
        const std::string file = folder_ / ("my" + options + ".toml");
        EXPECT_EQ(verb_output(add_new, "new " + file + " " + options), file + "\n");
        return file;
    }

    TemporaryFolder folder_;
};

TEST_F(New, WritesCampaignsThatAreAccepted) {
    const Campaign tank = load_campaign(make(""), {});
    EXPECT_EQ(tank.cases.size(), 2u);
    EXPECT_LE(member_count(tank), 8) << "it is to be done within a minute";
    const Campaign floater = load_campaign(make("--full-scale"), {});
    EXPECT_GT(floater.cases.at(0).scenario.floe.length, 10);
    const Scenario moored = load_campaign(make("--moored"), {}).cases.at(0).scenario;
    EXPECT_TRUE(moored.moorings.floats() && moored.shapes.any() && moored.field.endless());
    for (const Case& one : load_campaign(make("--turret"), {}).cases)
        EXPECT_TRUE(one.scenario.moorings.turret.lines && one.scenario.path.any() && one.scenario.field.endless());
    const Campaign design = load_campaign(make("--design"), {});
    EXPECT_EQ(design.cases.size(), 6u);
}

TEST_F(New, TheFirstCampaignNamesNeitherTheSolverNorItsNumbers) {
    EXPECT_THAT(file_text(make("")), Not(testing::AnyOf(HasSubstr("cfm"), HasSubstr("solver"))));
}

TEST_F(New, SaysUnitAndRangeOfEveryKey) {
    const CampaignTables all;
    for (const char* options : {"", "--full-scale", "--moored", "--turret", "--level", "--design", "--paper"}) {
        std::istringstream text(file_text(make(options)));
        std::string table;
        std::string before;
        int assignments = 0;
        for (std::string line; std::getline(text, line); before = line[0] == '#' ? before + " " + line : "") {
            EXPECT_LE(line.size(), 120u) << line;
            std::smatch match;
            if (std::regex_match(line, match, std::regex(R"(\[+(\S+?)\]+)"))) table = match[1];
            if (table == "case" || table == "design.axis" ||
                !std::regex_search(line, match, std::regex(R"(^(\w+) = )")))
                continue;
            const std::string path = table + "." + match[1].str();
            const auto key = std::ranges::find(all.keys, path, &Key::path);
            ASSERT_NE(key, all.keys.end()) << path;
            const std::string wanted = allowed(*key);
            const std::string comments = before + " " + line;
            const std::string unbroken = std::regex_replace(comments, std::regex(" # "), " ");
            const std::size_t range = unbroken.find(wanted);
            ASSERT_NE(range, std::string::npos) << path << ": " << wanted;
            EXPECT_FALSE(std::isdigit(unbroken.c_str()[range + wanted.size()])) << path << ": " << wanted;
            if (path.ends_with("_kPa")) {
                EXPECT_THAT(comments, HasSubstr("# kPa, "));
            }
            if (path.ends_with("_m_s")) {
                EXPECT_THAT(comments, HasSubstr("# m/s, "));
            }
            ++assignments;
        }
        EXPECT_GE(assignments, 20) << options;
    }
}

TEST_F(New, ThePapersCaseAndTheFloaterAreThoseOfTheirConfigurations) {
    for (const auto& [options, file] : {std::pair{"--paper", "table3"}, {"--full-scale", "full_scale"}}) {
        const Campaign made = load_campaign(make(options), {});
        const Campaign whole = load_campaign(fmt::format("{}/configs/{}.toml", FLOES_SOURCE_DIR, file), {});
        ASSERT_EQ(made.cases.size(), whole.cases.size());
        EXPECT_LT(made.arrangements, whole.arrangements);
        EXPECT_EQ(arrangement_seed(made, 0), arrangement_seed(whole, 0));
        for (int k = 0; k < static_cast<int>(made.cases.size()); ++k)
            EXPECT_EQ(case_fingerprint(made, k), case_fingerprint(whole, k)) << file << " " << k;
    }
}

TEST_F(New, TouchesNoFileThatExists) {
    const std::string file = make("");
    const std::string text = file_text(file);
    EXPECT_THAT(refusal([&] { verb_output(add_new, "new " + file + " --paper"); }), HasSubstr("exists already"));
    EXPECT_EQ(file_text(file), text);
    EXPECT_THAT(refusal([&] { verb_output(add_new, "new my.h5"); }), HasSubstr("ends with .toml"));
    EXPECT_THAT(refusal([&] { verb_output(add_new, "new " + (folder_ / "no/my.toml").string()); }),
                HasSubstr("cannot be written: No such file"));
    EXPECT_THROW(verb_output(add_new, "new my.toml --paper --design"), CommandLineEnd);
}

}  // namespace new_test
}  // namespace floes
