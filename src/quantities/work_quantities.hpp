#pragma once
// The quantities of where the work of the tow goes, of how the floes lay at its start, and of what the solver did. Part
// of quantity.hpp's list.

#include <array>

#include "quantities/quantity_kind.hpp"

namespace floes {

inline constexpr std::array work_quantities{
    work_quantity("work_ice_friction",
                  "work over the distance towed that goes into friction between floes and on ice sheets",
                  at<&MemberOutputs::work, &WorkShares::ice_friction>()),
    work_quantity("work_ice_crushing",
                  "work over the distance towed that goes into crushing and stopping of floes by floes",
                  at<&MemberOutputs::work, &WorkShares::ice_crushing>()),
    work_quantity("work_hull_friction", "work over the distance towed that goes into friction on the structure",
                  at<&MemberOutputs::work, &WorkShares::hull_friction>()),
    work_quantity("work_hull_crushing",
                  "work over the distance towed that goes into crushing and stopping of floes by the structure",
                  at<&MemberOutputs::work, &WorkShares::hull_crushing>()),
    work_quantity("work_vertical_drag", "work over the distance towed that goes into drag along the normals of the ice",
                  at<&MemberOutputs::work, &WorkShares::vertical_drag>()),
    work_quantity("work_plane_drag", "work over the distance towed that goes into form and skin drag",
                  at<&MemberOutputs::work, &WorkShares::plane_drag>()),
    work_quantity("work_waves", "work over the distance towed that goes into waves: linear damping of heave",
                  at<&MemberOutputs::work, &WorkShares::waves>()),
    work_quantity("work_joints",
                  "work over the distance towed that goes into bending: damped, released where floes break, or stored",
                  at<&MemberOutputs::work, &WorkShares::joints>()),
    work_quantity(
        "work_lifting",
        "work over the distance towed that goes into lifting and pushing ice under, against weight and buoyancy",
        at<&MemberOutputs::work, &WorkShares::lifting>()),
    work_quantity("work_driving",
                  "work over the distance towed that goes into ice sheets that give way and against the wind; negative "
                  "where these push the ice",
                  at<&MemberOutputs::work, &WorkShares::driving>(), 11),
    work_quantity("work_motion",
                  "work over the distance towed that goes into motion of the ice and the water it carries",
                  at<&MemberOutputs::work, &WorkShares::motion>()),
    work_quantity(
        "work_rest",
        "work over the distance towed that goes into what steps of finite length lose: the load less all other shares",
        at<&MemberOutputs::work, &WorkShares::rest>()),
    Quantity{.key = "local_order",
             .unit = "1",
             .long_name = "mean cosine of four times the difference in yaw between a floe and its four nearest, at the "
                          "start",
             .place = at<&MemberOutputs::local_order>(),
             .shown = Shown::in_summary,
             .name = "local_order",
             .label = "local order at the start",
             .least = -1,
             .most = 1},
    Quantity{.key = "coverage_ahead",
             .unit = "1",
             .long_name = "share of the structure's path through the field covered by ice at the start",
             .place = at<&MemberOutputs::coverage_ahead>(),
             .shown = Shown::in_summary,
             .name = "coverage_ahead",
             .label = "coverage ahead at the start, %",
             .most = 1,
             .percent = true},
    Quantity{.key = "mean_sweeps",
             .unit = "1",
             .long_name = "sweeps of the solver a step, on average over the run",
             .place = at<&MemberOutputs::mean_sweeps>(),
             .since = 10},
};

}  // namespace floes
