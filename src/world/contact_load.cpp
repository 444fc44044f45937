#include "world/contact_load.hpp"

#include "world/conversion.hpp"
#include "world/piece_dispatcher.hpp"

namespace floes {

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
                 .friction = from_bullet(point.m_lateralFrictionDir1 * (point.m_appliedImpulseLateral1 / time_step))});
        }
    }
}

}  // namespace floes
