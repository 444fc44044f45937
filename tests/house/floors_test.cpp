// The house stands: nobody includes upwards or sideways, every foreign library has one door, files stay small.

#include "house/floors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace floes::house {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::filesystem::path project{FLOES_SOURCE_DIR};

std::string read(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream{file}.rdbuf();
    return text.str();
}

TEST(House, EveryFileKeepsTheRules) {
    const auto files = source_files(project);
    ASSERT_GE(files.size(), 10u) << "the sources were not found under " << project;
    for (const auto& file : files) {
        for (const std::string& sentence : broken_rules(file.generic_string(), read(project / file))) {
            ADD_FAILURE() << sentence;
        }
    }
}

TEST(House, EveryFolderIsInTheTable) {
    for (const char* top : {"src", "ensemble"}) {
        for (const auto& entry : std::filesystem::directory_iterator(project / top)) {
            EXPECT_TRUE(entry.is_directory()) << entry.path() << " lies outside the rooms";
            EXPECT_TRUE(floors().contains(entry.path().filename().string()))
                << entry.path() << " has no floor; add it to floors() and to ARCHITECTURE.md";
        }
    }
}

TEST(BrokenRules, AllowLowerFloorsAndTheOwnRoom) {
    EXPECT_THAT(broken_rules("src/ice/field.cpp",
                             "#include \"ice/field.hpp\"\n#include <vector>\n"
                             "#include \"world/world.hpp\"\n#include <Eigen/Core>\n"),
                IsEmpty());
    EXPECT_THAT(broken_rules("ensemble/cli/run.cpp", "#include <cstdio>\n#include \"driver/driver.hpp\"\n"), IsEmpty());
}

TEST(BrokenRules, RefuseAnUpwardInclude) {
    EXPECT_THAT(
        broken_rules("src/world/world.cpp", "\n  #  include \"ice/field.hpp\"  // why not\n"),
        ElementsAre("src/world/world.cpp:2 includes \"ice/field.hpp\": world is on floor 3, ice on floor 4; only "
                    "lower floors may be used"));
}

TEST(BrokenRules, RefuseASidewaysInclude) {
    EXPECT_THAT(broken_rules("src/water/drag.cpp", "#include \"theory/plate.hpp\"\n"),
                ElementsAre(HasSubstr("water is on floor 3, theory on floor 3")));
}

TEST(BrokenRules, RefuseAnIncludeThatIsNoRoom) {
    EXPECT_THAT(
        broken_rules("src/water/drag.cpp", "#include \"drag.hpp\"\n#include \"../core/id.hpp\"\n#include \"core\"\n"),
        ElementsAre(HasSubstr("\"drag.hpp\", which is not"), HasSubstr("\"../core/id.hpp\", which is not"),
                    HasSubstr("\"core\", which is not")));
}

TEST(BrokenRules, RefuseAForeignLibraryOutsideItsDoor) {
    const std::string all =
        "#include <btBulletDynamicsCommon.h>\n#include <BulletDynamics/Dynamics/btDynamicsWorld.h>\n"
        "#include <LinearMath/btVector3.h>\n#include <toml++/toml.h>\n#include <mpi.h>\n#include <hdf5.h>\n"
        "#include <hdf5_hl.h>\n#include \"hdf5.h\"\n";
    EXPECT_EQ(broken_rules("ensemble/driver/crew.cpp", all).size(), 9u);  // the last one twice: it is no room either
    EXPECT_THAT(broken_rules("src/world/world.cpp", "#include <btBulletDynamicsCommon.h>\n"), IsEmpty());
    EXPECT_THAT(broken_rules("src/keys/reader.cpp", "#include <toml++/toml.h>\n"), IsEmpty());
    EXPECT_THAT(broken_rules("ensemble/wire/mpi_link.cpp", "#include <mpi.h>\n"), IsEmpty());
    EXPECT_THAT(broken_rules("ensemble/hdf5/group.cpp", "#include <hdf5.h>\n#include <hdf5_hl.h>\n"), IsEmpty());
}

TEST(BrokenRules, RefuseFilesAndOutputInThePhysics) {
    const std::string text = "#include <fstream>\n#include <iostream>\n#include <cstdio>\n#include <stdio.h>\n";
    EXPECT_EQ(broken_rules("src/member/run_member.cpp", text).size(), 4u);
    EXPECT_THAT(broken_rules("ensemble/cli/run.cpp", text), IsEmpty());
}

TEST(BrokenRules, RefuseALongFile) {
    std::string text;
    for (int line = 0; line < 300; ++line) text += "// one more\n";
    EXPECT_THAT(broken_rules("src/core/id.hpp", text), IsEmpty());
    EXPECT_THAT(broken_rules("src/core/id.hpp", text + "// too many\n"), ElementsAre(HasSubstr("301 lines")));
}

TEST(BrokenRules, IgnoreCommentsAboutIncludes) {
    EXPECT_THAT(broken_rules("src/core/id.hpp", "// #include \"cli/commands.hpp\"\n"), IsEmpty());
}

}  // namespace
}  // namespace floes::house
