#include "cli/mooring_options.hpp"

#include <fmt/format.h>

#include "core/units.hpp"

namespace floes {

std::optional<Oscillator> MooringOptions::hull() const {
    if (!stiffness_kn_m) return std::nullopt;
    constexpr double thousand = 1e3;
    const Oscillator hull{thousand * stiffness_kn_m.value(), thousand * mass_t.value(),
                          unit::percent * damping_percent.value()};
    check_hull(hull);
    return hull;
}

std::string MooringOptions::text() const {
    if (!stiffness_kn_m) return "";
    return fmt::format(" --mooring-kN-m {:g} --mass-t {:g} --damping-percent {:g}", *stiffness_kn_m, mass_t.value(),
                       damping_percent.value());
}

Option add_mooring(OptionList& verb, MooringOptions& options) {
    Option stiffness = verb.option(
        "--mooring-kN-m", options.stiffness_kn_m,
        "A hull on moorings of this stiffness, kN/m at full scale, moved by the stored loads of the fixed hull");
    Option mass = verb.option("--mass-t", options.mass_t,
                              "Its mass, t at full scale: that of the hull and the added mass of the water, which for "
                              "surge is some half of it more");
    Option damping =
        verb.option("--damping-percent", options.damping_percent,
                    "Its damping by water and mooring lines, percent of the critical; take it from a decay test");
    // A ring, since help would list several needs in an order of their addresses.
    stiffness.needs(damping);
    damping.needs(mass);
    mass.needs(stiffness);
    return stiffness;
}

}  // namespace floes
