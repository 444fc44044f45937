#pragma once
// The options of a moored hull, of verbs that measure loads.

#include <optional>
#include <string>

#include "cli/command_line.hpp"
#include "findings/moored.hpp"

namespace floes {

struct MooringOptions {
    std::optional<double> stiffness_kn_m;
    std::optional<double> mass_t;
    std::optional<double> damping_percent;

    /// The hull at full scale; none where it is not asked for. Throws InputError as check_hull() does.
    std::optional<Oscillator> hull() const;

    /// As they were given, each after a space.
    std::string text() const;
};

/// Adds them, each of which needs the others; returns the first.
Option add_mooring(OptionList& verb, MooringOptions& options);

}  // namespace floes
