#include "run/signals.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace floes {
namespace signals_test {

TEST(StopSignals, RememberTheFirst) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU, SIGQUIT, SIGALRM}) {
        const StopSignals signals;
        EXPECT_EQ(signals.received(), 0);
        std::raise(signal);
        EXPECT_EQ(signals.received(), signal);
        std::raise(SIGTERM);  // the same request, delivered twice by timeout(1) and the like
        EXPECT_EQ(signals.received(), signal);
    }
}

TEST(StopSignals, GiveBackWhatWasThere) {
    struct sigaction before {};
    ::sigaction(SIGTERM, nullptr, &before);
    {
        const StopSignals signals;
        struct sigaction during {};
        ::sigaction(SIGTERM, nullptr, &during);
        EXPECT_NE(during.sa_handler, before.sa_handler);
    }
    struct sigaction after {};
    ::sigaction(SIGTERM, nullptr, &after);
    EXPECT_EQ(after.sa_handler, before.sa_handler);
}

TEST(StopSignals, WithinOthersSeeWhatCameBefore) {
    const StopSignals outer;
    std::raise(SIGTERM);
    {
        const StopSignals inner;
        EXPECT_EQ(inner.received(), SIGTERM);
    }
    EXPECT_EQ(outer.received(), SIGTERM);
}

TEST(StopSignals, AreCalledByTheirNames) {
    EXPECT_EQ(signal_name(SIGXCPU), "SIGXCPU");
    EXPECT_EQ(signal_name(SIGUSR2), "SIGUSR2");
}

TEST(StopSignals, LeaveWhatIsToBeIgnored) {
    for (const int signal : {SIGHUP, SIGUSR2}) {  // as nohup does, and our array scripts
        std::signal(signal, SIG_IGN);
        {
            const StopSignals signals;
            std::raise(signal);
            EXPECT_EQ(signals.received(), 0);
        }
        std::signal(signal, SIG_DFL);
    }
}

// The system sends SIGXCPU again for each second of processor time, of all threads together.
TEST(StopSignals, AreOneRequestWhileTheLimitOfProcessorTimeIsPassed) {
    const StopSignals signals;
    std::raise(SIGXCPU);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    std::raise(SIGXCPU);
    EXPECT_EQ(signals.received(), SIGXCPU);
}

TEST(StopSignalsDeathTest, LeaveAtOnceOnTheSecond) {
    EXPECT_EXIT(
        {
            const StopSignals signals;
            std::raise(SIGTERM);
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
            std::raise(SIGTERM);
            std::this_thread::sleep_for(std::chrono::seconds(10));
        },
        testing::ExitedWithCode(exit_stopped), "second signal");
}

}  // namespace signals_test
}  // namespace floes
