#pragma once
// Keys of a scenario as people say them: "ice.thickness_m" is a thickness in m.

#include <string>
#include <string_view>

namespace floes {

struct KeyWords {
    std::string name;  ///< "thickness"
    std::string unit;  ///< "m"; empty where the key has none

    /// "thickness, m"
    std::string heading() const { return unit.empty() ? name : name + ", " + unit; }
    /// "thickness 0.02 m"
    std::string with(const std::string& value) const;
};

/// `key`: the full path or a case's own key, as "cfm".
KeyWords key_words(std::string_view key);

}  // namespace floes
