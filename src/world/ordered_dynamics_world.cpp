#include "world/ordered_dynamics_world.hpp"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btConstraintSolver.h>

#include <algorithm>

#include "world/piece_dispatcher.hpp"

namespace floes {

void OrderedDynamicsWorld::remove_in_order(btTypedConstraint* joint) {
    const int position = m_constraints.findLinearSearch(joint);
    for (int i = position; i + 1 < m_constraints.size(); ++i) m_constraints[i] = m_constraints[i + 1];
    m_constraints.pop_back();
}

void OrderedDynamicsWorld::collect_manifolds() {
    entries_.clear();
    const btDispatcher& dispatcher = *getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        btPersistentManifold* const manifold = const_cast<btDispatcher&>(dispatcher).getManifoldByIndexInternal(i);
        const btCollisionObject& a = *manifold->getBody0();
        const btCollisionObject& b = *manifold->getBody1();
        // The manifold of two bodies that became one piece is no longer updated: its old contacts must not act.
        if (same_piece(a, b)) manifold->clearManifold();
        if (manifold->getNumContacts() == 0) continue;
        const btManifoldPoint& first = manifold->getContactPoint(0);
        entries_.push_back({{body_id_of(a), body_id_of(b), first.m_index0, first.m_index1}, manifold});
    }
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
    manifolds_.clear();
    for (const Entry& entry : entries_) manifolds_.push_back(entry.manifold);
}

void OrderedDynamicsWorld::solveConstraints(btContactSolverInfo& info) {
    collect_manifolds();
    const int joints = m_constraints.size();
    const int manifolds = static_cast<int>(manifolds_.size());
    m_constraintSolver->solveGroup(
        &m_collisionObjects[0], m_collisionObjects.size(), manifolds > 0 ? manifolds_.data() : nullptr, manifolds,
        joints > 0 ? &m_constraints[0] : nullptr, joints, info, m_debugDrawer, getDispatcher());
}

}  // namespace floes
