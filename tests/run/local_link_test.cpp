#include "run/link.hpp"

#include <cstdlib>

#include "core/error.hpp"
#include "core/trial.hpp"
#include "run/link_contract.hpp"

namespace floes {
namespace local_link_test {

TEST(LocalLink, DeliversWhatIsSent) {
    LocalLink link;
    EXPECT_EQ(link.rank(), 0);
    EXPECT_EQ(link.size(), 1);
    contract::everybody_writes_to_everybody(link);
    EXPECT_FALSE(link.moving());
}

TEST(LocalLink, KnowsNoOtherRank) {
    LocalLink link;
    EXPECT_THROW(link.send(1, Tag::assign, {}), RunError);
}

TEST(LocalLink, UsesEveryCoreOfItsMask) {
    LocalLink link;
    EXPECT_EQ(link.topology().cores, count_cores(affinity_of_this_process()));
}

TEST(OpenLink, IsLocalUnlessMpiStartedTheProcess) {
    ASSERT_FALSE(started_by_mpi());
    EXPECT_EQ(open_link()->size(), 1);
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"}) {
        ::setenv(name, "1", 1);
        EXPECT_TRUE(started_by_mpi()) << name;
        ::unsetenv(name);
    }
}

TEST(LibraryVersion, NamesTheLibraryWithoutStartingIt) {
    EXPECT_NE(library_version().find("MPI"), std::string::npos);
}

}  // namespace local_link_test
}  // namespace floes
