#pragma once
// The message of a refusal.

#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"

namespace floes {

/// Runs the action and gives the message of the InputError that it must throw.
template <class Action>
std::string refusal(const Action& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    ADD_FAILURE() << "not refused";
    return {};
}

}  // namespace floes
