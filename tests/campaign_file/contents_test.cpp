// The digests over all that a file holds, and which files are read for them.

#include "hdf5/read.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "campaign_file/publish.hpp"
#include "hdf5/dataset.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace contents_test {

/// A file with a text in each of the groups.
void write_groups(const std::filesystem::path& path, const std::vector<std::string>& names) {
    const hdf5::Handle file = hdf5::create_file(path);
    hdf5::write_attribute(file.id(), "filetype", std::string("of others"));
    for (const std::string& name : names)
        hdf5::write_text(hdf5::create_group(file.id(), name).id(), {"text", "1", "a text"}, "text of " + name);
}

TEST(FileCheck, DoesNotReadWhatIsOfOthers) {
    const TemporaryFolder folder;
    write_groups(folder / "a.h5", {"one"});
    constexpr std::array others{std::string_view("of others")};
    EXPECT_EQ(hdf5::check_file(folder / "a.h5", others).datasets, 1u);
    const hdf5::FileCheck unread = hdf5::check_file(folder / "a.h5", {});
    EXPECT_EQ(unread.datasets, 0u);
    EXPECT_EQ(unread.filetype, "of others");
}

TEST(ContentsDigest, LeavesOutProvenanceAndNothingElse) {
    const TemporaryFolder folder;
    const auto digests = [&](const std::vector<std::string>& names) {
        write_groups(folder / "a.h5", names);
        return hdf5::contents_digests(hdf5::open_for_reading(folder / "a.h5").id());
    };
    const hdf5::ContentsDigests one = digests({"members"});
    EXPECT_EQ(one.provenance, "");
    EXPECT_EQ(digests({"members", "provenance"}).contents, one.contents);
    EXPECT_NE(digests({"members", "provenance"}).provenance, "");
    EXPECT_NE(digests({"members", "provenance2"}).contents, one.contents);
    EXPECT_EQ(digests({"members", "provenance2"}).provenance, "");
}

TEST(ContentsDigest, IsThatOfTheMembersAlone) {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign();
    auto records = synthetic::records(campaign);
    const auto digest = [&](const std::vector<Session>& sessions) {
        publish(folder / "a.h5", campaign, records, sessions);
        const hdf5::FileCheck check = hdf5::check_file(folder / "a.h5", {});
        EXPECT_TRUE(check.good()) << check.fault;
        EXPECT_TRUE(check.has_digests);
        return check.contents;
    };
    const std::string one = digest({synthetic::session(0)});
    EXPECT_EQ(one.size(), 32u);
    std::ranges::reverse(records);
    for (MemberRecord& record : records) record.host = "elsewhere";
    EXPECT_EQ(digest({synthetic::session(0), synthetic::session(1)}), one);
    records[0].result.history.heave.back() += 1e-12;
    EXPECT_NE(digest({synthetic::session(0)}), one);
}

}  // namespace contents_test
}  // namespace floes
