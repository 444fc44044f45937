// floes --version.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

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
    CLI::App program("floes");
    program.require_subcommand(1);
    add_version(program);
    try {
        program.parse("--version");
        FAIL() << "went on";
    } catch (const CLI::ParseError& asked) {
        std::ostringstream out;
        EXPECT_EQ(program.exit(asked, out, out), 0);
        EXPECT_EQ(out.str(), version_text() + "\n");
    }
}

}  // namespace
}  // namespace floes
