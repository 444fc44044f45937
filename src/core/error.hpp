#pragma once
// What can go wrong, in three words. Every message is a sentence: what is wrong, where, what is allowed, what to try.

#include <stdexcept>
#include <string>

namespace floes {

/// The user's input cannot be used (exit status 2).
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The run cannot go on: a file, a rank or the machine failed (exit status 1).
class RunError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// One member left the range where its numbers mean anything; the member is set aside, the campaign goes on.
class MemberFailure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace floes
