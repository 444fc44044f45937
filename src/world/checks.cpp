#include "world/checks.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "shapes/elements.hpp"

namespace floes {

namespace {

void require(bool allowed, const char* what, double value, const char* range) {
    if (!allowed)
        throw InputError(fmt::format("The world cannot be built: {} is {}; it must be {}.", what, value, range));
}

void check_box(const Vec3& half_extents) {
    require((half_extents.array() > 0).all(), "the smallest half extent of a box", half_extents.minCoeff(),
            "above 0 m");
}

void refuse(const Refusal& refusal) {
    throw InputError(fmt::format("The world refuses this: {}; take {}.", refusal.reason, refusal.instead));
}

void check_contact(const ContactLaw& law, SolverKind solver) {
    for (const Refusal& refusal : refused_contacts(solver, law)) refuse(refusal);
    // Bullet limits a combined coefficient to 10.
    for (const double friction : {law.ice_ice_friction, law.ice_structure_friction}) {
        require(friction >= 0 && friction <= 10, "a coefficient of friction", friction, "between 0 and 10");
    }
    require(law.normal == NormalLaw::rigid || law.crushing_pressure > 0, "the crushing pressure", law.crushing_pressure,
            "above 0 Pa");
    require(law.erp >= 0 && law.erp <= 1, "the contact ERP", law.erp, "between 0 and 1");
    require(law.split_impulse_depth >= 0, "the split impulse depth", law.split_impulse_depth, "at least 0 m");
}

}  // namespace

void check(const WorldDefinition& d) {
    require(d.time_step > 0, "the time step", d.time_step, "above 0 s");
    require(d.iterations >= 1, "the number of iterations", d.iterations, "at least 1");
    require(std::isfinite(d.gravity), "gravity", d.gravity, "a finite number");
    require(d.length_unit > 0 && std::isfinite(d.length_unit), "the unit of length", d.length_unit, "above 0 m");
    check_contact(d.contact, d.solver);
}

void check(const ElementDefinition& element) {
    require(element.half_thickness > 0, "half the thickness of an element", element.half_thickness, "above 0 m");
    require(element.mass > 0, "the mass of an element", element.mass, "above 0 kg");
    if (const auto fault = fault_of(element.corners))
        throw InputError(fmt::format("The world cannot be built: an element is no convex polygon: {}.", *fault));
    require(element.corners.size() <= most_corners, "the number of corners of an element",
            static_cast<double>(element.corners.size()), fmt::format("at most {}", most_corners).c_str());
    const Measures of = measures_of(element.corners);
    require(of.area > 0, "the area of an element", of.area, "above 0 m², with corners from x to z");
    require(std::abs(of.centroid.x) + std::abs(of.centroid.z) <= 1e-6 * reach_of(element.corners) &&
                std::abs(of.xz) <= 1e-6 * (of.xx + of.zz),
            "the product of inertia of an element", of.xz, "0, about its centre of mass");
}

void check(const FixedBoxDefinition& box) {
    check_box(box.half_extents);
}

void check(const SlidingBoxDefinition& box) {
    check_box(box.half_extents);
    require(box.mass > 0, "the mass of a sliding box", box.mass, "above 0 kg");
    require(box.axis >= 0 && box.axis <= 2, "the axis of a sliding box", box.axis, "0, 1 or 2");
}

void check(const JointDefinition& joint, std::size_t bodies, SolverKind solver) {
    const auto last = static_cast<double>(bodies) - 1;
    for (const BodyId body : {joint.a, joint.b}) {
        require(body.index() < bodies, "the index of a joined body", static_cast<double>(body.index()),
                fmt::format("at most {}", last).c_str());
    }
    require(joint.a != joint.b, "the second body of a joint", static_cast<double>(joint.b.index()),
            "another than the first");
    // The sweeps are an over-relaxation by 1 + Σ, which does not converge from 1 on.
    require(joint.cfm >= 0 && joint.cfm < 1, "the joint CFM", joint.cfm, "at least 0 and below 1");
    require(joint.erp >= 0 && joint.erp <= 1, "the joint ERP", joint.erp, "between 0 and 1");
    if (!joint.spring) {
        require(solver != SolverKind::direct || joint.cfm > 0, "the joint CFM", joint.cfm,
                "above 0 with the direct solver");
        return;
    }
    if (const auto refusal = refused_springs(solver)) refuse(*refusal);
    for (const auto& part : {joint.spring->force, joint.spring->moment}) {
        for (const double stiffness : part) {
            require(stiffness > 0 && std::isfinite(stiffness), "the stiffness of a joint", stiffness, "above 0");
        }
    }
    require(joint.spring->damping_ratio >= 0, "the damping ratio of a joint", joint.spring->damping_ratio,
            "at least 0");
}

void check(const CarriedWater& water, SolverKind solver) {
    if (const auto refusal = refused_water(solver)) refuse(*refusal);
    for (const double mass : {water.in_plane, water.normal})
        require(mass >= 0 && std::isfinite(mass), "a mass of water", mass, "at least 0 kg");
    for (const double inertia : {water.yaw, water.xx, water.zz})
        require(inertia >= 0 && std::isfinite(inertia), "a moment of inertia of water", inertia, "at least 0 kg m²");
    require(water.x * water.x <= water.normal * water.xx && water.z * water.z <= water.normal * water.zz &&
                water.xz * water.xz <= water.xx * water.zz,
            "the first moment of the water along x", water.x, "that of a mass somewhere");
}

void check_softening(double sound, SolverKind solver) {
    if (const auto refusal = refused_cracks(solver)) refuse(*refusal);
    require(sound > 0 && sound <= 1, "the share of a joint's stiffness that is left", sound, "above 0 and at most 1");
}

void check_sleep(SolverKind solver) {
    if (const auto refusal = refused_sleep(solver)) refuse(*refusal);
}

void check_structure(std::span<const ConvexSolid> solids, bool present) {
    require(!present, "the number of structures", 2, "at most 1");
    require(!solids.empty(), "the number of solids of the structure", 0, "at least 1");
    for (const ConvexSolid& solid : solids) {
        if (const auto fault = solid.fault()) throw InputError(fmt::format("The world cannot be built: {}.", *fault));
    }
}

}  // namespace floes
