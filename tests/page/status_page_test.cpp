// A campaign under way as a page: what it says before, during and after a run.

#include "page/page.hpp"

#include <gmock/gmock.h>

#include "campaign_file/publish.hpp"
#include "store/journal.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace status_page_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const char* const refresh = "<meta http-equiv=\"refresh\" content=\"30\">";

class StatusPage : public testing::Test {
  protected:
    std::string page() const {
        std::string text = status_page(read_snapshot(file_), "a.h5", "2026-01-01T12:00:00Z");
        EXPECT_THAT(text, AllOf(Not(HasSubstr("nan")), Not(HasSubstr("<script")), Not(HasSubstr("src="))));
        EXPECT_THAT(text, HasSubstr("As of 2026-01-01T12:00:00Z"));
        return text;
    }

    Journal begun() const {
        Journal journal = open_journal(journal_path(file_), campaign_, Existing::refuse);
        journal.begin_session(synthetic::session(0));
        return journal;
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "a.h5";
    Campaign campaign_ = synthetic::campaign();
};

TEST_F(StatusPage, IsThereBeforeTheFirstMember) {
    const Journal journal = begun();
    EXPECT_THAT(page(), AllOf(HasSubstr("synthetic: 0 of 12 members done, 0 failed, 12 to do"), HasSubstr(refresh),
                              HasSubstr("No member is done yet."), HasSubstr("not known yet")));
}

// Number 4 of the second case failed, 7 of it is not computed; a case has four members.
TEST_F(StatusPage, TellsTheAnswerSoFarOfARunUnderWay) {
    Journal journal = begun();
    for (const MemberRecord& record : synthetic::records(campaign_)) journal.append(record);
    journal.hand_over();
    EXPECT_THAT(page(), AllOf(HasSubstr(refresh), HasSubstr("Running: 2 ranks, 4 threads from node0"),
                              HasSubstr("The answer so far"), HasSubstr("open: mean load 750 N")));
    EXPECT_THAT(page(), HasSubstr("<i style=\"width:50.0%\"></i><i class=\"bad\" style=\"width:25.0%\">"));
    // 100.1, 400.1, 700.1 and 1000.1 N: t(3) s / √n = 3.182446 * 387.298 / 2 = 616.3
    EXPECT_THAT(page(), HasSubstr("<td>550 ± 616</td><td>112.0</td>"));
    EXPECT_THAT(page(), HasSubstr("Member 4 (case stiff, arrangement 1): an element ran away"));
    EXPECT_THAT(page(), Not(HasSubstr("--resume")));
}

TEST_F(StatusPage, SaysHowToContinueAKilledRun) {
    {
        Journal journal = begun();
        journal.append(synthetic::record(campaign_, 0));
    }
    EXPECT_THAT(page(), AllOf(Not(HasSubstr(refresh)), HasSubstr("was killed"),
                              HasSubstr("<pre>floes run CONFIG.toml -o a.h5 --resume</pre>"),
                              HasSubstr("did not end properly")));
}

TEST_F(StatusPage, OfAnEndedRunStaysAsItIs) {
    {
        Journal journal = begun();
        for (int number = 0; number < 12; ++number) journal.append(synthetic::record(campaign_, number));
        journal.end_session("complete");
    }
    EXPECT_THAT(page(), AllOf(Not(HasSubstr(refresh)), HasSubstr("<h2>The answer</h2>"), HasSubstr("complete"),
                              HasSubstr("<pre>floes report a.h5</pre>")));
}

TEST_F(StatusPage, IsMadeOfTheCampaignFileAlone) {
    publish(file_, campaign_, synthetic::records(campaign_), {});
    EXPECT_THAT(page(), AllOf(Not(HasSubstr(refresh)), HasSubstr("10 of 12 members done"), HasSubstr("--resume")));
}

}  // namespace status_page_test
}  // namespace floes
