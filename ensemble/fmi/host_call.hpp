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

/// What `action` returns; where it throws, an error with the sentence in the log of `instance`.
template <class Instance, class Action>
FmiStatus answered(Instance* instance, Action action) noexcept {
    if (instance == nullptr) return fmi_error;
    const OwnFloatingPoint mode;
    try {
        return action(*instance);
    } catch (const std::exception& error) {
        instance->log(fmi_error, error.what());
    } catch (...) {
        instance->log(fmi_error, "something unknown went wrong.");
    }
    return fmi_error;
}

/// Carries out what changes an instance or asks it.
template <class Instance, class Action>
FmiStatus on(void* instance, Action action) {
    return answered(static_cast<Instance*>(instance), [&](Instance& one) {
        action(one);
        return fmi_ok;
    });
}

/// The answer of a function for what the description says this FMU lacks.
template <class Instance>
FmiStatus lacks(void* instance, const char* name) {
    return on<Instance>(instance, [&](Instance&) {
        throw InputError(fmt::format("{}: this FMU has no such thing, as its description says.", name));
    });
}

/// A function that answers so. The arguments after the instance are the caller's.
#define FLOES_LACKS(Instance, name)              \
    FLOES_FMI int name(void* instance) {         \
        return lacks<Instance>(instance, #name); \
    }

// The values of variables: one for each reference, or it is an error.

inline void expect_alike(std::size_t references, std::size_t values) {
    if (references != values)
        throw InputError(fmt::format("There are {} value references and {} values.", references, values));
}

/// `value_of`: of the session and a reference.
template <class Instance, class Value, class ValueOf>
FmiStatus get_values(void* instance, const unsigned* references, std::size_t count, Value* values, std::size_t places,
                     ValueOf value_of) {
    return on<Instance>(instance, [&](const Instance& one) {
        expect_alike(count, places);
        for (std::size_t k = 0; k < count; ++k) values[k] = std::invoke(value_of, one.session, references[k]);
    });
}

template <class Instance, class Value>
FmiStatus set_values(void* instance, const unsigned* references, std::size_t count, const Value* values,
                     std::size_t places) {
    return on<Instance>(instance, [&](Instance& one) {
        expect_alike(count, places);
        for (std::size_t k = 0; k < count; ++k) one.session.set(references[k], values[k]);
    });
}

// States, which hosts hold as pointers to Bytes.

template <class Instance>
FmiStatus get_state(void* instance, void** state) {
    return on<Instance>(instance, [&](const Instance& one) {
        Bytes bytes = one.session.saved();
        if (*state == nullptr) *state = new Bytes;
        *static_cast<Bytes*>(*state) = std::move(bytes);
    });
}

template <class Instance>
FmiStatus set_state(void* instance, void* state) {
    return on<Instance>(instance, [&](Instance& one) {
        if (state == nullptr) throw InputError("There is no state to set.");
        one.session.set(*static_cast<Bytes*>(state));
    });
}

template <class Instance>
FmiStatus free_state(void* instance, void** state) {
    return on<Instance>(instance, [&](const Instance&) {
        if (state != nullptr) delete static_cast<Bytes*>(std::exchange(*state, nullptr));
    });
}

template <class Instance>
FmiStatus size_of_state(void* instance, void* state, std::size_t* size) {
    return on<Instance>(instance, [&](const Instance&) { *size = static_cast<Bytes*>(state)->size(); });
}

template <class Instance>
FmiStatus serialize_state(void* instance, void* state, void* bytes, std::size_t size) {
    return on<Instance>(instance, [&](const Instance&) {
        const Bytes& own = *static_cast<Bytes*>(state);
        if (size < own.size()) throw InputError("The state is longer than the bytes for it.");
        std::memcpy(bytes, own.data(), own.size());
    });
}

template <class Instance>
FmiStatus deserialize_state(void* instance, const void* bytes, std::size_t size, void** state) {
    return on<Instance>(instance, [&](const Instance&) {
        const auto* first = static_cast<const std::byte*>(bytes);
        *state = new Bytes(first, first + size);
    });
}

}  // namespace floes
