// The contacts of a step: out of those that found them, and their impulses back.

#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>

#include "world/lane_solver.hpp"
#include "world/solver_state.hpp"

namespace floes {

namespace {

/// The part of the last impulse from which normal rows start. Cones start from the whole of it, or contacts near
/// sliding creep.
double kept_of_impulse(bool cone) {
    return cone ? 1.0 : btContactSolverInfo().m_warmstartingFactor;
}

/// With the cone a point remembers here which contact it was in the last solve, counted from 1; 0: none. Bullet keeps
/// this number while the point lasts, and a new point has 0. The direction of friction it does not keep.
double& number_in_last_solve(btManifoldPoint& point) {
    return point.m_appliedImpulseLateral2;
}

}  // namespace

/// Crushing needs overlap: a point without any exerts nothing. Rigid contacts act before they touch.
bool LaneSolver::acts(double distance) const {
    return definition_.contact.normal == NormalLaw::rigid || distance < 0;
}

void LaneSolver::read_contacts() {
    if (cone()) last_.swap(contacts_);
    contacts_.clear();
    sources_.clear();
    for_each_touching(
        *this, [&](std::uint32_t a, std::uint32_t b, auto& points) { read(a, b, moves(a) || moves(b), points); });
}

void LaneSolver::read(std::uint32_t a, std::uint32_t b, bool solvable, TouchingPoints& points) {
    const double friction = bodies_[a].friction * bodies_[b].friction;
    const double kept = kept_of_impulse(cone());
    for (int i = 0; i < points.count(); ++i) {
        TouchingPoint& point = points[i];
        if (!solvable || !acts(point.distance) || is_inside(a, b, point.normal)) {
            if (solvable) point.impulse = 0;
            point.slide = {};
            point.friction_impulse = 0;
            continue;
        }
        contacts_.push_back({.a = a,
                             .b = b,
                             .on_a = point.on_a,
                             .on_b = point.on_b,
                             .normal = point.normal,
                             .distance = point.distance,
                             .friction = friction,
                             .impulse = point.impulse * kept});
        set_section(contacts_.back());
        sources_.push_back({&point, nullptr});
        if (!cone()) continue;
        contacts_.back().slide = point.slide;
        contacts_.back().friction_impulse = point.friction_impulse;
    }
}

void LaneSolver::read(std::uint32_t a, std::uint32_t b, bool solvable, btPersistentManifold& manifold) {
    const double kept = kept_of_impulse(cone());
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        btManifoldPoint& point = manifold.getContactPoint(i);
        const auto number = static_cast<std::size_t>(number_in_last_solve(point));
        number_in_last_solve(point) = 0;
        if (!solvable) continue;
        if (!acts(point.getDistance()) || is_inside(a, b, array_of(point.m_normalWorldOnB))) {
            point.m_appliedImpulse = 0;
            continue;
        }
        contacts_.push_back({.a = a,
                             .b = b,
                             .on_a = array_of(point.getPositionWorldOnA()),
                             .on_b = array_of(point.getPositionWorldOnB()),
                             .normal = array_of(point.m_normalWorldOnB),
                             .distance = point.getDistance(),
                             .friction = point.m_combinedFriction,
                             .impulse = point.m_appliedImpulse * kept,
                             .solid = structure_ == a ? point.m_index0 : point.m_index1});
        set_section(contacts_.back());
        sources_.push_back({nullptr, &point});
        if (!cone() || number == 0) continue;
        contacts_.back().slide = last_[number - 1].slide;
        contacts_.back().friction_impulse = last_[number - 1].friction_impulse;
    }
}

void LaneSolver::write_contacts() {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const auto& [box, structure] = sources_[i];
        if (box != nullptr) {
            box->impulse = contacts_[i].impulse;
            box->slide = contacts_[i].slide;
            box->friction_impulse = contacts_[i].friction_impulse;
            continue;
        }
        structure->m_appliedImpulse = contacts_[i].impulse;
        if (cone()) number_in_last_solve(*structure) = static_cast<double>(i + 1);
    }
}

}  // namespace floes
