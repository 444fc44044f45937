#pragma once
// The modelDescription.xml of an FMU, by FMI 2.0 or 3.0.

#include <string>
#include <string_view>

#include "fmu/variables.hpp"

namespace floes {

enum class FmiVersion { two, three };

/// The name of its shared library and of nothing else.
inline constexpr std::string_view fmu_identifier = "floes";

struct FmuDescription {
    std::string model_name;
    std::string token;        ///< that its library expects: guid, instantiationToken
    std::string program;      ///< "floes 3.0.0"
    std::string case_name;    ///< start of the parameter
    int arrangement = 0;      ///< likewise
    double time_step = 0.02;  ///< s
    double stop_time = 0;     ///< s
    bool can_be_saved = true;
    HullMover mover = HullMover::inside;
};

std::string fmu_description(const FmuDescription& of, FmiVersion version);

}  // namespace floes
