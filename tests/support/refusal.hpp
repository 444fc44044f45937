#pragma once
// The message of a refusal.

#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"

namespace floes {

/// Runs the action and gives the message of the InputError that it throws, `otherwise` if it throws none.
template <class Action>
std::string refusal_or(const std::string& otherwise, const Action& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return otherwise;
}

/// Of one that must throw it.
template <class Action>
std::string refusal(const Action& action) {
    std::string told = refusal_or("", action);
    EXPECT_NE(told, "") << "not refused";
    return told;
}

}  // namespace floes
