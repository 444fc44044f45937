#include "store/session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace floes {
namespace session_test {

using testing::ElementsAre;
using testing::IsEmpty;

Session session_with(std::vector<Software> software) {
    Session session;
    session.software = std::move(software);
    return session;
}

TEST(Session, NamesThePathOfTheMathLibrary) {
    EXPECT_THAT(version_of(describe_session(1, 1, {}), "math_library"), testing::StartsWith("glibc 2."));
}

TEST(Session, TellsWhatMayChangeTheLastBits) {
    const Session now = session_with(
        {{"git_revision", "b"}, {"bullet", "3.24"}, {"math_library", "glibc 2.36 with FMA"}, {"floes", "3.1.0"}});
    EXPECT_THAT(changed_software(now, now), IsEmpty());
    Session before = now;
    before.software[0].version = "a";
    before.software[2].version = "glibc 2.36 without FMA";
    before.software[3].version = "3.0.0";
    EXPECT_THAT(changed_software(before, now),
                ElementsAre("floes: 3.0.0 before, 3.1.0 now", "git_revision: a before, b now",
                            "math_library: glibc 2.36 without FMA before, glibc 2.36 with FMA now"));
}

TEST(Session, HostsAndOtherLibrariesMayChange) {
    Session before = session_with({{"hdf5", "1.10.7"}});
    before.host = "a";
    EXPECT_THAT(changed_software(before, session_with({{"hdf5", "1.10.8"}})), IsEmpty());
}

}  // namespace session_test
}  // namespace floes
