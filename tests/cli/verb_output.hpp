#pragma once
// What a verb prints, for tests of verbs.

#include <gtest/gtest.h>

#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.hpp"

namespace floes {

/// "a b  c" -> a, b, c.
inline std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

/// Standard output of the command line "VERB arguments…" where `add` adds the verb, and its exit status. Throws what
/// main() would turn into another one.
inline std::pair<std::string, int> verb_answer(void (*add)(CommandLine&), const std::vector<std::string>& words) {
    CommandLine line;
    add(line);
    int status = -1;
    testing::internal::CaptureStdout();
    try {
        status = line.run(words);
    } catch (...) {
        testing::internal::GetCapturedStdout();
        throw;
    }
    return {testing::internal::GetCapturedStdout(), status};
}

/// The same; expects exit status 0.
inline std::string verb_output(void (*add)(CommandLine&), const std::vector<std::string>& words) {
    const auto [output, status] = verb_answer(add, words);
    EXPECT_EQ(status, 0);
    return output;
}

inline std::string verb_output(void (*add)(CommandLine&), const std::string& words) {
    return verb_output(add, words_of(words));
}

}  // namespace floes
