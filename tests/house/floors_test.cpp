// The house stands: nobody includes upwards, sideways or in a ring, every foreign library has its doors, files stay
// small, and what CMakeLists.txt and ARCHITECTURE.md say of it is so.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "house/cycles.hpp"
#include "house/names.hpp"
#include "house/rules.hpp"

namespace floes::house {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::filesystem::path project{FLOES_SOURCE_DIR};

void expect_none(const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) ADD_FAILURE() << sentence;
}

TEST(House, EveryFileKeepsTheRules) {
    const std::vector<Source> files = sources_of(project);
    ASSERT_GE(files.size(), 10u) << "the sources were not found under " << project;
    for (const Source& file : files) expect_none(broken_rules(file));
}

TEST(House, RoomsDeclaredAreRoomsIncluded) {
    expect_none(broken_edges(text_of(project / "CMakeLists.txt"), sources_of(project)));
}

TEST(House, NoFilesIncludeEachOther) {
    expect_none(cycles_of(sources_of(project)));
}

TEST(House, EveryClassHasANameOfItsOwn) {
    expect_none(shared_names(sources_of(project)));
}

TEST(House, ArchitectureDrawsTheSameTable) {
    const std::vector<Room> drawn = drawn_rooms(text_of(project / "ARCHITECTURE.md"));
    ASSERT_EQ(drawn.size(), rooms().size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        EXPECT_EQ(drawn[i].floor, rooms()[i].floor) << drawn[i].name;
        EXPECT_EQ(drawn[i].name, rooms()[i].name);
        EXPECT_EQ(drawn[i].doors, rooms()[i].doors) << drawn[i].name;
        EXPECT_EQ(drawn[i].wing, rooms()[i].wing) << drawn[i].name;
    }
}

TEST(House, EveryDoorIsUsed) {
    const std::vector<Source> files = sources_of(project);
    for (const Library& library : libraries()) {
        for (const Room& room : rooms()) {
            if (room.doors.find(library.name) == std::string::npos) continue;
            const auto uses = [&](const Source& file) {
                return room_of(file.path) == room.name &&
                       std::ranges::any_of(includes_of(file.text), [&](const Include& include) {
                           return include.foreign && std::regex_match(include.header, library.header);
                       });
            };
            EXPECT_TRUE(std::ranges::any_of(files, uses))
                << room.name << " has a door to " << library.name << " that no file of it uses";
        }
    }
}

TEST(House, EveryFolderIsInTheTable) {
    std::vector<std::filesystem::path> folders{project / "src"};
    for (const auto& entry : std::filesystem::directory_iterator(project / "ensemble")) {
        ASSERT_TRUE(entry.is_directory()) << entry.path() << " lies outside the rooms";
        if (entry.path().filename() != "cli") folders.push_back(entry.path());  // a room and a wing by itself
    }
    for (const auto& folder : folders) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            EXPECT_TRUE(entry.is_directory()) << entry.path() << " lies outside the rooms";
            const Room* room = find_room(entry.path().filename().string());
            ASSERT_NE(room, nullptr) << entry.path() << " has no floor; add it to rooms() and to ARCHITECTURE.md";
            EXPECT_EQ(room->wing, folder.filename()) << entry.path();
        }
    }
}

std::vector<std::string> broken_by(const std::string& path, const std::string& text) {
    return broken_rules({path, text});
}

TEST(BrokenRules, AllowLowerFloorsAndTheOwnRoom) {
    EXPECT_THAT(broken_by("src/ice/field.cpp",
                          "#include \"ice/field.hpp\"\n#include <vector>\n"
                          "#include \"world/world.hpp\"\n#include <fmt/format.h>\n"),
                IsEmpty());
    EXPECT_THAT(broken_by("ensemble/cli/run.cpp", "#include <cstdio>\n#include \"driver/driver.hpp\"\n"), IsEmpty());
}

TEST(BrokenRules, RefuseAnUpwardInclude) {
    EXPECT_THAT(
        broken_by("src/world/world.cpp", "\n  #  include \"ice/field.hpp\"  // why not\n"),
        ElementsAre("src/world/world.cpp:2 includes \"ice/field.hpp\": world is on floor 3, ice on floor 4; only "
                    "lower floors may be used"));
}

TEST(BrokenRules, RefuseBoostInAHeader) {
    const std::string text = "#include <boost/math/distributions/normal.hpp>\n";
    EXPECT_THAT(broken_by("src/laws/law.hpp", text), ElementsAre(HasSubstr("include it in a .cpp")));
    EXPECT_THAT(broken_by("src/laws/law.cpp", text), IsEmpty());
}

TEST(BrokenRules, RefuseASidewaysInclude) {
    EXPECT_THAT(broken_by("src/water/drag.cpp", "#include \"theory/plate.hpp\"\n"),
                ElementsAre(HasSubstr("water is on floor 3, theory on floor 3")));
}

TEST(BrokenRules, RefuseAnIncludeOfAHigherWing) {
    EXPECT_THAT(
        broken_by("ensemble/learn/match/matching.cpp", "#include \"driver/master.hpp\"\n"),
        ElementsAre("ensemble/learn/match/matching.cpp:1 includes \"driver/master.hpp\": match is in wing learn, "
                    "driver in wing run; only lower wings may be used"));
}

TEST(BrokenRules, RefuseAnIncludeThatIsNoRoom) {
    EXPECT_THAT(
        broken_by("src/water/drag.cpp", "#include \"drag.hpp\"\n#include \"../core/id.hpp\"\n#include \"core\"\n"),
        ElementsAre(HasSubstr("\"drag.hpp\", which is not"), HasSubstr("\"../core/id.hpp\", which is not"),
                    HasSubstr("\"core\", which is not")));
}

TEST(BrokenRules, RefuseAForeignLibraryOutsideItsDoor) {
    const std::string all =
        "#include <btBulletDynamicsCommon.h>\n#include <BulletDynamics/Dynamics/btDynamicsWorld.h>\n"
        "#include <LinearMath/btVector3.h>\n#include <toml++/toml.h>\n#include <mpi.h>\n#include <hdf5.h>\n"
        "#include <hdf5_hl.h>\n#include \"hdf5.h\"\n";
    EXPECT_EQ(broken_by("ensemble/plan/schedule/scheduler.cpp", all).size(), 8u);
    EXPECT_THAT(broken_by("src/world/world.cpp", "#include <btBulletDynamicsCommon.h>\n"), IsEmpty());
    EXPECT_THAT(broken_by("src/keys/reader.cpp", "#include <toml++/toml.h>\n"), IsEmpty());
    EXPECT_THAT(broken_by("ensemble/run/wire/mpi_link.cpp", "#include <mpi.h>\n"), IsEmpty());
    EXPECT_THAT(broken_by("ensemble/store/hdf5/group.cpp", "#include <hdf5.h>\n#include <hdf5_hl.h>\n"), IsEmpty());
    EXPECT_THAT(broken_by("src/ice/field.cpp", "#include <boost/crc.hpp>\n"),
                ElementsAre("src/ice/field.cpp:1 includes <boost/crc.hpp>; Boost comes in by laws, statistics, theory, "
                            "campaign, journal, inference, match only"));
}

TEST(BrokenRules, EveryLibraryHasADoorAndIsRefusedElsewhere) {
    for (const char* header : {"Random123/philox.h", "xxhash.h", "zlib.h", "Eigen/Dense", "boost/crc.hpp",
                               "CLI/CLI.hpp", "nlohmann/json.hpp", "tbb/parallel_for.h", "nlopt.h", "unistd.h"}) {
        const auto library =
            std::ranges::find_if(libraries(), [&](const Library& one) { return std::regex_match(header, one.header); });
        ASSERT_NE(library, libraries().end()) << header;
        EXPECT_NE(rooms_with_door(*library), "") << header;
        EXPECT_EQ(broken_by("ensemble/plan/schedule/scheduler.cpp", fmt::format("#include <{}>\n", header)).size(), 1u);
    }
    for (const Room& room : rooms())
        EXPECT_THAT(broken_by("src/" + room.name + "/a.cpp", "#include <fmt/format.h>\n"), IsEmpty());
}

TEST(BrokenRules, RefuseAHeaderOfNoKnownLibrary) {
    EXPECT_THAT(broken_by("ensemble/cli/run.cpp", "#include <curl/curl.h>\n#include <math.h>\n"),
                ElementsAre("ensemble/cli/run.cpp:1 includes <curl/curl.h>; no library of tests/house/floors.cpp has "
                            "such a header",
                            HasSubstr("<math.h>")));
}

TEST(BrokenRules, RefuseFilesAndOutputInThePhysics) {
    const std::string text = "#include <fstream>\n#include <iostream>\n#include <cstdio>\n";
    EXPECT_EQ(broken_by("src/member/run_member.cpp", text + "#include <stdio.h>\n").size(), 4u);
    EXPECT_THAT(broken_by("ensemble/cli/run.cpp", text), IsEmpty());
}

TEST(BrokenRules, RefuseALongFile) {
    std::string text;
    for (int line = 0; line < 300; ++line) text += "// one more\n";
    EXPECT_THAT(broken_by("src/core/id.hpp", text), IsEmpty());
    EXPECT_THAT(broken_by("src/core/id.hpp", text + "// too many\n"), ElementsAre(HasSubstr("301 lines")));
}

TEST(BrokenRules, IgnoreCommentsAboutIncludes) {
    EXPECT_THAT(broken_by("src/core/id.hpp", "// #include \"cli/commands.hpp\"\n"), IsEmpty());
}

TEST(BrokenEdges, NameRoomAndEdge) {
    const std::vector<Source> sources{{"src/core/id.hpp", "#include <vector>\n"},
                                      {"src/ice/field.cpp", "#include \"ice/field.hpp\"\n#include \"core/id.hpp\"\n"},
                                      {"src/member/run.cpp", "\n#include \"ice/field.hpp\"\n"}};
    const auto broken_with = [&](const std::string& ice, const std::string& member) {
        return broken_edges("floes_room(src/core LIBRARIES ice)\nfloes_room(src/ice " + ice +
                                ")\nfloes_room(src/member " + member + ")\n",
                            sources);
    };
    EXPECT_THAT(broken_with("ROOMS core", "ROOMS ice PRIVATE core"), IsEmpty());
    EXPECT_THAT(broken_with("", "ROOMS ice\n  core"),
                ElementsAre("ice includes core at src/ice/field.cpp:2, and CMakeLists.txt does not declare it",
                            "CMakeLists.txt declares that member uses core, and no file of member includes it"));
    EXPECT_THAT(broken_edges("floes_room(src/core)\n# floes_room(src/ice ROOMS core)\nfloes_room(src/member ROOMS ice)",
                             sources),
                ElementsAre("CMakeLists.txt has no floes_room() for ice"));
}

TEST(CyclesOf, NameTheUnitsInOrder) {
    const std::vector<Source> ring{{"src/ice/a.hpp", "#include \"ice/b.hpp\"\n"},
                                   {"src/ice/a.cpp", "#include \"ice/a.hpp\"\n#include \"ice/d.hpp\"\n"},
                                   {"src/ice/b.cpp", "#include \"ice/b.hpp\"\n#include \"ice/c.hpp\"\n"},
                                   {"src/ice/c.hpp", "#include \"ice/a.hpp\"\n#include <vector>\n"},
                                   {"src/ice/d.hpp", "#include \"core/id.hpp\"\n"}};
    EXPECT_THAT(cycles_of(ring),
                ElementsAre("these files include each other in a ring: ice/a -> ice/b -> ice/c -> ice/a"));
}

TEST(ClassesOf, AreThoseThatOthersSee) {
    EXPECT_THAT(classes_of(R"(
namespace floes {
class Told;  // struct Said {
template <class Value, int n = (2 > 1)>
class Kept final : public Base<Value> { struct Inner {}; enum class Kind { a }; };
enum class Mode : std::int8_t { one };
namespace { struct Hidden {}; }
void f() { struct Local {}; const char* text = "class Quoted {"; }
namespace hdf5 { struct [[nodiscard]] Handle {}; }
}
)"),
                ElementsAre("floes::Kept", "floes::Mode", "floes::hdf5::Handle"));
}

TEST(SharedNames, AreFoundAcrossRooms) {
    const std::vector<Source> sources{
        {"src/ice/part.hpp", "namespace floes {\nstruct Part {};\n}\n"},
        {"src/ice/part.cpp", "namespace floes {\nclass Part::State {};\nstruct Piece {};\n}\n"},
        {"src/world/parts.hpp", "namespace floes {\nclass Part {};\n}\n"}};
    EXPECT_THAT(shared_names(sources), ElementsAre("floes::Part is a class of src/ice/part and of src/world/parts"));
}

TEST(DrawnRooms, AreTheRowsOfTheTables) {
    EXPECT_THAT(drawn_rooms("`src/` is ice.\n\n| floor | room | what | door to |\n|---|---|---|---|\n"
                            "| 2 | `ice` | `x`, y | |\n`ensemble/cli/`\n| 10 | `cli` | verbs | A, B c |\n"),
                ElementsAre(Room{2, "ice", "", "src"}, Room{10, "cli", "A, B c", "cli"}));
}

}  // namespace
}  // namespace floes::house
