#pragma once
// The border to a host, a C program: no exception crosses it, and the host's floating-point mode stays its own.

#include <cfenv>
#include <cstddef>
#include <cstring>
#include <exception>
#include <functional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/bytes.hpp"
#include "core/error.hpp"
#include "fmi/session.hpp"

namespace floes {

/// The statuses that both versions of FMI have, with the same numbers.
enum FmiStatus : int { fmi_ok, fmi_warning, fmi_discard, fmi_error, fmi_fatal };

/// A function that the library exports.
#define FLOES_FMI extern "C" __attribute__((visibility("default")))

/// Rounds to the nearest and traps nothing as long as it lives, whatever the host does.
class OwnFloatingPoint {
  public:
    OwnFloatingPoint() {
        std::fegetenv(&host_);
        std::fesetenv(FE_DFL_ENV);
    }
    OwnFloatingPoint(const OwnFloatingPoint&) = delete;
    OwnFloatingPoint& operator=(const OwnFloatingPoint&) = delete;
    ~OwnFloatingPoint() { std::fesetenv(&host_); }

  private:
    std::fenv_t host_{};
};

/// Writes to the host's log: the name of an instance, a status and a sentence.
using FmiLog = std::function<void(const char* name, FmiStatus status, const std::string& sentence)>;

/// What hosts hold a pointer to.
struct FmiInstance {
    std::string name;
    FmiLog log;
    FmuSession session;
    bool over = false;  ///< the last step was one that ends after the run
};

/// What `action` returns; where it throws, an error with the sentence in the log of the instance called `name`.
template <class Action>
FmiStatus answered(const FmiLog& log, const char* name, Action action) noexcept {
    const OwnFloatingPoint mode;
    try {
        return action();
    } catch (const std::exception& error) {
        log(name, fmi_error, error.what());
    } catch (...) {
        log(name, fmi_error, "something unknown went wrong.");
    }
    return fmi_error;
}

/// The same of an instance.
template <class Action>
FmiStatus answered(void* instance, Action action) noexcept {
    if (instance == nullptr) return fmi_error;
    auto& one = *static_cast<FmiInstance*>(instance);
    return answered(one.log, one.name.c_str(), [&] { return action(one); });
}

/// Carries out what changes the session of an instance or asks it.
template <class Action>
FmiStatus on(void* instance, Action action) {
    return answered(instance, [&](FmiInstance& one) {
        std::invoke(action, one.session);
        return fmi_ok;
    });
}

/// The answer of a function for what the description says this FMU lacks.
inline FmiStatus lacks(void* instance, const char* name) {
    return on(instance, [&](FmuSession&) {
        throw InputError(fmt::format("{}: this FMU has no such thing, as its description says.", name));
    });
}

/// A function that answers so. The arguments after the instance are the caller's.
#define FLOES_LACKS(name)                \
    FLOES_FMI int name(void* instance) { \
        return lacks(instance, #name);   \
    }

// The values of variables: one for each reference, or it is an error.

inline void expect_alike(std::size_t references, std::size_t values) {
    if (references != values)
        throw InputError(fmt::format("There are {} value references and {} values.", references, values));
}

/// `value_of`: of the session and a reference.
template <class Value, class ValueOf>
FmiStatus get_values(void* instance, const unsigned* references, std::size_t count, Value* values, std::size_t places,
                     ValueOf value_of) {
    return on(instance, [&](const FmuSession& one) {
        expect_alike(count, places);
        for (std::size_t k = 0; k < count; ++k) values[k] = std::invoke(value_of, one, references[k]);
    });
}

template <class Value>
FmiStatus set_values(void* instance, const unsigned* references, std::size_t count, const Value* values,
                     std::size_t places) {
    return on(instance, [&](FmuSession& one) {
        expect_alike(count, places);
        for (std::size_t k = 0; k < count; ++k) one.set(references[k], values[k]);
    });
}

// States, which hosts hold as pointers to Bytes.

inline FmiStatus get_state(void* instance, void** state) {
    return on(instance, [&](const FmuSession& one) {
        Bytes bytes = one.saved();
        if (*state == nullptr) *state = new Bytes;
        *static_cast<Bytes*>(*state) = std::move(bytes);
    });
}

inline FmiStatus set_state(void* instance, void* state) {
    return on(instance, [&](FmuSession& one) {
        if (state == nullptr) throw InputError("There is no state to set.");
        one.set(*static_cast<Bytes*>(state));
    });
}

inline FmiStatus free_state(void* instance, void** state) {
    return on(instance, [&](const FmuSession&) {
        if (state != nullptr) delete static_cast<Bytes*>(std::exchange(*state, nullptr));
    });
}

inline FmiStatus size_of_state(void* instance, void* state, std::size_t* size) {
    return on(instance, [&](const FmuSession&) { *size = static_cast<Bytes*>(state)->size(); });
}

inline FmiStatus serialize_state(void* instance, void* state, void* bytes, std::size_t size) {
    return on(instance, [&](const FmuSession&) {
        const Bytes& own = *static_cast<Bytes*>(state);
        if (size < own.size()) throw InputError("The state is longer than the bytes for it.");
        std::memcpy(bytes, own.data(), own.size());
    });
}

inline FmiStatus deserialize_state(void* instance, const void* bytes, std::size_t size, void** state) {
    return on(instance, [&](const FmuSession&) {
        const auto* first = static_cast<const std::byte*>(bytes);
        *state = new Bytes(first, first + size);
    });
}

}  // namespace floes
