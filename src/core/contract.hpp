#pragma once
// What a function expects of whoever calls it, and what it ensures: said once at its head or before it returns, where
// the compiler reads it too. Checked in builds with assertions (the presets dev, asan and tsan); in release the
// condition is compiled and never evaluated. Only for mistakes of the program: what a user can get wrong is an
// InputError.
//
//     FLOES_EXPECTS(step > 0);
//     FLOES_ENSURES(std::isfinite(load));

#include <stdexcept>

#include <fmt/format.h>

namespace floes {

/// A broken contract; what() gives file, line and condition.
struct ContractError : std::logic_error {
    using std::logic_error::logic_error;
};

[[noreturn]] inline void contract_broken(const char* kind, const char* condition, const char* file, int line) {
    throw ContractError(fmt::format("{}:{}: {} {}", file, line, kind, condition));
}

}  // namespace floes

#ifdef NDEBUG
#define FLOES_CONTRACT(kind, ...) static_cast<void>(sizeof((__VA_ARGS__) ? 1 : 0))
#else
#define FLOES_CONTRACT(kind, ...) \
    ((__VA_ARGS__) ? static_cast<void>(0) : floes::contract_broken(kind, #__VA_ARGS__, __FILE__, __LINE__))
#endif
#define FLOES_EXPECTS(...) FLOES_CONTRACT("expects", __VA_ARGS__)
#define FLOES_ENSURES(...) FLOES_CONTRACT("ensures", __VA_ARGS__)
