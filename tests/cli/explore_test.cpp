// floes explore: what the page of a synthetic campaign holds.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "campaign_file/publish.hpp"
#include "campaign_file/read.hpp"
#include "cli/verb_output.hpp"
#include "core/error.hpp"
#include "draw/explore_page.hpp"
#include "findings/evidence.hpp"
#include "support/file_bytes.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace explore_test {

using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class Explore : public testing::Test {
  protected:
    /// Of twelve members, of which number 4 failed and number 7 is missing.
    std::string page(const ExploreOptions& options = {.file = "my.h5"}, Campaign campaign = synthetic::campaign()) {
        publish(folder_ / "a.h5", campaign, synthetic::records(campaign), {});
        const CampaignFile file(folder_ / "a.h5");
        std::ostringstream text;
        write_explore_page(text, read_evidence(file), file, options);
        return text.str();
    }

    static json header(const std::string& page) {
        const std::string open = "<script type=\"application/json\" id=\"header\">";
        const std::size_t begin = page.find(open) + open.size();
        return json::parse(page.substr(begin, page.find("</script>", begin) - begin));
    }

    static std::vector<std::string> keys(const json& header) {
        std::vector<std::string> all;
        for (const json& column : header["columns"]) all.push_back(column["key"]);
        return all;
    }

    static json column(const json& header, const std::string& key) {
        for (const json& one : header["columns"])
            if (one["key"] == key) return one;
        return {};
    }

    TemporaryFolder folder_;
};

TEST_F(Explore, HasMembersQuantitiesAndTheInputsThatDiffer) {
    const json about = header(page());
    EXPECT_EQ(about["title"], "synthetic");
    EXPECT_EQ(about["done"], 10);
    EXPECT_EQ(about["missing"], 1);
    EXPECT_EQ(about["failed"][0]["member"], 4);
    EXPECT_THAT(about["failed"][0]["why"].get<std::string>(), HasSubstr("ran away"));
    EXPECT_EQ(about["cases"], json({"soft", "stiff", "open"}));
    for (const char* key : {"case", "arrangement", "member", "mean_load", "failure_ratio", "ice.elastic_modulus_MPa",
                            "field.far_end", "field.floes"})
        EXPECT_THAT(keys(about), Contains(key));
    EXPECT_THAT(keys(about), Not(Contains("ice.thickness_m"))) << "the same in all cases";
    EXPECT_EQ(column(about, "field.far_end")["categories"], json({"ice_sheet", "open"}));
}

TEST_F(Explore, HasTheAxesOfADesign) {
    const json about = header(page({.file = "my.h5"}, synthetic::campaign_with_design()));
    EXPECT_THAT(keys(about), Contains("ice.thickness_m"));
    EXPECT_EQ(column(about, "joint.cfm")["log"], true);
}

TEST_F(Explore, ThinsHistoriesAndSaysSo) {
    EXPECT_EQ(header(page())["history"]["thinned"], false);
    const json thin = header(page({.file = "my.h5", .most_parts = 100}))["history"];
    EXPECT_EQ(thin["parts"], 10);
    EXPECT_EQ(thin["thinned"], true);
    EXPECT_EQ(thin["kept"], 10);
    EXPECT_NEAR(thin["ends"][0], 2.2, 1e-9);
    EXPECT_EQ(thin["windows"][2], json({1.2, 2.0}));
}

TEST_F(Explore, LeavesOutWhatPeopleAreShownLessAndNamesIt) {
    const json about = header(page({.file = "my.h5", .most_values = 150}));
    EXPECT_THAT(keys(about), Contains("mean_load"));
    EXPECT_THAT(keys(about), Not(Contains("mean_sway")));
    EXPECT_THAT(about["left_out"].get<std::vector<std::string>>(), Contains("mean sway"));
}

TEST_F(Explore, AsksNothingOfTheNetworkAndHasItsLibrarysLicence) {
    const std::string text = page();
    const std::regex foreign(R"re((src|href)="(?!data:)|url\(|@import|fetch\(|XMLHttpRequest\()re");
    const std::size_t library = text.find("!function(){var d3=");
    ASSERT_NE(library, std::string::npos);
    for (const std::string& part : {text.substr(0, library), text.substr(text.find("</script>", library))})
        EXPECT_FALSE(std::regex_search(part, foreign));
    EXPECT_NE(text.find("Michael Bostock"), std::string::npos);
    EXPECT_EQ(text.find("{{"), std::string::npos);
}

TEST_F(Explore, IsWrittenByItsVerb) {
    const std::string file = folder_ / "b.h5";
    const std::string output = folder_ / "b.html";
    const Campaign campaign = synthetic::campaign();
    publish(file, campaign, synthetic::records(campaign), {});
    EXPECT_EQ(verb_output(add_explore, "explore " + file + " -o " + output), output + "\n");
    EXPECT_EQ(header(file_text(output))["file"], file);
    publish(file, campaign, std::span<const MemberRecord>{}, {});
    EXPECT_THROW(verb_output(add_explore, "explore " + file + " -o " + output), InputError) << "nothing is done";
}

}  // namespace explore_test
}  // namespace floes
