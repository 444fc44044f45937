// What a library does to a damaged file is tried out in a child first.

#include "core/trial.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

namespace floes {
namespace trial_test {

TEST(Trial, SaysWhichSignalEndedTheWork) {
    EXPECT_EQ(signal_of_trial([] {}), 0);
    EXPECT_EQ(signal_of_trial([] { throw std::runtime_error("damaged"); }), 0) << "an error is none";
    EXPECT_EQ(signal_of_trial([] { std::raise(SIGSEGV); }), SIGSEGV);
    EXPECT_EQ(signal_of_trial([] { std::raise(SIGABRT); }), SIGABRT);
}

TEST(Trial, LeavesTheProcessAsItIs) {
    int value = 1;
    signal_of_trial([&] { value = 2; });
    EXPECT_EQ(value, 1);
}

}  // namespace trial_test
}  // namespace floes
