#include "world/checks.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"

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

void check_contact(const ContactLaw& law, ConstraintSolver solver) {
    const bool of_bullet =
        law.friction == Friction::one_direction && law.normal == NormalLaw::rigid && law.internal_edges;
    if (solver == ConstraintSolver::stock && !of_bullet) {
        throw InputError(
            "The world cannot be built: Bullet's own solver has friction in one direction, rigid contacts and internal "
            "edges that act, and nothing else; take general.solver = \"lanes\", or contact.preset = \"paper\".");
    }
    if (solver == ConstraintSolver::direct && law.friction != Friction::cone) {
        throw InputError(
            "The world cannot be built: the direct solver has friction in the whole contact plane only; take "
            "contact.friction = \"cone\".");
    }
    if (solver == ConstraintSolver::direct && law.normal == NormalLaw::rigid && law.split_impulse) {
        throw InputError(
            "The world cannot be built: the direct solver corrects every penetration within the impulse; take "
            "paper.split_impulse_depth_m = inf.");
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

void check(const BoxDefinition& box) {
    check_box(box.half_extents);
    require(box.mass > 0, "the mass of an element", box.mass, "above 0 kg");
}

void check(const FixedBoxDefinition& box) {
    check_box(box.half_extents);
}

void check(const JointDefinition& joint, std::size_t bodies, ConstraintSolver solver) {
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
    const bool direct = solver == ConstraintSolver::direct;
    if (!joint.spring) {
        require(!direct || joint.cfm > 0, "the joint CFM", joint.cfm, "above 0 with the direct solver");
        return;
    }
    if (!direct) throw InputError("The world cannot be built: only the direct solver has joints that are springs.");
    for (const auto& part : {joint.spring->force, joint.spring->moment}) {
        for (const double stiffness : part) {
            require(stiffness > 0 && std::isfinite(stiffness), "the stiffness of a joint", stiffness, "above 0");
        }
    }
    require(joint.spring->damping_ratio >= 0, "the damping ratio of a joint", joint.spring->damping_ratio,
            "at least 0");
}

void check_structure(std::span<const ConvexSolid> solids, bool present) {
    require(!present, "the number of structures", 2, "at most 1");
    require(!solids.empty(), "the number of solids of the structure", 0, "at least 1");
    for (const ConvexSolid& solid : solids) {
        if (const auto fault = solid.fault()) throw InputError(fmt::format("The world cannot be built: {}.", *fault));
    }
}

}  // namespace floes
