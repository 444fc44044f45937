#include "findings/energy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "findings/estimates.hpp"

namespace floes {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 12> shares{{
    {"work_ice_friction", "friction, ice on ice"},
    {"work_ice_crushing", "crushing and stopping, ice on ice"},
    {"work_hull_friction", "friction on the structure"},
    {"work_hull_crushing", "crushing and stopping on the structure"},
    {"work_vertical_drag", "drag along the normals of the ice"},
    {"work_plane_drag", "form and skin drag"},
    {"work_waves", "waves"},
    {"work_joints", "bending and breaking"},
    {"work_lifting", "lifting and pushing under"},
    {"work_driving", "against sheets that give way and wind"},
    {"work_motion", "motion of ice and water"},
    {"work_rest", "lost by finite steps"},
}};

/// What people see: drawn cases beside each other, with the sum; what nothing drives is left out.
Results shown(const Results& all, const Evidence& evidence) {
    Results some{.columns = all.columns};
    for (const std::size_t k : drawn_cases(evidence.summary)) {
        double sum = 0;
        for (std::size_t r = 0; r < all.rows.size(); ++r) {
            if (all.name(r, "case") != evidence.summary.name_of(k)) continue;
            const double force = all.number(r, "force");
            sum += force;
            if (all.name(r, "quantity") != "work_driving" || force != 0) some.add(all.rows[r]);
        }
        if (sum != 0)
            some.add({Named{"", evidence.summary.label_of(k)}, Named{"", "together"}, Estimate{.value = sum}, 1.0, 0});
    }
    return pivot(some, "quantity", "case", {"force", "share"});
}

}  // namespace

Results find_energy(const Sample& sample, const Summary& summary) {
    Results results{.place = "energy",
                    .columns = {{"case", "case"},
                                {"quantity", "work of the tow over its length"},
                                estimates("force", "force", "N"),
                                {.key = "share", .words = "share", .unit = "share", .decimals = 0},
                                {"members"}},
                    .view = Results::View::none};
    for (std::size_t k = 0; k < sample.cases(); ++k) {
        const std::size_t first = results.rows.size();
        double sum = 0;
        for (const auto& [key, words] : shares) {
            std::vector<double> values = sample.values(sample.done(k), *find_quantity(key));
            const auto measured = std::ranges::count_if(values, [](double value) { return std::isfinite(value); });
            if (measured == 0) continue;
            const Estimate force = over(std::move(values));
            sum += force.value;
            results.add({summary.named(k), Named{key, words}, force, 0.0, measured});
        }
        for (std::size_t r = first; r < results.rows.size(); ++r) results.rows[r][3] = results.number(r, "force") / sum;
    }
    return results;
}

Section energy_section(Evidence& evidence) {
    Results all = find_energy(evidence.sample, evidence.summary);
    if (all.empty()) return {.missing = "Work of the tow: unknown, because the members were computed without it.\n"};
    Results some = shown(all, evidence);
    return {
        .results = {std::move(some), std::move(all)},
        .after =
            "\nWhere the work of the tow goes, divided by the distance towed: together it is the mean load, but for "
            "what the steps that were looked at (every fifth) differ from all. Brackets: 95 % interval over "
            "arrangements. Stopping: floes that meet lose speed without friction. Bending and breaking contains what "
            "joints still store." +
            undrawn_text(evidence.summary) + "\n"};
}

}  // namespace floes
