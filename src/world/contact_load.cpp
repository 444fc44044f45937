#include "world/contact_load.hpp"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include "world/conversion.hpp"
#include "world/piece_dispatcher.hpp"

namespace floes {
namespace {

Vec3 vector_of(const std::array<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// Which solid touches: only the structure has several.
int solid_at(const btPersistentManifold& manifold, const btManifoldPoint& point) {
    if (manifold.getBody0()->getCollisionShape()->isCompound()) return point.m_index0;
    return manifold.getBody1()->getCollisionShape()->isCompound() ? point.m_index1 : -1;
}

}  // namespace

Vec3 contact_load(std::span<btPersistentManifold* const> manifolds, const btCollisionObject* body, double time_step) {
    btVector3 impulse(0, 0, 0);
    for (const btPersistentManifold* manifold : manifolds) {
        // Bullet's normal points from body 1 to body 0; impulses act on body 0.
        const double side = manifold->getBody0() == body ? 1.0 : manifold->getBody1() == body ? -1.0 : 0.0;
        if (side == 0.0) continue;
        for (int i = 0; i < manifold->getNumContacts(); ++i) {
            const btManifoldPoint& point = manifold->getContactPoint(i);
            impulse += side * (point.m_normalWorldOnB * point.m_appliedImpulse +
                               point.m_lateralFrictionDir1 * point.m_appliedImpulseLateral1);
        }
    }
    return from_bullet(impulse) / time_step;
}

void read_contact_forces(std::span<btPersistentManifold* const> manifolds, const btCollisionObject* body,
                         double time_step, std::vector<ContactForce>& found) {
    found.clear();
    for (const btPersistentManifold* manifold : manifolds) {
        if (body != nullptr && manifold->getBody0() != body && manifold->getBody1() != body) continue;
        for (int i = 0; i < manifold->getNumContacts(); ++i) {
            const btManifoldPoint& point = manifold->getContactPoint(i);
            if (point.m_appliedImpulse == 0 && point.m_appliedImpulseLateral1 == 0) continue;
            found.push_back(
                {.a = BodyId(static_cast<std::size_t>(body_id_of(*manifold->getBody0()))),
                 .b = BodyId(static_cast<std::size_t>(body_id_of(*manifold->getBody1()))),
                 .point = from_bullet((point.getPositionWorldOnA() + point.getPositionWorldOnB()) / 2),
                 .normal = from_bullet(point.m_normalWorldOnB * (point.m_appliedImpulse / time_step)),
                 .friction = from_bullet(point.m_lateralFrictionDir1 * (point.m_appliedImpulseLateral1 / time_step)),
                 .solid = solid_at(*manifold, point)});
        }
    }
}

Vec3 contact_load(std::span<const SolverContact> contacts, BodyId body, double time_step) {
    Vec3 impulse = Vec3::Zero();
    for (const SolverContact& contact : contacts) {
        const double side = contact.a == body.index() ? 1.0 : contact.b == body.index() ? -1.0 : 0.0;
        if (side == 0.0) continue;
        const Vec3 on_a =
            vector_of(contact.normal) * contact.impulse + vector_of(contact.slide) * contact.friction_impulse;
        impulse += side * on_a;
    }
    return impulse / time_step;
}

void read_contact_forces(std::span<const SolverContact> contacts, std::optional<BodyId> body, double time_step,
                         std::vector<ContactForce>& found) {
    found.clear();
    for (const SolverContact& contact : contacts) {
        if (body && contact.a != body->index() && contact.b != body->index()) continue;
        if (contact.impulse == 0 && contact.friction_impulse == 0) continue;
        found.push_back({.a = BodyId(contact.a),
                         .b = BodyId(contact.b),
                         .point = (vector_of(contact.on_a) + vector_of(contact.on_b)) / 2,
                         .normal = vector_of(contact.normal) * (contact.impulse / time_step),
                         .friction = vector_of(contact.slide) * (contact.friction_impulse / time_step),
                         .solid = contact.solid});
    }
}

}  // namespace floes
