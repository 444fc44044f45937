// What verbs say of a file that is not the one they need.

#include "cli/given.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "campaign_file/publish.hpp"
#include "cli/verb_output.hpp"
#include "core/error.hpp"
#include "hdf5/dataset.hpp"
#include "store/journal.hpp"
#include "support/refusal.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace given_file_test {

using testing::HasSubstr;

class GivenFiles : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_ / name; }

    std::string summarized(const std::string& name) const {
        return refusal([&] { verb_output(add_summarize, "summarize " + path(name)); });
    }

    TemporaryFolder folder_;
};

TEST_F(GivenFiles, OfWhichOnlyTheJournalIsThereCanBeMade) {
    const Campaign campaign = synthetic::campaign();
    {
        Journal journal = open_journal(path("my.journal"), campaign, Existing::refuse);
        for (const MemberRecord& record : synthetic::records(campaign)) journal.append(record);
    }
    const std::string said = summarized("my.h5");
    EXPECT_THAT(said, HasSubstr("my.journal has the members that are done"));
    EXPECT_THAT(said, HasSubstr("floes run CONFIG.toml -o " + path("my.h5") + " --resume"));
    const std::string merge = "merge " + path("my.h5") + " -o " + path("my_so_far.h5");
    EXPECT_THAT(said, HasSubstr("floes " + merge));
    EXPECT_EQ(verb_answer(add_merge, words_of(merge)).second, 1) << "some members are missing";
    EXPECT_THAT(verb_output(add_summarize, "summarize " + path("my_so_far.h5")), HasSubstr("soft"));
    EXPECT_THAT(summarized("my.journal"),
                HasSubstr("is the journal of a campaign; give its campaign file, " + path("my.h5")));
}

TEST_F(GivenFiles, ThatAreNoCampaignAreNotReplacedByOne) {
    std::ofstream(path("table.nc")) << "of another program";
    EXPECT_THAT(refusal([&] { verb_output(add_merge, "merge a.h5 --overwrite -o " + path("table.nc")); }),
                HasSubstr("is no campaign file and stays as it is; -o names another file for the campaign, as " +
                          path("table.h5")));
    EXPECT_THROW(verb_output(add_merge, "merge a.h5 -o " + path("all.journal")), CommandLineEnd)
        << "the merged file would go as its journal";
    EXPECT_THAT(refusal([&] { expect_no_other_file(path(".")); }), HasSubstr("is a folder and stays as it is"));
    std::filesystem::create_directory(path("empty"));
    EXPECT_THAT(refusal([&] { expect_no_other_file(path("empty")); }), HasSubstr("is a folder and stays as it is"));
    EXPECT_NO_THROW(expect_no_other_file(path("none.h5")));
    std::ofstream(path("nothing.h5")).close();
    EXPECT_THAT(refusal([&] { expect_no_other_file(path("nothing.h5")); }), HasSubstr("is an empty file"));
    std::ofstream(path("nothing.journal")) << "floesjnl";
    EXPECT_NO_THROW(expect_no_other_file(path("nothing.h5"))) << "--resume writes it again";
    { const hdf5::Handle another = hdf5::create_file(path("hull.h5")); }
    EXPECT_THAT(refusal([&] { expect_no_other_file(path("hull.h5")); }), HasSubstr("is no campaign file and stays"));
    publish(path("mine.h5"), synthetic::campaign(), synthetic::records(synthetic::campaign()), {});
    EXPECT_NO_THROW(expect_no_other_file(path("mine.h5")));
}

TEST_F(GivenFiles, ThatWouldShareAJournalAreNotReplaced) {
    publish(path("my.h5"), synthetic::campaign(), synthetic::records(synthetic::campaign()), {});
    std::ofstream(path("hull.nc")) << "of a diffraction program";
    EXPECT_NO_THROW(expect_no_other_file(path("hull.h5")));
    EXPECT_THAT(refusal([&] { expect_no_other_file(path("my.nc")); }),
                HasSubstr("my.nc would share its journal and pieces with " + path("my.h5")));
    EXPECT_NO_THROW(expect_no_other_file(path("other.nc")));
}

// The name is people's, and may have a slash, as a scale has; nothing outside the folder of the merged parts is
// touched.
TEST_F(GivenFiles, OfACampaignWithAnyNameAreMergedInAFolderOfTheirOwn) {
    std::filesystem::create_directory(path("mine"));
    std::ofstream(path("mine/kept")) << "kept";
    for (const std::string& name : {std::string("tank 1/36"), path("mine/tank"), std::string("../x")}) {
        Campaign campaign = synthetic::campaign();
        campaign.name = name;
        const std::vector<MemberRecord> records = synthetic::records(campaign);
        for (const char* part : {"1", "2"}) {
            Journal journal =
                open_journal(path(std::string("a.part") + part + ".journal"), campaign, Existing::replace);
            for (const MemberRecord& record : records) journal.append(record);
        }
        EXPECT_THAT(verb_output(add_summarize, "summarize " + path("a.part1.h5") + " " + path("a.part2.h5")),
                    HasSubstr("soft"));
        EXPECT_TRUE(std::filesystem::exists(path("mine/kept"))) << name;
    }
}

TEST_F(GivenFiles, ThatAreNoCampaignAreCalledWhatTheyAre) {
    std::ofstream(path("my.toml")) << "[campaign]\nseed = 1\n";
    std::ofstream(path("my.csv")) << "case,mean\n";
    std::ofstream(path("my.png"), std::ios::binary) << "\x89PNG\r\n\x1a\n";
    EXPECT_THAT(summarized("my.toml"), HasSubstr("is a configuration, not a campaign file; floes run "));
    EXPECT_THAT(summarized("my.csv"), HasSubstr("is a text, not a campaign file"));
    EXPECT_THAT(summarized("my.png"), HasSubstr("is no campaign file"));
    EXPECT_THAT(summarized("no.h5"), HasSubstr("there is no file"));
    EXPECT_THAT(refusal([&] { expect_campaign_file(path(".")); }), HasSubstr("is a folder"));
}

TEST_F(GivenFiles, ThatAreNoConfigurationAreCalledWhatTheyAre) {
    const Campaign campaign = synthetic::campaign();
    publish(path("a.h5"), campaign, synthetic::records(campaign), {});
    open_journal(path("a.journal"), campaign, Existing::refuse);
    EXPECT_THAT(refusal([&] { load_campaign(path("a.h5"), {}); }), HasSubstr("an HDF5 file, not a configuration"));
    EXPECT_THAT(refusal([&] { load_campaign(path("a.journal"), {}); }), HasSubstr("the journal of a campaign, not"));
}

TEST_F(GivenFiles, ThatFloesDidNotWriteAreNotVerified) {
    std::ofstream(path("my.csv")) << "case,mean\n";
    const auto [said, status] = verb_answer(add_verify, {"verify", path("my.csv")});
    EXPECT_THAT(said, HasSubstr("neither a campaign file, nor a recording, nor a journal of floes"));
    EXPECT_NE(status, 0);
}

}  // namespace given_file_test
}  // namespace floes
