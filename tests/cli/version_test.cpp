// floes --version.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/commands.hpp"
#include "records/build_info.hpp"

namespace floes {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Version, NamesProgramRevisionLibrariesAndLanes) {
    const std::string text = version_text();
    EXPECT_THAT(text, StartsWith("floes " + floes_version() + "\n"));
    EXPECT_THAT(text, HasSubstr("\ngit_revision: " + git_revision() + "\n"));
    for (const char* library : {"\nbullet: ", "\nhdf5: ", "\nmpi: ", "\nlane_widths: 1"})
        EXPECT_THAT(text, HasSubstr(library));
}

TEST(Version, IsAskedForWithoutAVerbAndEndsWell) {
    CommandLine line;
    add_verbs(line, {});
    try {
        line.run({"--version"});
        FAIL() << "went on";
    } catch (const CommandLineEnd& asked) {
        EXPECT_EQ(asked.status(), 0);
        EXPECT_EQ(asked.output(), version_text() + "\n");
    }
}

}  // namespace
}  // namespace floes
