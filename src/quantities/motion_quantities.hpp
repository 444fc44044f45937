#pragma once
// The quantities of structures that are not towed straight on: offsets, mooring forces, yaw. Part of quantity.hpp's
// list.

#include <array>

#include "quantities/quantity_kind.hpp"

namespace floes {

/// Of the motion of a structure that is not towed straight on; NaN in other members.
constexpr Quantity motion_quantity(const char* key, std::string_view unit, std::string_view long_name, Place place) {
    return {.key = key, .unit = unit, .long_name = long_name, .place = place, .least = no_least, .since = 13};
}

/// Of thrusters; NaN in other members.
constexpr Quantity thrust_quantity(const char* key, std::string_view unit, std::string_view long_name, Place place) {
    Quantity quantity = motion_quantity(key, unit, long_name, place);
    quantity.since = 14;
    return quantity;
}

inline constexpr std::array motion_quantities{
    motion_quantity("mean_surge_offset", "m", "mean offset of the moored structure along the surge load",
                    at<&MemberOutputs::moored, &MooredResponse::surge_offset, &Swing::mean>()),
    motion_quantity("sd_surge_offset", "m",
                    "population standard deviation of the offset of the moored structure along the surge load",
                    at<&MemberOutputs::moored, &MooredResponse::surge_offset, &Swing::sd>()),
    motion_quantity("largest_surge_offset", "m",
                    "largest amount of the offset of the moored structure along the surge load",
                    at<&MemberOutputs::moored, &MooredResponse::surge_offset, &Swing::largest>()),
    motion_quantity("mean_sway_offset", "m", "mean offset of the moored structure towards +z",
                    at<&MemberOutputs::moored, &MooredResponse::sway_offset, &Swing::mean>()),
    motion_quantity("sd_sway_offset", "m",
                    "population standard deviation of the offset of the moored structure towards +z",
                    at<&MemberOutputs::moored, &MooredResponse::sway_offset, &Swing::sd>()),
    motion_quantity("largest_sway_offset", "m", "largest amount of the offset of the moored structure towards +z",
                    at<&MemberOutputs::moored, &MooredResponse::sway_offset, &Swing::largest>()),
    motion_quantity("mean_yaw", "rad", "mean yaw of the moored structure, positive where +z turns to +x",
                    at<&MemberOutputs::moored, &MooredResponse::yaw, &Swing::mean>()),
    motion_quantity("sd_yaw", "rad",
                    "population standard deviation of the yaw of the moored structure, positive where +z turns to +x",
                    at<&MemberOutputs::moored, &MooredResponse::yaw, &Swing::sd>()),
    motion_quantity("largest_yaw", "rad",
                    "largest amount of the yaw of the moored structure, positive where +z turns to +x",
                    at<&MemberOutputs::moored, &MooredResponse::yaw, &Swing::largest>()),
    motion_quantity("mean_surge_mooring", "N", "mean force of springs and lines against the surge load",
                    at<&MemberOutputs::moored, &MooredResponse::surge_mooring, &Swing::mean>()),
    motion_quantity("sd_surge_mooring", "N",
                    "population standard deviation of the force of springs and lines against the surge load",
                    at<&MemberOutputs::moored, &MooredResponse::surge_mooring, &Swing::sd>()),
    motion_quantity("largest_surge_mooring", "N",
                    "largest amount of the force of springs and lines against the surge load",
                    at<&MemberOutputs::moored, &MooredResponse::surge_mooring, &Swing::largest>()),
    motion_quantity("mean_sway_mooring", "N", "mean force of springs and lines against the sway load",
                    at<&MemberOutputs::moored, &MooredResponse::sway_mooring, &Swing::mean>()),
    motion_quantity("sd_sway_mooring", "N",
                    "population standard deviation of the force of springs and lines against the sway load",
                    at<&MemberOutputs::moored, &MooredResponse::sway_mooring, &Swing::sd>()),
    motion_quantity("largest_sway_mooring", "N",
                    "largest amount of the force of springs and lines against the sway load",
                    at<&MemberOutputs::moored, &MooredResponse::sway_mooring, &Swing::largest>()),
    motion_quantity("mean_maximum_surge_mooring", "N",
                    "mean of the segment maxima of the force of springs and lines against the surge load",
                    at<&MemberOutputs::moored, &MooredResponse::mean_maximum>()),
    motion_quantity("rms_surge_velocity", "m s-1",
                    "root mean square of the moored structure's velocity in surge, relative to its anchors",
                    at<&MemberOutputs::moored, &MooredResponse::rms_velocity>()),
    motion_quantity("largest_line_tension", "N", "largest horizontal tension of a mooring line over the run",
                    at<&MemberOutputs::moored, &MooredResponse::line_tension>()),
    Quantity{.key = "broken_lines",
             .unit = "1",
             .long_name = "mooring lines that broke",
             .place = at<&MemberOutputs::moored, &MooredResponse::broken_lines>(),
             .count = true,
             .since = 13},
    thrust_quantity("mean_surge_thrust", "N", "mean force of thrusters against the surge load",
                    at<&MemberOutputs::moored, &MooredResponse::surge_thrust, &Swing::mean>()),
    thrust_quantity("sd_surge_thrust", "N",
                    "population standard deviation of the force of thrusters against the surge load",
                    at<&MemberOutputs::moored, &MooredResponse::surge_thrust, &Swing::sd>()),
    thrust_quantity("largest_surge_thrust", "N", "largest amount of the force of thrusters against the surge load",
                    at<&MemberOutputs::moored, &MooredResponse::surge_thrust, &Swing::largest>()),
    thrust_quantity("mean_sway_thrust", "N", "mean force of thrusters against the sway load",
                    at<&MemberOutputs::moored, &MooredResponse::sway_thrust, &Swing::mean>()),
    thrust_quantity("sd_sway_thrust", "N",
                    "population standard deviation of the force of thrusters against the sway load",
                    at<&MemberOutputs::moored, &MooredResponse::sway_thrust, &Swing::sd>()),
    thrust_quantity("largest_sway_thrust", "N", "largest amount of the force of thrusters against the sway load",
                    at<&MemberOutputs::moored, &MooredResponse::sway_thrust, &Swing::largest>()),
    thrust_quantity("mean_yaw_thrust", "N m", "mean moment of thrusters against the yaw load",
                    at<&MemberOutputs::moored, &MooredResponse::yaw_thrust, &Swing::mean>()),
    thrust_quantity("sd_yaw_thrust", "N m",
                    "population standard deviation of the moment of thrusters against the yaw load",
                    at<&MemberOutputs::moored, &MooredResponse::yaw_thrust, &Swing::sd>()),
    thrust_quantity("largest_yaw_thrust", "N m", "largest amount of the moment of thrusters against the yaw load",
                    at<&MemberOutputs::moored, &MooredResponse::yaw_thrust, &Swing::largest>()),
    thrust_quantity("thrust_at_limit", "1", "share of the window in which thrusters are at their limit",
                    at<&MemberOutputs::moored, &MooredResponse::thrust_at_limit>())};

}  // namespace floes
