#include "campaign_file/filed_campaign.hpp"
#include "campaign_file/publish.hpp"
#include "campaign_file/read.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/error.hpp"
#include "hdf5/dataset.hpp"
#include "hdf5/read.hpp"
#include "member/result.hpp"
#include "store/journal.hpp"
#include "support/file_bytes.hpp"
#include "support/refusal.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace campaign_file_test {

using testing::HasSubstr;

bool same(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

void expect_same_case(const CaseRow& a, const CaseRow& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.cfm, b.cfm);
    EXPECT_EQ(a.elastic_modulus, b.elastic_modulus);
    EXPECT_EQ(a.far_end, b.far_end);
    EXPECT_EQ(a.contact, b.contact);
    EXPECT_EQ(a.shape, b.shape);
    EXPECT_EQ(a.analysis.steady_start, b.analysis.steady_start);
    EXPECT_EQ(a.analysis.window, b.analysis.window);
    EXPECT_EQ(a.analysis.segments, b.analysis.segments);
    EXPECT_EQ(a.analysis.history_stride, b.analysis.history_stride);
    EXPECT_EQ(a.time_step, b.time_step);
}

void expect_same_member(MemberRow a, MemberRow b) {
    EXPECT_EQ(a.case_index, b.case_index);
    EXPECT_EQ(a.arrangement, b.arrangement);
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.reason, b.reason);
    EXPECT_EQ(a.load.steady, b.load.steady);
    for (const Quantity& one : quantities) EXPECT_TRUE(same(a.value(one), b.value(one))) << one.key.view();
    ASSERT_EQ(a.averaged.size(), b.averaged.size());
    for (std::size_t k = 0; k < a.averaged.size(); ++k) {
        EXPECT_EQ(a.averaged[k].time, b.averaged[k].time);
        EXPECT_EQ(a.averaged[k].sd, b.averaged[k].sd);
        EXPECT_EQ(a.averaged[k].segment_maximum, b.averaged[k].segment_maximum);
        EXPECT_EQ(a.averaged[k].mean_maximum, b.averaged[k].mean_maximum);
        EXPECT_EQ(a.averaged[k].sd_maximum, b.averaged[k].sd_maximum);
    }
    EXPECT_TRUE(std::ranges::equal(a.load.segment_maximum, b.load.segment_maximum, same));
    EXPECT_TRUE(std::ranges::equal(a.steps_above, b.steps_above, same));
    EXPECT_TRUE(std::ranges::equal(a.upcrossings, b.upcrossings, same));
}

// Exit status of h5diff outside /provenance: 0 equal, 1 different.
int compare(const std::filesystem::path& a, const std::filesystem::path& b) {
    const int status = std::system(("h5diff --exclude-path /provenance " + a.string() + " " + b.string()).c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(CampaignTable, HasEveryMemberWithItsNumbers) {
    const Campaign campaign = synthetic::campaign();
    const CampaignTable table = campaign_table(campaign, synthetic::records(campaign));
    EXPECT_EQ(table.title, "synthetic");
    ASSERT_EQ(table.cases.size(), 3u);
    EXPECT_EQ(table.cases[2].far_end, FarEnd::open);
    EXPECT_EQ(table.cases[2].shape.rows().size(), 3u);
    ASSERT_EQ(table.members.size(), 12u);
    const MemberRow& row = table.members[8];
    const MemberResult& result = synthetic::record(campaign, 8).result;
    EXPECT_EQ(row.status, RowStatus::done);
    EXPECT_EQ(row.case_index, 2);
    for (const Quantity& one : quantities) {
        if (std::isnan(one.of(result)))  // of a structure that gives way or turns
            EXPECT_TRUE(std::isnan(row.value(one))) << one.key.view();
        else
            EXPECT_EQ(row.value(one), one.of(result)) << one.key.view();
    }
    EXPECT_EQ(row.load.segment_maximum, result.load.segment_maximum);
    EXPECT_TRUE(row.load.steady);
}

TEST(CampaignTable, FailedAndMissingMembersHaveNoNumbers) {
    const Campaign campaign = synthetic::campaign();
    CampaignTable table = campaign_table(campaign, synthetic::records(campaign));
    EXPECT_EQ(table.members[4].status, RowStatus::failed);
    EXPECT_THAT(table.members[4].reason, HasSubstr("ran away"));
    EXPECT_EQ(table.members[7].status, RowStatus::missing);
    for (const std::size_t member : {4u, 7u}) {
        for (const Quantity& one : quantities)
            EXPECT_TRUE(std::isnan(table.members[member].value(one))) << one.key.view();
        EXPECT_TRUE(std::isnan(table.members[member].failures[0]));
        EXPECT_FALSE(table.members[member].load.steady);
    }
}

TEST(CampaignTable, CasesOfOneGeometryShareArrangements) {
    const Campaign campaign = synthetic::campaign();
    const CampaignTable table = campaign_table(campaign, {});
    EXPECT_EQ(table.members[0].arrangement, 0);
    EXPECT_EQ(table.members[1].arrangement, 0);
    EXPECT_EQ(table.members[2].arrangement, 1);
    EXPECT_EQ(table.members[9].arrangement, 6);
    EXPECT_EQ(table.members[11].arrangement, 7);
}

TEST(CampaignFile, GivesBackTheTable) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    const auto records = synthetic::records(campaign);
    publish(folder / "a.h5", campaign, records, {});
    const CampaignTable written = campaign_table(campaign, records);
    const CampaignTable read = read_campaign_file(folder / "a.h5");
    EXPECT_EQ(read.title, written.title);
    EXPECT_EQ(read.levels, (std::vector<double>{100, 300, 500}));
    EXPECT_EQ(read.levels, written.levels);
    ASSERT_EQ(read.cases.size(), written.cases.size());
    for (std::size_t k = 0; k < read.cases.size(); ++k) expect_same_case(read.cases[k], written.cases[k]);
    ASSERT_EQ(read.members.size(), written.members.size());
    for (std::size_t k = 0; k < read.members.size(); ++k) {
        SCOPED_TRACE(k);
        expect_same_member(read.members[k], written.members[k]);
    }
}

TEST(CampaignFile, SameMembersGiveTheSameValuesWhateverTheirOrderAndOrigin) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    auto records = synthetic::records(campaign);
    const std::vector<Session> one{synthetic::session(0)};
    const std::vector<Session> two{synthetic::session(0), synthetic::session(1)};
    publish(folder / "a.h5", campaign, records, one);
    std::reverse(records.begin(), records.end());
    for (MemberRecord& record : records) {
        record.rank += 5;
        record.host = "elsewhere";
        record.attempt += 1;
        record.result.wall_time *= 2;
    }
    publish(folder / "b.h5", campaign, records, two);
    EXPECT_EQ(compare(folder / "a.h5", folder / "b.h5"), 0);

    records[0].result.history.heave.back() += 1e-12;
    publish(folder / "c.h5", campaign, records, two);
    EXPECT_EQ(compare(folder / "a.h5", folder / "c.h5"), 1) << "the comparison must see a difference";
}

TEST(CampaignFile, HoldsThePropertiesOfFloesOfEachMembersOwnCase) {
    const TemporaryFolder folder;
    Campaign campaign = synthetic::campaign();
    campaign.cases.pop_back();  // the other two have the same floes
    for (Case& one : campaign.cases) {
        one.scenario.arrangement.method = ArrangementMethod::file;
        one.scenario.arrangement.columns = "ice.density_kg_m3";
        one.scenario.arrangement.poses.assign(6, {});
        one.scenario.arrangement.values.assign(6, {900});
    }
    std::vector<MemberRecord> records;
    for (int number = 0; number < member_count(campaign); ++number) {
        MemberResult& result = records.emplace_back(synthetic::record(campaign, number)).result;
        result.floe_properties.assign(result.arrangement.size() * floe_properties.size(), number);
    }
    publish(folder / "a.h5", campaign, records, {});
    const hdf5::Handle file = hdf5::open_for_reading(folder / "a.h5");
    const std::vector<double> values = hdf5::read_values<double>(file.id(), "members/floe_properties");
    const std::size_t width = 6 * floe_properties.size();
    ASSERT_EQ(values.size(), records.size() * width);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i], static_cast<double>(i / width));
}

TEST(CampaignFile, TakesRecordsFromTheJournal) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    const auto records = synthetic::records(campaign);
    publish(folder / "a.h5", campaign, records, {});
    Journal journal = open_journal(folder / "b.journal", campaign, Existing::refuse);
    for (const MemberRecord& record : records) journal.append(record);
    journal.hand_over();
    publish(folder / "b.h5", campaign, journal.members(), {});
    EXPECT_EQ(compare(folder / "a.h5", folder / "b.h5"), 0);
}

TEST(CampaignFile, GivesBackTheRecordsThatItWasMadeOf) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    const std::vector<MemberRecord> records = synthetic::records(campaign);
    const CalibrationRecord calibration = synthetic::calibration(campaign);
    Session session = synthetic::session();
    session.ended = "2026-01-01T11:00:00Z";
    session.outcome = "complete";
    session.reused = 1;
    session.computed = 10;
    session.software.push_back({"compiler_flags", "-O2 -DNDEBUG"});
    const std::vector<Session> sessions{session, synthetic::session(1)};
    publish(folder / "a.h5", campaign, records, sessions, std::span(&calibration, 1));

    const FiledCampaign filed = read_filed(folder / "a.h5");
    EXPECT_EQ(fingerprint(filed.campaign), fingerprint(campaign));
    EXPECT_FALSE(filed.is_whole());
    EXPECT_EQ(filed.sessions, sessions);
    std::size_t k = 0;
    for (const MemberRecord& one : records) {
        if (one.result.status != MemberStatus::done) continue;
        EXPECT_EQ(encode(filed.read(k)), encode(one)) << "member " << k;
        EXPECT_EQ(filed.notes[k].wall_time, one.result.wall_time);
        EXPECT_EQ(filed.notes[k].attempt, one.attempt);
        ++k;
    }
    EXPECT_EQ(filed.notes.size(), k);
    ASSERT_EQ(filed.calibrations.size(), 1u);
    EXPECT_EQ(filed.calibrations[0].key, calibration.key);
    EXPECT_EQ(filed.calibrations[0].found.cfm, calibration.found.cfm);
    ASSERT_EQ(filed.calibrations[0].found.curve.size(), calibration.found.curve.size());
    EXPECT_EQ(filed.calibrations[0].found.curve[2].slope, calibration.found.curve[2].slope);
    EXPECT_EQ(filed.calibrations[0].found.curve[2].iterations, calibration.found.curve[2].iterations);
}

TEST(CampaignFile, MakesTheJournalAgainThatItWasPublishedFrom) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    const std::vector<MemberRecord> records = synthetic::all_done_records(campaign);
    const std::vector<Session> sessions{synthetic::session(), synthetic::session(1)};
    publish(folder / "a.h5", campaign, records, sessions);
    const FiledCampaign filed = read_filed(folder / "a.h5");
    EXPECT_TRUE(filed.is_whole());
    {
        Journal journal = open_journal(folder / "a.journal", campaign, Existing::refuse);
        journal.append(records[3]);
        take_in(filed, campaign, journal);
        EXPECT_EQ(journal.contents().sessions, sessions);
    }
    Journal journal = open_journal(folder / "a.journal", campaign, Existing::resume);
    EXPECT_EQ(journal.contents().members.size(), records.size()) << "each once";
    EXPECT_EQ(journal.contents().sessions, sessions);
    take_in(filed, campaign, journal);
    EXPECT_EQ(journal.contents().members.size(), records.size()) << "nothing is new";
    EXPECT_EQ(journal.contents().sessions.size(), sessions.size());
    publish(folder / "again.h5", campaign, journal.members(), journal.contents().sessions);
    const auto digests = [&](const char* name) {
        return hdf5::read_contents_digests(hdf5::open_for_reading(folder / name).id()).contents;
    };
    EXPECT_EQ(digests("a.h5"), digests("again.h5"));
}

TEST(CampaignFile, RefusesWhatIsNoCampaignFile) {
    const TemporaryFolder folder;
    const auto refusal = [](const std::filesystem::path& path) {
        return floes::refusal([&] { read_campaign_file(path); });
    };
    EXPECT_THAT(refusal(folder / "none.h5"), HasSubstr("there is no file"));
    const std::string text = "Dear reader";
    write_file_bytes(folder / "text.h5", std::as_bytes(std::span(text)));
    EXPECT_THAT(refusal(folder / "text.h5"), HasSubstr("is not an HDF5 file"));
    hdf5::create_file(folder / "bare.h5");
    EXPECT_THAT(refusal(folder / "bare.h5"), HasSubstr("no campaign of floes"));
    {
        const hdf5::Handle file = hdf5::create_file(folder / "next.h5");
        hdf5::write_attribute(file.id(), "filetype", std::string("floes campaign"));
        hdf5::write_attribute(file.id(), "version", std::vector<std::int32_t>{2, 0});
    }
    EXPECT_THAT(refusal(folder / "next.h5"), HasSubstr("layout version 2"));
}

TEST(CampaignFile, StaysAsItWasWhenPublishingFails) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    publish(folder / "a.h5", campaign, {}, {});
    const Bytes before = file_bytes(folder / "a.h5");
    std::filesystem::create_directory(folder / "a.h5.tmp");
    EXPECT_THAT([&] { publish(folder / "a.h5", campaign, synthetic::records(campaign), {}); },
                testing::ThrowsMessage<RunError>(
                    testing::AllOf(HasSubstr("cannot be written: Is a directory. The folder must exist and permit it."),
                                   HasSubstr("a.h5.tmp"))));
    EXPECT_EQ(file_bytes(folder / "a.h5"), before);
}

TEST(CampaignFile, LeavesNothingAside) {
    const TemporaryFolder folder;
    publish(folder / "a.h5", synthetic::campaign(), {}, {});
    EXPECT_FALSE(std::filesystem::exists(folder / "a.h5.tmp"));
}

}  // namespace campaign_file_test
}  // namespace floes
