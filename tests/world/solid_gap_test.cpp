// How far ice is from a solid of the structure: as Bullet's detector finds it, by closed forms, and where it is hard.

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "collision/random_boxes.hpp"
#include "scene.hpp"
#include "world/bullet_shapes.hpp"
#include "world/hull_contacts.hpp"

namespace floes::test {
namespace solid_gap_test {

constexpr double everything = std::numeric_limits<double>::infinity();
constexpr double flatness = 1e-5;  ///< what the planes of a convex_hull() leave of depths
constexpr double half_thickness = 0.0165;

/// As pieces of an STL file are: many small facets beside large ones.
Polyhedron boulder(unsigned seed) {
    Dice dice(seed);
    std::vector<Vec3> points;
    for (int k = 0; k < 60; ++k)
        points.push_back(from_bullet(dice.vector(1)).normalized().cwiseProduct(Vec3(0.5, 0.3, 0.4)));
    for (int k = 0; k < 8; ++k) points.emplace_back(Vec3(0.45, 0.1, 0.1) + from_bullet(dice.vector(2e-3)));
    return convex_hull(points);
}

std::vector<ConvexSolid> solids() {
    std::vector<ConvexSolid> all;
    all.emplace_back(Frustum{-0.443, 0.43, 0.122, 0.736});
    all.emplace_back(Frustum{-0.3, 0.6, 0.4, 0.2});
    all.emplace_back(Frustum{-0.5, 0.3, 0.5, 0.3});
    all.emplace_back(Frustum{-0.4, 0, 0.2, 0.5});
    all.emplace_back(block({-0.8, -0.3, -0.4}, {0.8, 0.3, 0.4}));
    const std::vector<Vec3> bow{{0.9, 0.2, 0},     {0.6, -0.2, 0},    {0, 0.2, 0.35},    {0, 0.2, -0.35},
                                {0, -0.2, 0.3},    {0, -0.2, -0.3},   {-0.9, 0.2, 0.35}, {-0.9, 0.2, -0.35},
                                {-0.7, -0.2, 0.3}, {-0.7, -0.2, -0.3}};
    all.emplace_back(convex_hull(bow));
    all.emplace_back(boulder(3));
    return all;
}

struct Pair {
    SolidShape solid;
    IceShape ice;
    btTransform place;  ///< of the ice in the solid's axes

    Pair(const ConvexSolid& one, const Outline& corners, const Vec3& centre, const Quat& turn)
        : solid(one), ice(corners, half_thickness), place(to_bullet(Pose{centre, turn})) {}

    double margins() const { return solid.getMargin() + ice.core().margin; }
    PrismCorners prism(const Vec3& shift = Vec3::Zero()) const {
        return {ice.core(), from_bullet(place.getOrigin()) + shift, from_bullet(place.getBasis())};
    }
    SolidGap ours(double enough = everything) const { return gap_between(solid.core(), prism(), enough); }
};

struct Taken final : btDiscreteCollisionDetectorInterface::Result {
    void setShapeIdentifiersA(int, int) override {}
    void setShapeIdentifiersB(int, int) override {}
    void addContactPoint(const btVector3& to_a, const btVector3& on_b, btScalar depth) override {
        found = {depth, -from_bullet(to_a), from_bullet(on_b)};
    }
    SolidGap found{everything};
};

/// Of what is rounded by the margins, with the point on the prism's surface.
SolidGap bullets(const Pair& pair) {
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depths;
    btGjkPairDetector detector(&pair.solid, &pair.ice.convex(), &simplex, &depths);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = btTransform::getIdentity();
    input.m_transformB = pair.place;
    Taken taken;
    detector.getClosestPoints(input, taken, nullptr);
    return taken.found;
}

/// f(n) of the header.
double along(const Pair& pair, const Vec3& n, const Vec3& shift = Vec3::Zero()) {
    return n.dot(pair.prism(shift).nearest(n) - pair.solid.core().farthest(n));
}

double outside(const SolidCore& solid, const Vec3& point) {
    const Frustum* of = solid.round();
    if (of != nullptr)
        return std::max({point.y() - of->top_height, of->bottom_height - point.y(),
                         std::hypot(point.x(), point.z()) - of->radius_at(point.y())});
    double height = -everything;
    for (const Plane& face : solid.flat().planes) height = std::max(height, face.height(point));
    return height;
}

/// What is true of any answer: its gap is f along its normal, and the point is where that is.
void check_itself(const Pair& pair, const SolidGap& found) {
    EXPECT_NEAR(found.normal.norm(), 1, 1e-12);
    EXPECT_NEAR(found.gap, along(pair, found.normal), 1e-6);
    EXPECT_LE(found.normal.dot(found.on_prism), found.normal.dot(pair.prism().nearest(found.normal)) + 1e-6);
    const Vec3 on_solid = found.on_prism - found.gap * found.normal;
    EXPECT_LT(outside(pair.solid.core(), on_solid), 1e-6) << "there it meets the solid";
}

std::unique_ptr<Pair> random_pair(Dice& dice, const ConvexSolid& solid, double most) {
    const int sides = 4 + static_cast<int>(dice.between(0, 4.999));
    const double radius = dice.between(0.08, 0.15);
    const Outline outline =
        sides == 4 && dice.between(0, 1) < 0.5 ? corners_of(radius, dice.between(0.06, 0.15)) : regular(sides, radius);
    const Vec3 way = from_bullet(dice.vector(1)).normalized();
    const Quat turn = Quat(Eigen::AngleAxisd(dice.between(-3, 3), Vec3::UnitY())) *
                      Quat(Eigen::AngleAxisd(dice.between(0, 1.6), from_bullet(dice.vector(1)).normalized()));
    auto pair = std::make_unique<Pair>(solid, outline, way * 3, turn);
    // Along the way to where they have this gap.
    const double wanted = dice.between(-most, 0.02);
    double far = 3;
    for (int i = 0; i < 60; ++i) {
        const double gap = pair->ours().gap - pair->margins();
        if (std::abs(gap - wanted) < 1e-4) break;
        far -= gap - wanted;
        pair->place.setOrigin(to_bullet(Vec3(way * far)));
    }
    return pair;
}

TEST(SolidGap, IsBulletsOverManyPlaces) {
    Dice dice(11);
    int apart = 0;
    int deep = 0;
    int points = 0;
    int better = 0;  // of Bullet's depths
    const std::vector<ConvexSolid> all = solids();
    for (const ConvexSolid& solid : all) {
        for (int i = 0; i < 300; ++i) {
            const std::unique_ptr<Pair> made = random_pair(dice, solid, 0.012);
            const Pair& pair = *made;
            const SolidGap found = pair.ours();
            const SolidGap other = bullets(pair);
            check_itself(pair, found);
            const double gap = found.gap - pair.margins();
            if (found.gap < 1e-5) {
                // Bullet's depth is that of some facets within a round solid, and its normal no better than ours.
                ++deep;
                const double least = along(pair, other.normal);
                better += least > found.gap + flatness ? 1 : 0;
                EXPECT_GE(found.gap, (solid.form.index() == 0 ? 1.1 : 1) * least - flatness);
                continue;
            }
            ++apart;
            // Bullet ends within some hundredths of a millimetre, from above; f of check_itself is the bound from
            // below.
            EXPECT_LE(gap, other.gap + 1e-9);
            EXPECT_GE(gap, other.gap - 5e-5);
            EXPECT_LT((found.normal - other.normal).norm(), 0.02);
            const Vec3 on_b = found.on_prism - found.normal * pair.ice.core().margin;
            points += (on_b - other.on_prism).norm() < 1e-4 ? 1 : 0;
        }
    }
    EXPECT_GT(apart, 700);
    EXPECT_GT(deep, 400);
    EXPECT_LT(better, 0.01 * deep);
    EXPECT_GT(points, 0.97 * apart);
}

/// A prism whose axes are those of the solid, unless turned.
SolidGap at(const ConvexSolid& solid, const Vec3& centre, const Quat& turn = Quat::Identity(),
            const Outline& corners = corners_of(0.1, 0.08)) {
    const Pair pair(solid, corners, centre, turn);
    const SolidGap found = pair.ours();
    check_itself(pair, found);
    return {found.gap - pair.margins(), found.normal, found.on_prism - found.normal * pair.ice.core().margin};
}

void expect_at(const SolidGap& found, double gap, const Vec3& normal, const Vec3& on_prism) {
    EXPECT_NEAR(found.gap, gap, 1e-10);
    EXPECT_LT((found.normal - normal).norm(), 1e-9) << found.normal.transpose();
    EXPECT_LT((found.on_prism - on_prism).norm(), 1e-9) << found.on_prism.transpose();
}

const Quat on_its_corner(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitY()));
constexpr double ice_margin = 0.1 * half_thickness;
/// Apart, touching, less deep than the margins, where the cores just touch, and deeper.
constexpr std::array<double, 5> gaps{0.003, 0.0, -0.002, -(SolidShape::margin + ice_margin), -0.006};

TEST(SolidGap, OfFlushFacesIsInTheMiddleOfThem) {
    const ConvexSolid wall(block({-0.5, -0.3, -0.4}, {0.5, 0.3, 0.4}));
    for (const double gap : gaps) expect_at(at(wall, {0.6 + gap, 0.1, 0.2}), gap, Vec3::UnitX(), {0.5 + gap, 0.1, 0.2});
    // On top, where the prism lies over the edge: within both.
    const SolidGap over = at(wall, {0.48, 0.3 + half_thickness - 0.002, 0});
    EXPECT_NEAR(over.gap, -0.002, 1e-10);
    EXPECT_LT((over.normal - Vec3::UnitY()).norm(), 1e-9);
    EXPECT_LE(over.on_prism.x(), 0.5);
}

TEST(SolidGap, OfACornerOnAFaceKnowsHowItIsRounded) {
    const ConvexSolid wall(block({-0.5, -0.3, -0.4}, {0.5, 0.3, 0.4}));
    const double reach = std::sqrt(2.0) * (0.1 - ice_margin) + ice_margin;
    for (const double gap : gaps)
        expect_at(at(wall, {0.5 + reach + gap, 0.1, 0.2}, on_its_corner, corners_of(0.1, 0.1)), gap, Vec3::UnitX(),
                  {0.5 + gap, 0.1, 0.2});
}

// As the prism lies on the corner of a block: only its own face tells the normal.
TEST(SolidGap, OfACornerOfTheSolidIsAlongTheFaceOfTheIce) {
    const ConvexSolid wall(block({-0.5, -0.3, -0.5}, {0.5, 0.3, 0.5}));
    const Vec3 out = Vec3(1, 2, 1).normalized();
    const Quat turn = Quat::FromTwoVectors(Vec3::UnitY(), out);
    const Vec3 corner = Vec3(0.5, 0.3, 0.5) - Vec3::Constant(SolidShape::margin);
    for (const double gap : gaps) {
        const Vec3 on_prism = corner + (SolidShape::margin + gap) * out;
        expect_at(at(wall, on_prism + half_thickness * out, turn), gap, out, on_prism);
    }
}

TEST(SolidGap, OfEdgesThatCrossIsBetweenThem) {
    // The upright edge of the block at 45°, and the upper edge of the prism along (1, 0, -1), tilted to lead out of it.
    const ConvexSolid wall(block({-0.5, -0.3, -0.5}, {0.5, 0.3, 0.5}));
    const Vec3 out = Vec3(1, 0, 1).normalized();
    const Quat turn =
        Quat(Eigen::AngleAxisd(-std::numbers::pi / 4, Vec3::UnitY())) * Quat(Eigen::AngleAxisd(0.6, Vec3::UnitZ()));
    const double reach =
        std::cos(0.6) * (0.1 - ice_margin) + std::sin(0.6) * (half_thickness - ice_margin) + ice_margin;
    const double edge = std::sqrt(2.0) * (0.5 - SolidShape::margin) + SolidShape::margin;
    for (const double gap : gaps) {
        const SolidGap found = at(wall, (edge + reach + gap) * out, turn);
        EXPECT_NEAR(found.gap, gap, 1e-10);
        EXPECT_LT((found.normal - out).norm(), 1e-7);
        EXPECT_NEAR(found.on_prism.dot(out), edge + gap, 1e-9);
        EXPECT_NEAR(found.on_prism.x(), found.on_prism.z(), 1e-9) << "on the edge of the block";
    }
}

TEST(SolidGap, OfAConesWallIsAlongItsNormal) {
    const Frustum cone{-0.443, 0.43, 0.122, 0.736};
    const Vec3 normal = Vec3(0.565, -0.306, 0).normalized();
    const Vec3 on_wall(cone.radius_at(-0.05), -0.05, 0);
    // The upper edge of a level prism is the nearest, or an upper corner.
    const Vec3 core(0.1 - ice_margin, -(half_thickness - ice_margin), 0);
    for (const double gap : gaps) {
        const Vec3 on_prism = on_wall + gap * normal;
        expect_at(at(cone, on_prism + ice_margin * normal + core), gap, normal, on_prism);
        const Vec3 corner(std::sqrt(2.0) * core.x(), core.y(), 0);
        expect_at(at(cone, on_prism + ice_margin * normal + corner, on_its_corner, corners_of(0.1, 0.1)), gap, normal,
                  on_prism);
    }
}

TEST(SolidGap, OfTheRimOfADrumIsFromTheRim) {
    const Frustum drum{-0.5, 0.3, 0.5, 0.3};  // its core stands out at the ends by the margin
    const Vec3 out = Vec3(1, 1, 0).normalized();
    const Vec3 rim(0.3 - SolidShape::margin, 0.5, 0);
    const Quat turn(Eigen::AngleAxisd(-std::numbers::pi / 4, Vec3::UnitZ()));  // its y axis is `out`
    for (const double gap : gaps) {
        const SolidGap found = at(drum, rim + (SolidShape::margin + half_thickness + gap) * out, turn);
        EXPECT_NEAR(found.gap, gap, 1e-10);
        EXPECT_LT((found.normal - out).norm(), 1e-9);
        EXPECT_LT((found.on_prism - rim - (SolidShape::margin + gap) * out).norm(), 1e-9);
    }
}

// Less is told where more is not asked for, and never that they are nearer than they are.
TEST(SolidGap, IsABoundWhereItIsMoreThanEnough) {
    Dice dice(12);
    int bounds = 0;
    for (const ConvexSolid& solid : solids()) {
        for (int i = 0; i < 200; ++i) {
            const std::unique_ptr<Pair> pair = random_pair(dice, solid, 0.005);
            const SolidGap whole = pair->ours();
            const SolidGap found = pair->ours(0.004);
            EXPECT_EQ(found.gap > 0.004, whole.gap > 0.004);
            EXPECT_LE(found.gap, whole.gap + 1e-12);
            if (whole.gap <= 0.004) {
                EXPECT_EQ(found.gap, whole.gap);
            }
            bounds += found.gap > 0.004 ? 1 : 0;
        }
    }
    EXPECT_GT(bounds, 400);
}

BodyMotion motion_of(const Pair& pair, double way = 0, double turn = 0) {
    BodyMotion motion{};
    for (int i = 0; i < 3; ++i) {
        motion.position[i] = pair.place.getOrigin()[i];
        for (int k = 0; k < 3; ++k) motion.rotation[3 * i + k] = pair.place.getBasis()[i][k];
    }
    motion.way = way;
    motion.turn = turn;
    return motion;
}

/// Contacts of one element with a solid at rest.
struct Contacts {
    HullContacts hull;
    ContactStore store;
    std::array<LooseElement, 2> bodies;

    explicit Contacts(const Pair& pair, const ConvexSolid& solid) : bodies{LooseElement(), LooseElement(pair.ice)} {
        hull.set_structure(0, {&solid, 1}, NormalLaw::rigid);
        hull.add();
        hull.add();
    }
    std::vector<double> found(const BodyMotion* motions) {
        hull.find(bodies, motions, store);
        std::vector<double> distances;
        for (const Touching& one : hull.touching())
            for (int i = 0; i < store[one.points].count(); ++i) distances.push_back(store[one.points][i].distance);
        return distances;
    }
};

// A pair whose gap its way since then cannot have closed is not looked at, and would have had no point.
TEST(SolidGap, LetsNoPairBeLeftOutThatTouches) {
    Dice dice(13);
    int touching = 0;
    int first = 0;
    for (const ConvexSolid& solid : solids()) {
        for (int i = 0; i < 30; ++i) {
            const std::unique_ptr<Pair> pair = random_pair(dice, solid, 0.0);
            Contacts usual(*pair, solid);
            Contacts wary(*pair, solid);
            std::array<BodyMotion, 2> motions{BodyMotion{}, motion_of(*pair)};
            for (const std::size_t k : {0, 4, 8}) motions[0].rotation[k] = 1;
            std::size_t before = 0;
            for (int step = 0; step < 100; ++step) {
                wary.hull.distrust(1);
                const std::vector<double> expected = wary.found(motions.data());
                ASSERT_EQ(usual.found(motions.data()), expected);
                touching += expected.empty() ? 0 : 1;
                first += before == 0 && !expected.empty() ? 1 : 0;
                before = expected.size();
                const Vec3 way = from_bullet(dice.vector(2e-3));
                const Vec3 turn = from_bullet(dice.vector(5e-3));
                const Quat by(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
                pair->place = to_bullet(
                    Pose{from_bullet(pair->place.getOrigin()) + way, by * Quat(from_bullet(pair->place.getBasis()))});
                motions[1] = motion_of(*pair, way.norm(), turn.norm());
            }
        }
    }
    EXPECT_GT(touching, 1000);
    EXPECT_GT(first, 100);
}

}  // namespace solid_gap_test
}  // namespace floes::test
