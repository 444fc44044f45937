#pragma once
// The three kinds of errors. Every message is a sentence: what is wrong, where, what is allowed, what to try.

#include <stdexcept>
#include <string>

namespace floes {

/// The user's input cannot be used (exit status 2).
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The run cannot continue: a file, a rank or the machine failed (exit status 1).
class RunError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The state of one member became meaningless; the member is set aside, the campaign continues.
class MemberFailure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace floes
