// Readers take what belongs there, and say of a dataset what is wrong with it.

#include "hdf5/read.hpp"

#include <gmock/gmock.h>

#include <array>

#include "hdf5/columns.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace read_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A file with numbers, a table of 3 rows of 2, texts and a group.
std::filesystem::path written(const TemporaryFolder& folder) {
    const hdf5::Handle file = hdf5::create_file(folder / "a.h5");
    const hdf5::Scale row = hdf5::write_index_scale(file.id(), "row", "row", 3);
    const hdf5::Scale part = hdf5::write_index_scale(file.id(), "part", "part", 2);
    const hdf5::Handle group = hdf5::create_group(file.id(), "inner");
    hdf5::write_values(group.id(), {"counts", "1", "counts"}, {row}, std::vector<std::int32_t>{4, 5, 6});
    hdf5::write_values(file.id(), {"table", "N", "table"}, {row, part}, std::vector<double>{1, 2, 3, 4, 5, 6});
    hdf5::write_values(file.id(), {"words", "1", "words"}, {row}, std::vector<std::string>{"ice", "Eis", "jää"});
    hdf5::write_contents_digests(file.id());
    return folder / "a.h5";
}

/// The fault that the action tells.
template <class Action>
std::string fault_of(const Action& action) {
    try {
        action();
    } catch (const hdf5::DamagedFile& damage) {
        return damage.fault();
    }
    return "none";
}

TEST(Read, TakesValuesTextsAndRows) {
    const TemporaryFolder folder;
    const hdf5::Handle file = hdf5::open_for_reading(written(folder));
    EXPECT_THAT(hdf5::read_values<std::int32_t>(file.id(), "inner/counts"), ElementsAre(4, 5, 6));
    EXPECT_THAT(hdf5::read_texts(file.id(), "words"), ElementsAre("ice", "Eis", "jää"));
    hdf5::RowReader<double> rows(file.id(), "table");
    EXPECT_EQ(rows.rows(), 3u);
    EXPECT_EQ(rows.width(), 2u);
    EXPECT_THAT(rows.read(1, 2), ElementsAre(3, 4, 5, 6));
    EXPECT_TRUE(rows.read(3, 0).empty());
    std::size_t width = 0;
    EXPECT_EQ(hdf5::read_table<double>(file.id(), "table", 3, width).size(), 6u);
    EXPECT_EQ(width, 2u);
}

TEST(Read, FindsNamesInGroups) {
    const TemporaryFolder folder;
    const hdf5::Handle file = hdf5::open_for_reading(written(folder));
    EXPECT_TRUE(hdf5::exists(file.id(), "inner/counts"));
    EXPECT_FALSE(hdf5::exists(file.id(), "inner/none"));
    EXPECT_FALSE(hdf5::exists(file.id(), "none/counts"));
    const hdf5::Paths paths = hdf5::paths_of(file.id());
    EXPECT_THAT(paths.groups, ElementsAre("/", "/inner"));
    EXPECT_THAT(paths.datasets, ElementsAre("/inner/counts", "/part", "/row", "/table", "/words"));
}

TEST(Read, SaysWhatDoesNotBelongThere) {
    const TemporaryFolder folder;
    const hdf5::Handle file = hdf5::open_for_reading(written(folder));
    const hdf5::QuietErrors quiet;
    EXPECT_THAT(fault_of([&] { hdf5::read_values<double>(file.id(), "none"); }), HasSubstr("none"));
    EXPECT_EQ(fault_of([&] { hdf5::read_values<double>(file.id(), "words"); }), "words has texts where numbers belong");
    EXPECT_EQ(fault_of([&] { hdf5::read_values<double>(file.id(), "inner/counts"); }), "inner/counts has another type");
    EXPECT_EQ(fault_of([&] { hdf5::read_column<std::int32_t>(file.id(), "inner/counts", 4); }),
              "inner/counts has 3 values where 4 belong");
    EXPECT_EQ(fault_of([&] { hdf5::read_numbers<std::int32_t>(file.id(), "inner/counts", 3, 0, 5); }),
              "inner/counts has the value 6, which there is not");
    EXPECT_EQ(fault_of([&] { hdf5::read_text(file.id(), "words"); }), "words has 3 values where 1 belong");
    std::size_t width = 0;
    EXPECT_EQ(fault_of([&] { hdf5::read_table<double>(file.id(), "table", 4, width); }),
              "table has 6 values where 4 belong");
    hdf5::RowReader<double> rows(file.id(), "table");
    EXPECT_EQ(fault_of([&] { rows.read(2, 2); }), "table ends before row 4");
}

TEST(Read, RefusesTextThatIsNotUtf8) {
    const TemporaryFolder folder;
    {
        const hdf5::Handle file = hdf5::create_file(folder / "b.h5");
        const hdf5::Scale row = hdf5::write_index_scale(file.id(), "row", "row", 1);
        hdf5::write_values(file.id(), {"words", "1", "words"}, {row}, std::vector<std::string>{"j\xe4\xe4"});
    }
    const hdf5::Handle file = hdf5::open_for_reading(folder / "b.h5");
    EXPECT_EQ(fault_of([&] { hdf5::read_texts(file.id(), "words"); }), "a text of words is not UTF-8");
}

TEST(Series, GrowsByWholeRowsAndEndsWithItsDigest) {
    const TemporaryFolder folder;
    {
        const hdf5::Handle file = hdf5::create_file(folder / "c.h5");
        const hdf5::Scale part = hdf5::write_index_scale(file.id(), "part", "part", 2);
        hdf5::Series<double> series(file.id(), {"frames", "m", "frames"}, {part}, 4);
        series.append(std::span<const double>(std::array{1.0, 2.0, 3.0, 4.0}));
        series.append(std::span<const double>(std::array{5.0, 6.0}));
        series.append(std::span<const double>());
        EXPECT_EQ(series.rows(), 3u);
        series.finish();
    }
    const hdf5::Handle file = hdf5::open_for_reading(folder / "c.h5");
    EXPECT_THAT(hdf5::read_values<double>(file.id(), "frames"), ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST(Rows, FillUpShortRowsAndThoseNeverWritten) {
    const TemporaryFolder folder;
    {
        const hdf5::Handle file = hdf5::create_file(folder / "d.h5");
        const hdf5::Scale row = hdf5::write_index_scale(file.id(), "row", "row", 3);
        const hdf5::Scale part = hdf5::write_index_scale(file.id(), "part", "part", 2);
        hdf5::Rows rows(file.id(), {"loads", "N", "loads"}, {row, part});
        rows.write(0, std::span<const double>(std::array{1.0, 2.0}));
        rows.write(2, std::span<const double>(std::array{3.0}));
        rows.finish();
    }
    const hdf5::Handle file = hdf5::open_for_reading(folder / "d.h5");
    const std::vector<double> loads = hdf5::read_values<double>(file.id(), "loads");  // which compares the digest
    EXPECT_THAT(loads, ElementsAre(1, 2, ::testing::IsNan(), ::testing::IsNan(), 3, ::testing::IsNan()));
}

}  // namespace read_test
}  // namespace floes
