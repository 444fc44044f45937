// FMI 3.0 for co-simulation: the functions of its standard by their names and types there. Those of model exchange and
// scheduled execution are exported too, as 3.0.1 asks, and refuse.

#include <string>

#include "core/error.hpp"
#include "fmi/host_call.hpp"
#include "fmi/session.hpp"

namespace floes {

using Fmi3Logger = void (*)(void* environment, int status, const char* category, const char* message);

namespace {

constexpr unsigned time_reference = 0;  // of the independent variable, which FMI 2.0 has none of

}  // namespace

FLOES_FMI const char* fmi3GetVersion() {
    return "3.0";
}

FLOES_FMI void* fmi3InstantiateCoSimulation(const char*, const char* token, const char* resources, bool, bool,
                                            bool events, bool, const unsigned*, std::size_t, void* environment,
                                            Fmi3Logger logger, void*) {
    const FmiLog log = [logger, environment](const char*, FmiStatus status, const std::string& sentence) {
        if (logger != nullptr) logger(environment, status, "logStatusError", sentence.c_str());
    };
    void* made = nullptr;
    answered(log, "", [&] {
        if (events) throw InputError("This FMU has no event mode, as its description says.");
        if (resources == nullptr) throw InputError("The FMU's folder of resources is not said.");
        made = new FmiInstance{"", log, FmuSession(resources, token == nullptr ? "" : token)};
        return fmi_ok;
    });
    return made;
}

FLOES_FMI void fmi3FreeInstance(void* instance) {
    delete static_cast<FmiInstance*>(instance);
}

FLOES_FMI int fmi3SetDebugLogging(void* instance, bool, std::size_t, const char* const*) {
    return on(instance, [](const FmuSession&) {});  // errors alone are logged, and always
}

FLOES_FMI int fmi3EnterInitializationMode(void* instance, bool, double, double start, bool has_stop, double stop) {
    return on(instance, [&](FmuSession& one) {
        one.set_up(start, has_stop ? std::optional(stop) : std::nullopt);
        one.enter_initialization();
    });
}

FLOES_FMI int fmi3ExitInitializationMode(void* instance) {
    return on(instance, &FmuSession::exit_initialization);
}

FLOES_FMI int fmi3Terminate(void* instance) {
    return on(instance, &FmuSession::terminate);
}

FLOES_FMI int fmi3Reset(void* instance) {
    return on(instance, &FmuSession::reset);
}

FLOES_FMI int fmi3GetFloat64(void* instance, const unsigned* references, std::size_t count, double* values,
                             std::size_t places) {
    const auto value_of = [](const FmuSession& session, unsigned reference) {
        return reference == time_reference ? session.time() : session.real(reference);
    };
    return get_values(instance, references, count, values, places, value_of);
}

FLOES_FMI int fmi3GetInt32(void* instance, const unsigned* references, std::size_t count, int* values,
                           std::size_t places) {
    return get_values(instance, references, count, values, places, &FmuSession::integer);
}

FLOES_FMI int fmi3GetString(void* instance, const unsigned* references, std::size_t count, const char** values,
                            std::size_t places) {
    return get_values(instance, references, count, values, places, &FmuSession::text);
}

FLOES_FMI int fmi3SetFloat64(void* instance, const unsigned* references, std::size_t count, const double* values,
                             std::size_t places) {
    return set_values(instance, references, count, values, places);
}

FLOES_FMI int fmi3SetInt32(void* instance, const unsigned* references, std::size_t count, const int* values,
                           std::size_t places) {
    return set_values(instance, references, count, values, places);
}

FLOES_FMI int fmi3SetString(void* instance, const unsigned* references, std::size_t count, const char* const* values,
                            std::size_t places) {
    return set_values(instance, references, count, values, places);
}

FLOES_FMI int fmi3DoStep(void* instance, double at, double length, bool, bool* event_needed, bool* terminates,
                         bool* returned_early, double* last_time) {
    return answered(instance, [&](FmiInstance& one) {
        if (event_needed != nullptr) *event_needed = false;
        if (returned_early != nullptr) *returned_early = false;
        const bool over = one.session.step(at, length) == FmuSession::StepEnd::run_is_over;
        if (terminates != nullptr) *terminates = over;
        if (last_time != nullptr) *last_time = one.session.time();
        if (over) one.log(one.name.c_str(), fmi_discard, "the run is over, and the step was not taken.");
        return over ? fmi_discard : fmi_ok;
    });
}

FLOES_FMI int fmi3GetFMUState(void* instance, void** state) {
    return get_state(instance, state);
}

FLOES_FMI int fmi3SetFMUState(void* instance, void* state) {
    return set_state(instance, state);
}

FLOES_FMI int fmi3FreeFMUState(void* instance, void** state) {
    return free_state(instance, state);
}

FLOES_FMI int fmi3SerializedFMUStateSize(void* instance, void* state, std::size_t* size) {
    return size_of_state(instance, state, size);
}

FLOES_FMI int fmi3SerializeFMUState(void* instance, void* state, unsigned char* bytes, std::size_t size) {
    return serialize_state(instance, state, bytes, size);
}

FLOES_FMI int fmi3DeserializeFMUState(void* instance, const unsigned char* bytes, std::size_t size, void** state) {
    return deserialize_state(instance, bytes, size, state);
}

FLOES_FMI int fmi3GetNumberOfVariableDependencies(void* instance, unsigned, std::size_t* count) {
    return on(instance, [&](const FmuSession&) { *count = 0; });  // outputs change in steps alone
}

FLOES_FMI int fmi3GetVariableDependencies(void* instance) {
    return on(instance, [](const FmuSession&) {});
}

FLOES_FMI void* fmi3InstantiateModelExchange() {
    return nullptr;
}

FLOES_FMI void* fmi3InstantiateScheduledExecution() {
    return nullptr;
}

// What the description says this FMU lacks.

FLOES_LACKS(fmi3EnterEventMode)
FLOES_LACKS(fmi3GetFloat32)
FLOES_LACKS(fmi3GetInt8)
FLOES_LACKS(fmi3GetUInt8)
FLOES_LACKS(fmi3GetInt16)
FLOES_LACKS(fmi3GetUInt16)
FLOES_LACKS(fmi3GetUInt32)
FLOES_LACKS(fmi3GetInt64)
FLOES_LACKS(fmi3GetUInt64)
FLOES_LACKS(fmi3GetBoolean)
FLOES_LACKS(fmi3GetBinary)
FLOES_LACKS(fmi3GetClock)
FLOES_LACKS(fmi3SetFloat32)
FLOES_LACKS(fmi3SetInt8)
FLOES_LACKS(fmi3SetUInt8)
FLOES_LACKS(fmi3SetInt16)
FLOES_LACKS(fmi3SetUInt16)
FLOES_LACKS(fmi3SetUInt32)
FLOES_LACKS(fmi3SetInt64)
FLOES_LACKS(fmi3SetUInt64)
FLOES_LACKS(fmi3SetBoolean)
FLOES_LACKS(fmi3SetBinary)
FLOES_LACKS(fmi3SetClock)
FLOES_LACKS(fmi3GetDirectionalDerivative)
FLOES_LACKS(fmi3GetAdjointDerivative)
FLOES_LACKS(fmi3EnterConfigurationMode)
FLOES_LACKS(fmi3ExitConfigurationMode)
FLOES_LACKS(fmi3GetIntervalDecimal)
FLOES_LACKS(fmi3GetIntervalFraction)
FLOES_LACKS(fmi3GetShiftDecimal)
FLOES_LACKS(fmi3GetShiftFraction)
FLOES_LACKS(fmi3SetIntervalDecimal)
FLOES_LACKS(fmi3SetIntervalFraction)
FLOES_LACKS(fmi3SetShiftDecimal)
FLOES_LACKS(fmi3SetShiftFraction)
FLOES_LACKS(fmi3EvaluateDiscreteStates)
FLOES_LACKS(fmi3UpdateDiscreteStates)
FLOES_LACKS(fmi3EnterContinuousTimeMode)
FLOES_LACKS(fmi3CompletedIntegratorStep)
FLOES_LACKS(fmi3SetTime)
FLOES_LACKS(fmi3SetContinuousStates)
FLOES_LACKS(fmi3GetContinuousStateDerivatives)
FLOES_LACKS(fmi3GetEventIndicators)
FLOES_LACKS(fmi3GetContinuousStates)
FLOES_LACKS(fmi3GetNominalsOfContinuousStates)
FLOES_LACKS(fmi3GetNumberOfEventIndicators)
FLOES_LACKS(fmi3GetNumberOfContinuousStates)
FLOES_LACKS(fmi3EnterStepMode)
FLOES_LACKS(fmi3GetOutputDerivatives)
FLOES_LACKS(fmi3ActivateModelPartition)

}  // namespace floes
