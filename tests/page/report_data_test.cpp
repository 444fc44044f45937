// What the report gathers from a campaign file.

#include "page/report_data.hpp"

#include <gtest/gtest.h>

#include "campaign_file/publish.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace {

// They were looked for in the working folder, and the report had no design loads.
TEST(ReportData, TakesMissingPeaksFromTheHistoriesOfAFileInAnotherFolder) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    std::vector<MemberRecord> records = synthetic::records(campaign);
    for (MemberRecord& record : records)
        for (AveragedLoad& one : record.result.averaged) one.peaks.clear();
    publish(folder / "a.h5", campaign, records, std::vector<Session>{synthetic::session()});
    const ReportData data = read_report_data(folder / "a.h5");
    EXPECT_EQ(data.designs.size(), 3u);
    EXPECT_EQ(data.file_name, "a.h5");
}

}  // namespace
}  // namespace floes
