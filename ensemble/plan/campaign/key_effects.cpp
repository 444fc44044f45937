#include "campaign/key_effects.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "scenario/keys.hpp"

namespace floes {

void KeyEffects::note(const Keys& keys, const Origins& origins) {
    for (const Key& key : keys) {
        if (!key.in_force) continue;
        const std::string path(key.path);
        const auto origin = origins.find(path);
        if (origin == origins.end() || is_superfluous(key)) continue;
        if (key.idle())
            idle_.try_emplace(path, fmt::format("{}: {} = {}", origin->second, path, literal(key)), key.only_with);
        else
            effective_.insert(path);
    }
}

void KeyEffects::refuse_without() const {
    for (const auto& [path, given] : idle_) {
        if (effective_.contains(path)) continue;
        throw InputError(
            fmt::format("{} has no effect: it needs {}. Add that, or leave {} out.", given.first, given.second, path));
    }
}

}  // namespace floes
