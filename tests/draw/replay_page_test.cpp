#include "draw/replay_page.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

#include "core/bytes.hpp"
#include "core/error.hpp"
#include "draw/page_parts.hpp"
#include "draw/synthetic_recording.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace replay_page_test {

class ReplayPage : public testing::Test {
  protected:
    std::string page(int frames, const PageOptions& options = {}, bool moored = false) {
        synthetic::write_recording(folder_ / "recording.h5", frames, moored);
        std::ostringstream text;
        write_replay_page(text, Recording(folder_ / "recording.h5"), options);
        return text.str();
    }

    static nlohmann::json header(const std::string& page) {
        const std::string open = "<script type=\"application/json\" id=\"header\">";
        const std::size_t begin = page.find(open) + open.size();
        return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
    }

    TemporaryFolder folder_;
};

TEST(ScriptText, EndsNoScriptAndSwallowsNone) {
    const std::string text = R"({"name":"</script><!--<script>"})";
    const std::string escaped = in_a_script(text);
    EXPECT_EQ(escaped.find('<'), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(escaped), nlohmann::json::parse(text));
}

TEST_F(ReplayPage, HasTheHistoriesOfAHullThatGivesWay) {
    EXPECT_TRUE(header(page(20))["hull_histories"].empty());
    const nlohmann::json about = header(page(20, {}, true));
    const nlohmann::json& hull = about["hull_histories"];
    ASSERT_EQ(hull.size(), 2u);
    EXPECT_EQ(hull[0]["key"], "mooring_force");
    EXPECT_EQ(hull[0]["unit"], "N");
    EXPECT_TRUE(hull[0]["asked"]);
    EXPECT_EQ(hull[1]["key"], "offset");
    EXPECT_EQ(hull[1]["unit"], "m");
    EXPECT_FALSE(hull[1]["asked"]);
    EXPECT_EQ(about["histories"][0]["mooring_force"]["values"][2], 6.0);
    EXPECT_EQ(about["histories"][0]["offset"]["values"].size(), about["histories"][0]["surge"]["values"].size());
}

TEST_F(ReplayPage, SaysWhatIsReplayed) {
    const nlohmann::json about = header(page(20));
    EXPECT_EQ(about["campaign"], "synthetic </script>");
    EXPECT_EQ(about["case"], "soft");
    EXPECT_EQ(about["member"], 3);
    EXPECT_EQ(about["frames"], 20);
    EXPECT_EQ(about["elements"], 54);
    // Joint 3 of floe 2 connects two of its elements, along one axis.
    const nlohmann::json failure = about["failures"].at(0);
    EXPECT_EQ(failure[2], 2);
    const int a = failure[3];
    const int b = failure[5];
    EXPECT_EQ(a / 9, 2);
    EXPECT_EQ(b / 9, 2);
    EXPECT_TRUE(b == a + 1 ? failure[4] == 1 && failure[6] == 4 : b == a + 3 && failure[4] == 2 && failure[6] == 8);
    EXPECT_EQ(about["histories"][0]["surge"]["values"].size(), 110U);
    const nlohmann::json plan = about["views"][4];
    EXPECT_EQ(plan["name"], "plan");
    EXPECT_FALSE(plan["follows"]);
    EXPECT_TRUE(about["views"][0]["follows"]);
    const nlohmann::json side = about["views"][2];
    EXPECT_EQ(side["name"], "side");
    EXPECT_GT(side["cut"], 0.7) << "in front of the structure";
    EXPECT_LT(side["cut"], 1.0);
    EXPECT_EQ(about["views"][0]["cut"], 0);
    EXPECT_EQ(about["start"], 0) << "the first frame, unless another is asked for";
    EXPECT_EQ(header(page(20, {.start = 1.2}))["start"], 1.2);
}

TEST_F(ReplayPage, AsksNothingOfTheNetworkAndHasThreesLicence) {
    const std::string text = page(3);
    const std::regex foreign(R"re((src|href)="(?!data:)|url\(|@import|fetch\(|XMLHttpRequest\()re");
    const std::size_t three = text.find("(function(global,factory)");
    ASSERT_NE(three, std::string::npos);
    const std::size_t after = text.find("</script>", three);
    for (const std::string& part : {text.substr(0, three), text.substr(after)})
        EXPECT_FALSE(std::regex_search(part, foreign));
    EXPECT_NE(text.find("three.js authors"), std::string::npos);
    EXPECT_NE(text.find("THE SOFTWARE IS PROVIDED \"AS IS\""), std::string::npos);
    EXPECT_EQ(text.find("{{"), std::string::npos);
}

TEST_F(ReplayPage, LeavesFramesOutToStayBelowItsSize) {
    const std::string all = page(200);
    EXPECT_EQ(header(all)["frames"], 200);
    const std::size_t most = all.size() - 60'000;
    const std::string fewer = page(200, {.most_bytes = most});
    EXPECT_LE(fewer.size(), most);
    const int frames = header(fewer)["frames"];
    EXPECT_LT(frames, 150);
    EXPECT_GT(frames, 20);
    EXPECT_THROW(page(200, {.most_bytes = 100'000}), InputError);
}

TEST_F(ReplayPage, RefusesAPlaceThatCannotBeWritten) {
    synthetic::write_recording(folder_ / "recording.h5", 2);
    EXPECT_THROW(write_replay_page(folder_ / "no" / "page.html", Recording(folder_ / "recording.h5")), RunError);
}

TEST(Base64, IsThatOfTheStandard) {
    const auto text = [](std::string_view plain) {
        std::ostringstream out;
        write_base64(out, std::as_bytes(std::span(plain)));
        return out.str();
    };
    // RFC 4648, section 10.
    EXPECT_EQ(text(""), "");
    EXPECT_EQ(text("f"), "Zg==");
    EXPECT_EQ(text("fo"), "Zm8=");
    EXPECT_EQ(text("foo"), "Zm9v");
    EXPECT_EQ(text("foobar"), "Zm9vYmFy");
}

}  // namespace replay_page_test
}  // namespace floes
