#include "fmu/variables.hpp"

#include "shapes/moorings.hpp"

namespace floes {

namespace {

using enum FmuRole;
using enum FmuType;
namespace ref = fmu_reference;

constexpr std::array parameters{
    FmuVariable{ref::arrangement, "arrangement", "", "number of the arrangement of floes, from 0", integer, parameter},
    FmuVariable{ref::case_name, "case", "", "name of the configuration's case", string, parameter},
    FmuVariable{ref::settings, "settings", "", "key=value; key=value: keys of the configuration that are replaced",
                string, parameter},
};

constexpr FmuVariable added_mass{
    ref::added_mass,
    "added_mass",
    "kg",
    "mass that the other program adds to its hull along X, Y and Z, whose inertia the ice load then makes up for",
    real,
    parameter};

constexpr std::array loads_in{
    FmuVariable{ref::force_in, "force_x", "N", "force of others on the hull, along X"},
    FmuVariable{ref::force_in + 1, "force_y", "N", "along Y"},
    FmuVariable{ref::force_in + 2, "force_z", "N", "along Z"},
    FmuVariable{ref::force_in + 3, "moment_x", "N.m", "moment of others on the hull, about X"},
    FmuVariable{ref::force_in + 4, "moment_y", "N.m", "about Y"},
    FmuVariable{ref::force_in + 5, "moment_z", "N.m", "about Z"},
};

constexpr std::array motions{
    FmuVariable{ref::motion, "x", "m", "place of the hull from where its tow has it, along X"},
    FmuVariable{ref::motion + 1, "y", "m", "along Y"},
    FmuVariable{ref::motion + 2, "z", "m", "along Z"},
    FmuVariable{ref::motion + 3, "roll", "rad", "heel to starboard"},
    FmuVariable{ref::motion + 4, "pitch", "rad", "trim by the bow"},
    FmuVariable{ref::motion + 5, "yaw", "rad", "turn of the bow to port"},
    FmuVariable{ref::velocity, "x_velocity", "m/s", "how fast x changes"},
    FmuVariable{ref::velocity + 1, "y_velocity", "m/s", "how fast y changes"},
    FmuVariable{ref::velocity + 2, "z_velocity", "m/s", "how fast z changes"},
    FmuVariable{ref::velocity + 3, "roll_rate", "rad/s", "how fast roll changes"},
    FmuVariable{ref::velocity + 4, "pitch_rate", "rad/s", "how fast pitch changes"},
    FmuVariable{ref::velocity + 5, "yaw_rate", "rad/s", "how fast yaw changes"},
};

constexpr std::array ice_loads{
    FmuVariable{ref::ice_load, "ice_force_x", "N", "mean force of the ice on the hull over the last step, along X",
                real, output},
    FmuVariable{ref::ice_load + 1, "ice_force_y", "N", "along Y", real, output},
    FmuVariable{ref::ice_load + 2, "ice_force_z", "N", "along Z", real, output},
    FmuVariable{ref::ice_load + 3, "ice_moment_x", "N.m",
                "mean moment of the ice on the hull over the last step, about its reference point and X", real, output},
    FmuVariable{ref::ice_load + 4, "ice_moment_y", "N.m", "about Y", real, output},
    FmuVariable{ref::ice_load + 5, "ice_moment_z", "N.m", "about Z", real, output},
};

constexpr std::array mooring_loads{
    FmuVariable{ref::mooring_load, "mooring_force_x", "N", "force of springs and lines on the hull, along X", real,
                output},
    FmuVariable{ref::mooring_load + 1, "mooring_force_y", "N", "along Y", real, output},
    FmuVariable{ref::mooring_load + 2, "mooring_moment_z", "N.m", "about Z", real, output},
};

constexpr std::array counters{
    FmuVariable{ref::floes_met, "floes_met", "", "floes that have touched the hull", integer, output},
    FmuVariable{ref::broken_floes, "broken_floes", "", "floes with a failed joint", integer, output},
    FmuVariable{ref::failed_joints, "failed_joints", "", "joints that have failed", integer, output},
};

constexpr std::array units{
    FmuUnit{"kg", R"(kg="1")"},
    FmuUnit{"m", R"(m="1")"},
    FmuUnit{"m/s", R"(m="1" s="-1")"},
    FmuUnit{"rad", R"(rad="1")"},
    FmuUnit{"rad/s", R"(rad="1" s="-1")"},
    FmuUnit{"N", R"(kg="1" m="1" s="-2")"},
    FmuUnit{"N.m", R"(kg="1" m="2" s="-2")"},
    FmuUnit{"s", R"(s="1")"},
};

}  // namespace

std::vector<FmuVariable> fmu_variables(HullMover mover) {
    std::vector<FmuVariable> all(parameters.begin(), parameters.end());
    const auto append = [&](std::span<const FmuVariable> some, FmuRole role) {
        for (FmuVariable one : some) {
            one.role = role;
            all.push_back(one);
        }
    };
    const bool inside = mover == HullMover::inside;
    if (!inside) all.push_back(added_mass);
    if (inside) append(loads_in, input);
    append(motions, inside ? output : input);
    append(ice_loads, output);
    if (inside) append(mooring_loads, output);
    append(counters, output);
    return all;
}

std::span<const FmuUnit> fmu_units() {
    return units;
}

Vec3 to_fmu_axes(const Vec3& of_world) {
    return {of_world.x(), -of_world.z(), of_world.y()};
}

Vec3 from_fmu_axes(const Vec3& of_fmu) {
    return {of_fmu.x(), of_fmu.z(), -of_fmu.y()};
}

Vec6 to_fmu_motion(const Vec6& of) {
    Vec6 found;
    found << of[at(Motion::surge)], -of[at(Motion::sway)], of[at(Motion::heave)], of[at(Motion::roll)],
        -of[at(Motion::pitch)], of[at(Motion::yaw)];
    return found;
}

Vec6 from_fmu_motion(const Vec6& of) {
    Vec6 found;
    found[at(Motion::surge)] = of[0];
    found[at(Motion::sway)] = -of[1];
    found[at(Motion::heave)] = of[2];
    found[at(Motion::roll)] = of[3];
    found[at(Motion::pitch)] = -of[4];
    found[at(Motion::yaw)] = of[5];
    return found;
}

}  // namespace floes
