// The link over MPI on any number of ranks started by mpirun. MPI starts once in a process, so all tests share one
// link.

#include "run/link.hpp"

#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "run/link_contract.hpp"

namespace floes {
namespace mpi_link_test {

Link* link = nullptr;

using Handler = void (*)(int);

std::vector<Handler> handlers_before_mpi;

std::vector<Handler> crash_handlers() {
    std::vector<Handler> handlers;
    for (const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) {
        struct sigaction action {};
        EXPECT_EQ(::sigaction(signal, nullptr, &action), 0);
        handlers.push_back(action.sa_handler);
    }
    return handlers;
}

double cpu_seconds() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// A variable of Open MPI's mpirun, or the one of MPICH's.
std::string told_by_mpirun(const char* open_mpi, const char* mpich) {
    if (const char* told = std::getenv(open_mpi)) return told;
    const char* told = std::getenv(mpich);
    return told != nullptr ? told : "not told";
}

TEST(MpiLink, KnowsItsPlace) {
    EXPECT_EQ(std::to_string(link->size()), told_by_mpirun("OMPI_COMM_WORLD_SIZE", "PMI_SIZE"));
    EXPECT_EQ(std::to_string(link->rank()), told_by_mpirun("OMPI_COMM_WORLD_RANK", "PMI_RANK"));
    EXPECT_EQ(link->topology().node_ranks, link->size());
}

TEST(MpiLink, DividesTheCoresOfTheNode) {
    // Unbound ranks of one node: together they have every core, or one each when there are more ranks than cores.
    for (int to = 0; to < link->size(); ++to) {
        link->send(to, Tag::hello, std::vector<std::byte>(static_cast<std::size_t>(link->topology().cores)));
    }
    int sum = 0;
    for (int n = 0; n < link->size(); ++n) sum += static_cast<int>(contract::wait_for_message(*link)->bytes.size());
    EXPECT_EQ(sum, std::max(link->size(), link->topology().bound_cores));
}

TEST(MpiLink, DeliversWhatIsSent) {
    contract::everybody_writes_to_everybody(*link);
}

TEST(MpiLink, RefusesARankThatIsNotThere) {
    EXPECT_THROW(link->send(link->size(), Tag::assign, {}), RunError);
}

// Open MPI's handler of crashes may wait for ever.
TEST(MpiLink, LeavesCrashesAlone) {
    EXPECT_EQ(crash_handlers(), handlers_before_mpi);
}

TEST(MpiLink, WaitingCostsAlmostNothing) {
    const double before = cpu_seconds();
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    while (std::chrono::steady_clock::now() < end) {
        EXPECT_FALSE(link->poll());
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_LT(cpu_seconds() - before, 0.2);
}

}  // namespace mpi_link_test
}  // namespace floes

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    floes::mpi_link_test::handlers_before_mpi = floes::mpi_link_test::crash_handlers();
    const std::unique_ptr<floes::Link> link = floes::open_link(60);
    floes::mpi_link_test::link = link.get();
    return RUN_ALL_TESTS();
}
