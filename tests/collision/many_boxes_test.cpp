// Many boxes drift among each other: in every step the same contacts as in a world of Bullet, which looks at every
// pair, to the last bit.

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <vector>

#include "collision/ice_contacts.hpp"
#include "collision/random_boxes.hpp"

namespace floes {
namespace many_boxes_test {

using test::Dice;

/// Boxes of different sizes in one layer, two to a piece, on a long fixed one.
class Crowd {
  public:
    explicit Crowd(unsigned seed) : dice_(seed) {
        add(btVector3(3, 0.05, 1), btVector3(0, -0.06, 0), -1, true);
        for (int i = 0; i < 40; ++i) {
            const btVector3 half(dice_.between(0.05, 0.1), 0.0165, dice_.between(0.05, 0.1));
            add(half, {0.17 * (i % 8) - 0.6, dice_.between(0, 0.02), 0.17 * (i / 8) - 0.3}, i / 2, false);
        }
    }
    ~Crowd() {
        for (btCollisionObject& object : objects_) world_.removeCollisionObject(&object);
    }

    /// Returns the number of points.
    int step(double speed) {
        for (std::size_t i = 1; i < objects_.size(); ++i) {
            const btTransform& pose = objects_[i].getWorldTransform();
            const btVector3 pull(-0.01 * pose.getOrigin().x(), -0.05 * pose.getOrigin().y(),
                                 -0.01 * pose.getOrigin().z());
            const btVector3 way = speed * (pull + dice_.vector(0.01));
            const btVector3 turn = speed * btVector3(dice_.between(-0.02, 0.02), dice_.between(-0.1, 0.1), 0);
            objects_[i].setWorldTransform(test::moved(pose, way, turn));
            motions_[i] = test::motion_of(objects_[i].getWorldTransform(), way, turn);
        }
        ours_.find(motions_.data(), store_);
        world_.performDiscreteCollisionDetection();
        return compare();
    }

    /// Puts a box of both somewhere else.
    void throw_one(std::size_t box) {
        objects_[box].getWorldTransform().setOrigin(dice_.vector(0.3));
        motions_[box] = test::motion_of(objects_[box].getWorldTransform());
        world_.getBroadphase()->getOverlappingPairCache()->cleanProxyFromPairs(objects_[box].getBroadphaseHandle(),
                                                                               &dispatcher_);
        ours_.move(static_cast<std::uint32_t>(box), store_);
    }

    void set_piece(std::size_t box, int piece) {
        objects_[box].setUserIndex2(piece);
        ours_.set_piece(static_cast<std::uint32_t>(box), piece);
    }

  private:
    class Pieces final : public btCollisionDispatcher {
      public:
        using btCollisionDispatcher::btCollisionDispatcher;
        bool needsCollision(const btCollisionObject* a, const btCollisionObject* b) override {
            return !(a->getUserIndex2() >= 0 && a->getUserIndex2() == b->getUserIndex2());
        }
    };

    void add(const btVector3& half, const btVector3& at, int piece, bool fixed) {
        btBoxShape& shape = shapes_.emplace_back(half);
        btCollisionObject& object = objects_.emplace_back();
        object.setCollisionShape(&shape);
        object.setWorldTransform(btTransform(btQuaternion::getIdentity(), at));
        object.setUserIndex(static_cast<int>(objects_.size()) - 1);
        object.setUserIndex2(piece);
        world_.addCollisionObject(&object);
        motions_.push_back(test::motion_of(object.getWorldTransform()));
        ours_.add({test::prism_of(shape), shape.getContactBreakingThreshold(0.02), fixed, piece});
    }

    int compare() {
        std::map<std::pair<int, int>, const btPersistentManifold*> theirs;
        for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
            const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(i);
            if (manifold->getNumContacts() == 0 ||
                !dispatcher_.needsCollision(manifold->getBody0(), manifold->getBody1()))
                continue;
            theirs[{manifold->getBody0()->getUserIndex(), manifold->getBody1()->getUserIndex()}] = manifold;
        }
        int points = 0;
        EXPECT_EQ(ours_.touching().size(), theirs.size());
        auto next = theirs.begin();
        for (const Touching& pair : ours_.touching()) {
            if (next == theirs.end()) return points;
            EXPECT_EQ(std::pair(static_cast<int>(pair.a), static_cast<int>(pair.b)), next->first);
            const TouchingPoints& found = store_[pair.points];
            EXPECT_EQ(found.count(), next->second->getNumContacts());
            for (int i = 0; i < std::min(found.count(), next->second->getNumContacts()); ++i) {
                const btManifoldPoint& point = next->second->getContactPoint(i);
                EXPECT_EQ(found[i].distance, point.getDistance());
                for (int k = 0; k < 3; ++k) {
                    EXPECT_EQ(found[i].on_a[static_cast<std::size_t>(k)], point.getPositionWorldOnA()[k]);
                    EXPECT_EQ(found[i].normal[static_cast<std::size_t>(k)], point.m_normalWorldOnB[k]);
                }
                ++points;
            }
            ++next;
        }
        return points;
    }

    Dice dice_;
    btDefaultCollisionConfiguration configuration_;
    Pieces dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
    std::deque<btBoxShape> shapes_;
    std::deque<btCollisionObject> objects_;
    std::vector<BodyMotion> motions_;
    ContactStore store_;
    IceContacts ours_;
};

TEST(ManyBoxes, TouchWhereBulletSays) {
    for (unsigned seed = 0; seed < 6; ++seed) {
        Crowd crowd(seed);
        int points = 0;
        for (int i = 0; i < 400; ++i) {
            points += crowd.step(seed % 2 == 0 ? 1 : 0.05);
            ASSERT_FALSE(HasFailure()) << "seed " << seed << ", step " << i;
        }
        EXPECT_GT(points, 4000) << seed;
    }
}

TEST(ManyBoxes, TouchWhereBulletSaysWhenPiecesChangeAndBoxesAreMoved) {
    Crowd crowd(17);
    for (int i = 0; i < 400; ++i) {
        if (i % 40 == 7) crowd.throw_one(static_cast<std::size_t>(1 + i / 40));
        if (i % 40 == 21) crowd.set_piece(static_cast<std::size_t>(1 + i / 20), i % 80 == 21 ? -1 : 3);
        crowd.step(0.3);
        ASSERT_FALSE(HasFailure()) << "step " << i;
    }
}

}  // namespace many_boxes_test
}  // namespace floes
