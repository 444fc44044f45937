#pragma once
// The configuration that a first campaign begins with: the keys that everybody sets, each with its unit and range.

#include <string>

namespace floes {

enum class Starter {
    tank,        ///< 24 floes of model ice, two thicknesses: done within a minute on two cores
    full_scale,  ///< a floater of 70 m in floes of 20 m (configs/full_scale.toml) with fewer arrangements
    design,      ///< the tank over thickness and speed
    paper        ///< the paper's Table 3 (configs/table3.toml) with few arrangements
};

/// The text of the file `name`, which floes config --check accepts.
std::string starter_text(Starter starter, const std::string& name);

}  // namespace floes
