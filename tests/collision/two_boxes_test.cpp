// Two boxes tumble about each other: in every step the same points as Bullet's, to the last bit.

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "collision/overlap.hpp"
#include "collision/random_boxes.hpp"
#include "collision/touching_points.hpp"

namespace floes {
namespace two_boxes_test {

using test::Dice;

struct Bullet {
    explicit Bullet(std::array<btBoxShape, 2>& shapes) {
        for (std::size_t i = 0; i < 2; ++i) objects[i].setCollisionShape(&shapes[i]);
    }
    ~Bullet() {
        if (algorithm == nullptr) return;
        algorithm->~btCollisionAlgorithm();
        dispatcher.freeCollisionAlgorithm(algorithm);
    }

    btPersistentManifold& touch() {
        const btCollisionObjectWrapper a(nullptr, objects[0].getCollisionShape(), &objects[0],
                                         objects[0].getWorldTransform(), -1, -1);
        const btCollisionObjectWrapper b(nullptr, objects[1].getCollisionShape(), &objects[1],
                                         objects[1].getWorldTransform(), -1, -1);
        if (algorithm == nullptr) algorithm = dispatcher.findAlgorithm(&a, &b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
        btManifoldResult result(&a, &b);
        algorithm->processCollision(&a, &b, info, &result);
        return *dispatcher.getManifoldByIndexInternal(0);
    }

    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDispatcherInfo info;
    std::array<btCollisionObject, 2> objects;
    btCollisionAlgorithm* algorithm = nullptr;
};

void expect_same(const TouchingPoints& ours, const btPersistentManifold& bullet) {
    ASSERT_EQ(ours.count(), bullet.getNumContacts());
    for (int i = 0; i < ours.count(); ++i) {
        const btManifoldPoint& point = bullet.getContactPoint(i);
        for (int k = 0; k < 3; ++k) {
            const auto at = static_cast<std::size_t>(k);
            EXPECT_EQ(ours[i].on_a[at], point.getPositionWorldOnA()[k]);
            EXPECT_EQ(ours[i].on_b[at], point.getPositionWorldOnB()[k]);
            EXPECT_EQ(ours[i].in_a[at], point.m_localPointA[k]);
            EXPECT_EQ(ours[i].in_b[at], point.m_localPointB[k]);
            EXPECT_EQ(ours[i].normal[at], point.m_normalWorldOnB[k]);
        }
        EXPECT_EQ(ours[i].distance, point.getDistance());
        EXPECT_EQ(ours[i].impulse, point.m_appliedImpulse);
    }
}

void take_up(TouchingPoints& points, const PrismPlace& a, const PrismPlace& b, const Overlap& overlap, double reach) {
    const Triple normal{-overlap.normal[0], -overlap.normal[1], -overlap.normal[2]};
    for (int i = 0; i < overlap.count; ++i) {
        const auto& [on_b, depth] = overlap.points[static_cast<std::size_t>(i)];
        points.add(a, b, on_b, normal, -depth, reach);
    }
    points.refresh(a, b, reach);
}

Triple axis_of(const PrismPlace& box, int k) {
    return {box.rotation[k], box.rotation[3 + k], box.rotation[6 + k]};
}

/// Along which axis they overlap: 1, 2, 3: a face of a; 4, 5, 6: of b; 7 to 15: an edge of a times one of b; 0: apart.
int code_of(const PrismPlace& a, const PrismPlace& b, const Overlap& overlap) {
    if (overlap.count == 0) return 0;
    const auto along = [&](const Triple& axis) {
        return std::abs(dot(axis, overlap.normal)) > (1 - 1e-12) * std::sqrt(dot(axis, axis));
    };
    for (int k = 0; k < 3; ++k)
        if (along(axis_of(a, k))) return 1 + k;
    for (int k = 0; k < 3; ++k)
        if (along(axis_of(b, k))) return 4 + k;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            const Triple of_a = axis_of(a, i);
            const Triple of_b = axis_of(b, k);
            if (along({of_a[1] * of_b[2] - of_a[2] * of_b[1], of_a[2] * of_b[0] - of_a[0] * of_b[2],
                       of_a[0] * of_b[1] - of_a[1] * of_b[0]}))
                return 7 + 3 * i + k;
        }
    }
    ADD_FAILURE() << "an axis of no box";
    return -1;
}

/// Steps in which a code of axis was that of least overlap, 0 for boxes apart.
std::map<int, int> tumble(std::array<btBoxShape, 2> shapes, unsigned seed, double tilt, int steps) {
    Dice dice(seed);
    Bullet bullet(shapes);
    std::array<btTransform, 2> poses;
    for (btTransform& pose : poses) pose.setIdentity();
    const PrismShape prisms[] = {test::prism_of(shapes[0]), test::prism_of(shapes[1])};
    TouchingPoints points;
    std::map<int, int> codes;
    for (int step = 0; step < steps; ++step) {
        for (btTransform& pose : poses) {
            // Drawn back to each other, so that they touch often.
            const btVector3 pull = -0.02 * (pose.getOrigin() - poses[0].getOrigin());
            pose = test::moved(pose, pull + dice.vector(0.004),
                               dice.vector(tilt) + btVector3(0, dice.between(0, 0.02), 0));
        }
        if (step % 50 == 0) poses[1].setOrigin(poses[0].getOrigin() + btVector3(dice.between(-0.2, 0.2), 0.01, 0.15));
        for (std::size_t i = 0; i < 2; ++i) bullet.objects[i].setWorldTransform(poses[i]);
        const BodyMotion at[] = {test::motion_of(poses[0]), test::motion_of(poses[1])};
        const PrismPlace a{&prisms[0], at[0].position, at[0].rotation};
        const PrismPlace b{&prisms[1], at[1].position, at[1].rotation};
        Overlap overlap;
        find_overlap(a, b, overlap);
        take_up(points, a, b, overlap,
                std::min(shapes[0].getContactBreakingThreshold(0.02), shapes[1].getContactBreakingThreshold(0.02)));
        btPersistentManifold& found = bullet.touch();
        expect_same(points, found);
        if (::testing::Test::HasFailure()) return codes;
        for (int i = 0; i < points.count(); ++i)
            points[i].impulse = found.getContactPoint(i).m_appliedImpulse = dice.between(0, 1);
        ++codes[code_of(a, b, overlap)];
    }
    return codes;
}

TEST(TwoBoxes, TouchWhereBulletSaysAlongEveryAxis) {
    std::map<int, int> codes;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const std::array<btBoxShape, 2> elements{btBoxShape({0.1, 0.0165, 0.1}), btBoxShape({0.1, 0.0165, 0.1})};
        for (const auto& [code, steps] : tumble(elements, seed, seed % 2 == 0 ? 0.05 : 1e-4, 500)) codes[code] += steps;
        ASSERT_FALSE(HasFailure()) << "seed " << seed;
    }
    for (unsigned seed = 0; seed < 10; ++seed) {
        const std::array<btBoxShape, 2> unlike{btBoxShape({0.12, 0.09, 0.1}), btBoxShape({0.06, 0.11, 0.07})};
        for (const auto& [code, steps] : tumble(unlike, seed, 0.2, 500)) codes[code] += steps;
        ASSERT_FALSE(HasFailure()) << "seed " << seed;
    }
    for (int code = 0; code <= 15; ++code) EXPECT_GT(codes[code], 0) << code;
}

TEST(TwoBoxes, AlignedBoxesTouchWhereBulletSays) {
    Dice dice(3);
    std::array<btBoxShape, 2> shapes{btBoxShape({0.1, 0.02, 0.1}), btBoxShape({0.1, 0.02, 0.1})};
    const PrismShape prism = test::prism_of(shapes[0]);
    for (int i = 0; i < 200; ++i) {
        Bullet bullet(shapes);
        std::array<btTransform, 2> poses;
        for (btTransform& pose : poses) pose.setIdentity();
        poses[1].setOrigin({dice.between(-0.22, 0.22), i % 3 == 0 ? 0.0 : 0.03, i % 5 == 0 ? 0.2 : 0.1});
        for (std::size_t k = 0; k < 2; ++k) bullet.objects[k].setWorldTransform(poses[k]);
        const BodyMotion at[] = {test::motion_of(poses[0]), test::motion_of(poses[1])};
        const PrismPlace a{&prism, at[0].position, at[0].rotation};
        const PrismPlace b{&prism, at[1].position, at[1].rotation};
        Overlap overlap;
        TouchingPoints points;
        find_overlap(a, b, overlap);
        take_up(points, a, b, overlap, shapes[0].getContactBreakingThreshold(0.02));
        expect_same(points, bullet.touch());
    }
}

}  // namespace two_boxes_test
}  // namespace floes
