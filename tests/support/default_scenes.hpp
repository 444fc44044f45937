#pragma once
// What floes does by default, in a few moments that differ in what they cost: members of shipped configurations, run to
// where their ice is thick about the structure. Benchmarks step on from there, and the test of what a step takes from
// the heap does.

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "campaign/read.hpp"
#include "core/error.hpp"
#include "simulation/simulation.hpp"
#include "support/file_bytes.hpp"

namespace floes {

struct DefaultScene {
    std::string name;
    std::string configuration;  ///< in configs/
    std::string case_name;      ///< empty: the first
    double time = 0;            ///< of the scene, s
    std::vector<std::string> changes{};
    std::uint32_t arrangement = 0;

    Scenario scenario() const {
        const auto read = [](const std::string& file) { return file_text(file); };
        const std::string path = std::string(FLOES_SOURCE_DIR) + "/configs/" + configuration;
        const Campaign campaign = read_campaign({read(path), path, changes, true}, read);
        const auto chosen = std::ranges::find_if(
            campaign.cases, [&](const Case& one) { return case_name.empty() || one.name == case_name; });
        if (chosen == campaign.cases.end()) throw InputError(path + " has no case " + case_name);
        Scenario made = chosen->scenario;
        made.analysis.window *= 2;  // steps enough behind the scene
        return made;
    }

    /// A run of it that has come to its time.
    Simulation reached() const {
        const Scenario all = scenario();
        LaidField laid = lay_field(all, 1, arrangement);
        Simulation simulation(all, laid.laid(), std::move(laid.ahead));
        while (simulation.time() < time) simulation.step();
        return simulation;
    }

    friend void PrintTo(const DefaultScene& scene, std::ostream* out) { *out << scene.name; }  // for GoogleTest
};

inline std::vector<DefaultScene> default_scenes() {
    return {
        {"cone", "smoke.toml", "E60", 20},
        {"squares", "smoke.toml", "E60", 20, {"floe.elements=\"squares\""}},  // to compare cells with
        {"wall", "validation/grain_wall.toml", "cells", 60},
        {"full_scale", "full_scale.toml", "first_year", 200},
        {"polygons", "gallery/mixed_sizes.toml", "", 20, {"shapes.kind=\"polygon\""}},
        {"without_end", "endless.toml", "", 60},
        {"moored", "moored_free.toml", "moored", 24},
        // One floe of 32 elements along each side.
        {"large_floe",
         "smoke.toml",
         "E60",
         20,
         {"floe.length_m=6.4", "floe.breadth_m=6.4", "field.floes=1", "field.half_width_m=3.5",
          "field.concentration_percent=80.0"}},
    };
}

inline DefaultScene default_scene(const std::string& name) {
    for (const DefaultScene& scene : default_scenes())
        if (scene.name == name) return scene;
    throw InputError("There is no scene " + name + " of the default.");
}

}  // namespace floes
