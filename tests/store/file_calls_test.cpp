// Files that are put in the place of others.

#include "store/file_calls.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "support/file_bytes.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace file_calls_test {

namespace fs = std::filesystem;

class FileCalls : public testing::Test {
  protected:
    FileCalls() { fs::create_directory(folder_ / "elsewhere"); }

    fs::path write(const char* name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
        return folder_ / name;
    }

    const TemporaryFolder folder_;
};

TEST_F(FileCalls, ALinkStaysOneAndWhatItPointsToIsReplaced) {
    const fs::path link = folder_ / "campaign.h5";
    fs::create_symlink("elsewhere/real.h5", link);
    rename_into_place(write("aside", "first"), link);
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(file_text(folder_ / "elsewhere/real.h5"), "first") << "which was not there yet";
    const fs::path second = folder_ / "second.h5";
    fs::create_symlink(link, second);
    rename_into_place(write("aside", "again"), second);
    EXPECT_TRUE(fs::is_symlink(second));
    EXPECT_EQ(file_text(folder_ / "elsewhere/real.h5"), "again");
    EXPECT_FALSE(fs::exists(folder_ / "aside"));
}

TEST_F(FileCalls, WithoutALinkTheFileItselfIsReplaced) {
    const fs::path file = write("campaign.h5", "before");
    rename_into_place(write("aside", "after"), file);
    EXPECT_EQ(file_text(file), "after");
    EXPECT_EQ(target_of(file), file);
}

}  // namespace file_calls_test
}  // namespace floes
