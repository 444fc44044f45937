// FMI 2.0 for co-simulation: the functions of its standard, section 4.2, by their names and types there.

#include <charconv>
#include <string>

#include <fmt/format.h>

#include "core/error.hpp"
#include "fmi/host_call.hpp"
#include "fmi/session.hpp"

namespace floes {

using Fmi2Logger = void (*)(void* environment, const char* instance, int status, const char* category,
                            const char* message, ...);

/// What a host hands over; memory is our own.
struct Fmi2Callbacks {
    Fmi2Logger logger;
    void* (*allocate)(std::size_t, std::size_t);
    void (*release)(void*);
    void (*step_finished)(void*, int);
    void* environment;
};

namespace {

constexpr int last_successful_time = 2;
constexpr int terminated = 3;

std::string escaped_marks(const std::string& text) {
    std::string made;
    for (const char c : text) made += c == '#' ? "##" : std::string(1, c);
    return made;
}

/// "file:///a", "file:/a" or "file://localhost/a" with percent escapes, or a path.
std::string path_of_uri(std::string uri) {
    constexpr std::string_view scheme = "file:";
    if (!uri.starts_with(scheme)) return uri;
    uri.erase(0, scheme.size());
    if (uri.starts_with("//")) uri.erase(0, std::min(uri.find('/', 2), uri.size()));
    std::string path;
    for (std::size_t k = 0; k < uri.size(); ++k) {
        unsigned code = 0;
        const bool escape = uri[k] == '%' && k + 2 < uri.size() &&
                            std::from_chars(&uri[k + 1], &uri[k + 1] + 2, code, 16).ptr == &uri[k + 1] + 2;
        path += escape ? static_cast<char>(code) : uri[k];
        if (escape) k += 2;
    }
    return path;
}

}  // namespace

FLOES_FMI const char* fmi2GetTypesPlatform() {
    return "default";
}

FLOES_FMI const char* fmi2GetVersion() {
    return "2.0";
}

FLOES_FMI void* fmi2Instantiate(const char* name, int type, const char* guid, const char* resources,
                                const Fmi2Callbacks* host, int, int) {
    if (host == nullptr) return nullptr;
    if (name == nullptr) name = "";
    const FmiLog log = [logger = host->logger, environment = host->environment](const char* of, FmiStatus status,
                                                                                const std::string& sentence) {
        if (logger != nullptr) logger(environment, of, status, "logStatusError", "%s", escaped_marks(sentence).c_str());
    };
    void* made = nullptr;
    answered(log, name, [&] {
        if (type != 1) throw InputError("This FMU is for co-simulation.");
        if (resources == nullptr) throw InputError("The FMU's folder of resources is not said.");
        made = new FmiInstance{name, log, FmuSession(path_of_uri(resources), guid == nullptr ? "" : guid)};
        return fmi_ok;
    });
    return made;
}

FLOES_FMI void fmi2FreeInstance(void* instance) {
    delete static_cast<FmiInstance*>(instance);
}

FLOES_FMI int fmi2SetDebugLogging(void* instance, int, std::size_t, const char* const*) {
    return on(instance, [](const FmuSession&) {});  // errors alone are logged, and always
}

FLOES_FMI int fmi2SetupExperiment(void* instance, int, double, double start, int has_stop, double stop) {
    return on(instance,
              [&](FmuSession& one) { one.set_up(start, has_stop != 0 ? std::optional(stop) : std::nullopt); });
}

FLOES_FMI int fmi2EnterInitializationMode(void* instance) {
    return on(instance, &FmuSession::enter_initialization);
}

FLOES_FMI int fmi2ExitInitializationMode(void* instance) {
    return on(instance, &FmuSession::exit_initialization);
}

FLOES_FMI int fmi2Terminate(void* instance) {
    return on(instance, &FmuSession::terminate);
}

FLOES_FMI int fmi2Reset(void* instance) {
    return on(instance, &FmuSession::reset);
}

FLOES_FMI int fmi2GetReal(void* instance, const unsigned* references, std::size_t count, double* values) {
    return get_values(instance, references, count, values, count, &FmuSession::real);
}

FLOES_FMI int fmi2GetInteger(void* instance, const unsigned* references, std::size_t count, int* values) {
    return get_values(instance, references, count, values, count, &FmuSession::integer);
}

FLOES_FMI int fmi2GetString(void* instance, const unsigned* references, std::size_t count, const char** values) {
    return get_values(instance, references, count, values, count, &FmuSession::text);
}

FLOES_FMI int fmi2SetReal(void* instance, const unsigned* references, std::size_t count, const double* values) {
    return set_values(instance, references, count, values, count);
}

FLOES_FMI int fmi2SetInteger(void* instance, const unsigned* references, std::size_t count, const int* values) {
    return set_values(instance, references, count, values, count);
}

FLOES_FMI int fmi2SetString(void* instance, const unsigned* references, std::size_t count, const char* const* values) {
    return set_values(instance, references, count, values, count);
}

FLOES_FMI int fmi2DoStep(void* instance, double at, double length, int) {
    return answered(instance, [&](FmiInstance& one) {
        one.over = one.session.step(at, length) == FmuSession::StepEnd::run_is_over;
        return one.over ? fmi_discard : fmi_ok;
    });
}

FLOES_FMI int fmi2GetRealStatus(void* instance, int kind, double* value) {
    if (kind != last_successful_time) return fmi_discard;
    return on(instance, [&](const FmuSession& one) { *value = one.time(); });
}

FLOES_FMI int fmi2GetBooleanStatus(void* instance, int kind, int* value) {
    if (kind != terminated) return fmi_discard;
    return answered(instance, [&](const FmiInstance& one) {
        *value = one.over ? 1 : 0;
        return fmi_ok;
    });
}

FLOES_FMI int fmi2GetFMUstate(void* instance, void** state) {
    return get_state(instance, state);
}

FLOES_FMI int fmi2SetFMUstate(void* instance, void* state) {
    return set_state(instance, state);
}

FLOES_FMI int fmi2FreeFMUstate(void* instance, void** state) {
    return free_state(instance, state);
}

FLOES_FMI int fmi2SerializedFMUstateSize(void* instance, void* state, std::size_t* size) {
    return size_of_state(instance, state, size);
}

FLOES_FMI int fmi2SerializeFMUstate(void* instance, void* state, char* bytes, std::size_t size) {
    return serialize_state(instance, state, bytes, size);
}

FLOES_FMI int fmi2DeSerializeFMUstate(void* instance, const char* bytes, std::size_t size, void** state) {
    return deserialize_state(instance, bytes, size, state);
}

// What the description says this FMU lacks.

FLOES_LACKS(fmi2GetBoolean)
FLOES_LACKS(fmi2SetBoolean)
FLOES_LACKS(fmi2GetDirectionalDerivative)
FLOES_LACKS(fmi2SetRealInputDerivatives)
FLOES_LACKS(fmi2GetRealOutputDerivatives)
FLOES_LACKS(fmi2CancelStep)

// A status that it cannot give is discarded, and no error (FMI 2.0.4, 4.2.3).

FLOES_FMI int fmi2GetStatus(void*) {
    return fmi_discard;
}

FLOES_FMI int fmi2GetIntegerStatus(void*) {
    return fmi_discard;
}

FLOES_FMI int fmi2GetStringStatus(void*) {
    return fmi_discard;
}

}  // namespace floes
