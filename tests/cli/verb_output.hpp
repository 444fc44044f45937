#pragma once
// What a verb prints, for tests of verbs.

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "cli/commands.hpp"

namespace floes {

/// Standard output of the command line where `add` adds the verb: "VERB arguments…", or a vector of these words, the
/// last one first, as CLI11 takes them. Expects exit status 0; throws what main() would turn into another one.
template <class CommandLine>
std::string verb_output(void (*add)(CLI::App&, int&), CommandLine command_line) {
    CLI::App program("floes");
    int exit_status = -1;
    add(program, exit_status);
    testing::internal::CaptureStdout();
    try {
        program.parse(std::move(command_line));
    } catch (...) {
        testing::internal::GetCapturedStdout();
        throw;
    }
    EXPECT_EQ(exit_status, 0);
    return testing::internal::GetCapturedStdout();
}

}  // namespace floes
