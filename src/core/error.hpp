#pragma once
// The three kinds of errors. Every message is a sentence: what is wrong, where, what is allowed, what to try. It is
// given as it is, or as fmt::format() takes it.

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace floes {

/// What the three have in common.
class ToldError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;

    template <class... Values>
    requires(sizeof...(Values) > 0) ToldError(fmt::format_string<Values...> sentence, Values&&... values)
        : std::runtime_error(fmt::format(sentence, std::forward<Values>(values)...)) {}
};

/// The user's input cannot be used (exit status 2).
class InputError : public ToldError {
  public:
    using ToldError::ToldError;
};

/// The run cannot continue: a file, a rank or the machine failed (exit status 1).
class RunError : public ToldError {
  public:
    using ToldError::ToldError;
};

/// The state of one member became meaningless; the member is set aside, the campaign continues.
class MemberFailure : public ToldError {
  public:
    using ToldError::ToldError;
};

}  // namespace floes
