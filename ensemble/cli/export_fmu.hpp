#pragma once
// What floes export does for --fmu.

#include <optional>
#include <string>
#include <vector>

namespace floes {

class Verb;

struct FmuOptions {
    std::string file;  ///< empty: none is made
    int version = 2;
    std::string motion;  ///< "inside", "outside", or empty: by the configuration
    std::optional<int> arrangement = {};
    std::vector<std::string> overrides;
};

/// The options that say which FMU.
void add_fmu_options(Verb& verb, FmuOptions& options);

/// Writes the FMU of a configuration's case; the first one where none is named. Returns the exit status. Throws
/// InputError for a configuration that gives none.
int write_fmu(const FmuOptions& options, const std::string& config, const std::string& case_name);

}  // namespace floes
