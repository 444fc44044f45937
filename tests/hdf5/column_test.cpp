// Columns that get their rows one by one hold what is written whole.

#include "core/contract.hpp"
#include "hdf5/columns.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "hdf5/dataset.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace column_test {

constexpr std::size_t rows = 20'000;  // several chunks, the last one in part
constexpr std::size_t width = 3;

std::string digest_in(hid_t file, const char* path) {
    const hdf5::Handle dataset(H5Dopen2(file, path, H5P_DEFAULT), H5Dclose, "H5Dopen", path);
    const auto stored = hdf5::read_digest(dataset.id());
    EXPECT_EQ(stored->hex, hdf5::digest_of(dataset, hdf5::DigestKind::values).hex) << path;
    return stored->hex;
}

TEST(Column, HoldsWhatIsWrittenWhole) {
    const TemporaryFolder folder;
    std::vector<double> values(rows * width);
    std::iota(values.begin(), values.end(), 0.5);
    values[4] = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::string> texts;
    for (std::size_t k = 0; k < rows; ++k) texts.push_back(std::string(k % 7, 'x'));
    const auto write = [&](const char* name, bool in_rows) {
        const hdf5::Handle file = hdf5::create_file(folder / name);
        const hdf5::Scale row = hdf5::write_index_scale(file.id(), "row", "row", rows);
        const hdf5::Scale part = hdf5::write_index_scale(file.id(), "part", "part", width);
        const hdf5::Label numbers{"numbers", "1", "numbers"};
        const hdf5::Label words{"words", "1", "words"};
        if (in_rows) {
            hdf5::Column<double> column(file.id(), numbers, {row, part}, std::numeric_limits<double>::quiet_NaN());
            hdf5::TextColumn text(file.id(), words, {row});
            for (std::size_t k = 0; k < rows; ++k) {
                column.add(std::span<const double>(values).subspan(k * width, width));
                text.add(texts[k]);
            }
            column.finish();
            text.finish();
        } else {
            hdf5::write_values(file.id(), numbers, {row, part}, values);
            hdf5::write_values(file.id(), words, {row}, texts);
        }
        return digest_in(file.id(), "/numbers") + digest_in(file.id(), "/words");
    };
    EXPECT_EQ(write("rows.h5", true), write("whole.h5", false));
}

TEST(Column, IsNotFinishedBeforeItsLastRow) {
    const TemporaryFolder folder;
    const hdf5::Handle file = hdf5::create_file(folder / "a.h5");
    const hdf5::Scale row = hdf5::write_index_scale(file.id(), "row", "row", 2);
    hdf5::Column<std::int32_t> column(file.id(), {"numbers", "1", "numbers"}, {row});
    column.add(1);
    EXPECT_THROW(column.finish(), ContractError);
    column.add(2);
    column.finish();
}

}  // namespace column_test
}  // namespace floes
