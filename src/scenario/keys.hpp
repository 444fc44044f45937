#pragma once
// The keys of a scenario: every field with its path, unit, range, meaning and source.

#include <string>
#include <vector>

#include "keys/key.hpp"
#include "keys/write.hpp"
#include "scenario/scenario.hpp"

namespace floes {

/// The most floes of a field, and so the most poses of a file.
inline constexpr int most_floes = 1'000'000;

/// The keys, bound to the fields of `scenario`, table by table in the order of a configuration file.
/// They refer to `scenario` and must not outlive it.
Keys describe(Scenario& scenario);

/// A sentence about each table.
TableTitles scenario_titles();

/// The paper's tank as the paper's program most likely computed it: sweeps over joints that follow Σ, Bullet's
/// contacts. Also what a stored text means where it is silent, since the first campaigns had these values.
Scenario paper_scenario();

/// Whether the key is without effect and has its usual value, so that a text need not have it.
bool is_superfluous(const Key& key);

/// "path = value" in SI for all keys, with the paths and forms of 1.0.0: equal exactly when the scenarios are.
std::string canonical_text(const Scenario& scenario);

/// "general.iterations: 50 there, 20 here" for each key that differs and has an effect in one of them.
std::vector<std::string> differences(const Scenario& there, const Scenario& here);

/// "general.iterations": the paths of these keys.
std::vector<std::string> differing_keys(const Scenario& there, const Scenario& here);

/// "floe.element_m = 0.25": the key with its value, as a message shows it. `path` is a key of a scenario.
std::string given(const Scenario& scenario, const std::string& path);

}  // namespace floes
