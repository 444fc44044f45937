#pragma once
// What a verb prints, for tests of verbs.

#include <gtest/gtest.h>

#include <string>

#include "cli/commands.hpp"

namespace floes {

/// Standard output of the command line "VERB arguments…" where `add` adds the verb. Expects exit status 0; throws what
/// main() would turn into another one.
inline std::string verb_output(void (*add)(CLI::App&, int&), const std::string& command_line) {
    CLI::App program("floes");
    int exit_status = -1;
    add(program, exit_status);
    testing::internal::CaptureStdout();
    try {
        program.parse(command_line);
    } catch (...) {
        testing::internal::GetCapturedStdout();
        throw;
    }
    EXPECT_EQ(exit_status, 0);
    return testing::internal::GetCapturedStdout();
}

}  // namespace floes
