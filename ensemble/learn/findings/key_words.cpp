#include "findings/key_words.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace floes {
namespace {

/// Ends of names and what they mean, longer ones before those that end like them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> units{{{"_kg_m3", "kg/m³"},
                                                                               {"_m_s2", "m/s²"},
                                                                               {"_m_s", "m/s"},
                                                                               {"_percent", "%"},
                                                                               {"_kPa", "kPa"},
                                                                               {"_MPa", "MPa"},
                                                                               {"_MiB", "MiB"},
                                                                               {"_deg", "°"},
                                                                               {"_N", "N"},
                                                                               {"_s", "s"},
                                                                               {"_m", "m"}}};

}  // namespace

std::string KeyWords::with(const std::string& value) const {
    return name + " " + value + (unit.empty() ? "" : " " + unit);
}

KeyWords key_words(std::string_view key) {
    const std::size_t dot = key.find('.');
    std::string_view name = dot == std::string_view::npos ? key : key.substr(dot + 1);
    KeyWords words;
    for (const auto& [end, unit] : units) {
        if (!name.ends_with(end)) continue;
        name.remove_suffix(end.size());
        words.unit = unit;
        break;
    }
    words.name = name == "cfm" ? "Σ" : std::string(name);
    std::ranges::replace(words.name, '_', ' ');
    if (words.name.starts_with("ice ")) words.name[3] = '-';  // between two bodies
    return words;
}

}  // namespace floes
