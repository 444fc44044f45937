#include "campaign/hull_file.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "campaign/closed_bodies.hpp"
#include "campaign/drawn.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace hull_file_test {

Surface body_of(const std::vector<Triangle3>& triangles) {
    const Surface surface = read_surface(stl_text({{"one", triangles}}), "one.stl");
    std::vector<Surface> bodies = closed_bodies(surface, "one.stl");
    EXPECT_EQ(bodies.size(), 1U);
    return bodies.front();
}

double volume_of_all(const std::vector<ConvexPiece>& pieces) {
    double volume = 0;
    for (const ConvexPiece& piece : pieces) volume += piece.body.volume();
    return volume;
}

const std::vector<std::pair<double, double>> l_shape{{0, 0}, {30, 0}, {30, 10}, {10, 10}, {10, 30}, {0, 30}};
const std::vector<std::array<std::size_t, 3>> l_cut{{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}};

std::string refusal_of(const std::string& bytes, const std::string& name, const HullFile& file = {}) {
    Structure structure;
    structure.hull_file = file;
    return refusal_or("", [&] { take_hull(structure, bytes, name); });
}

TEST(ConvexPieces, AConvexBodyIsTakenAsItIs) {
    const std::vector<ConvexPiece> pieces = convex_pieces(body_of(box({0, 0, 0}, {3, 2, 1})), 64);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(pieces.front().body.corners.size(), 8U);
    EXPECT_EQ(pieces.front().body.volume(), 6);
}

TEST(ConvexPieces, ACornerIsCutExactlyInTwo) {
    const std::vector<ConvexPiece> pieces = convex_pieces(body_of(prism(l_shape, l_cut, 10)), 64);
    EXPECT_EQ(pieces.size(), 2U);
    EXPECT_NEAR(volume_of_all(pieces), 5000, 1e-6);
}

TEST(ConvexPieces, TwoHullsOnADeckAreThree) {
    const Surface body = body_of(prism({{0, 0}, {10, 0}, {10, 20}, {30, 20}, {30, 0}, {40, 0}, {40, 25}, {0, 25}},
                                       {{0, 1, 2}, {0, 2, 7}, {2, 6, 7}, {2, 3, 6}, {3, 4, 5}, {3, 5, 6}}, 100));
    const std::vector<ConvexPiece> pieces = convex_pieces(body, 64);
    EXPECT_EQ(pieces.size(), 3U);
    EXPECT_NEAR(volume_of_all(pieces), volume_of(body), 1e-6 * volume_of(body));
}

// The hull of the whole holds 5/3 of it. Pieces cover the body, and hardly more.
TEST(ConvexPieces, ASurfaceThatCurvesInwardsIsFilledALittle) {
    const Surface body = body_of(hourglass(24, 12));
    const std::vector<ConvexPiece> pieces = convex_pieces(body, 64);
    Shape shape(HullKind::file, {});
    std::vector<std::vector<double>> rows;
    for (std::size_t k = 0; k < pieces.size(); ++k)
        for (const Vec3& corner : pieces[k].body.corners)
            rows.push_back({static_cast<double>(k), 0, corner.x(), corner.y(), corner.z()});
    shape.set_pieces(rows);
    shape.part_list() = "hull";
    EXPECT_LE(pieces.size(), 64U);
    EXPECT_GT(shape.volume() / volume_of(body), 0.999);
    EXPECT_LT(shape.volume() / volume_of(body), 1.05);
    for (std::size_t t = 0; t < body.triangles.size(); ++t) {
        const Vec3 middle = (body.corner(t, 0) + body.corner(t, 1) + body.corner(t, 2)) / 3;
        bool covered = false;
        for (const ConvexPiece& piece : pieces)
            covered = covered || std::ranges::all_of(piece.body.planes,
                                                     [&](const Plane& plane) { return plane.height(middle) < 1e-5; });
        EXPECT_TRUE(covered) << middle.transpose();
    }
}

TEST(ConvexPieces, AreTheSameEachTime) {
    const Surface body = body_of(hourglass(16, 8));
    const std::vector<ConvexPiece> once = convex_pieces(body, 20);
    const std::vector<ConvexPiece> again = convex_pieces(body, 20);
    ASSERT_EQ(once.size(), again.size());
    for (std::size_t k = 0; k < once.size(); ++k) EXPECT_EQ(once[k].body, again[k].body);
}

// In mm, z up, forward -y, the waterline 6 m above the file's zero.
TEST(TakeHull, TurnsAndScalesTheFile) {
    Structure structure;
    structure.hull_file = {
        .path = "x.stl", .unit = LengthUnit::mm, .up = HullAxis::plus_z, .forward = HullAxis::minus_y, .waterline = 6};
    take_hull(structure, stl_bytes(box({0, 0, 0}, {20000, 100000, 10000})), "x.stl");
    structure.shape.set_kind(HullKind::file);
    const Shape& shape = structure.shape;
    ASSERT_FALSE(shape.fault()) << *shape.fault();
    EXPECT_NEAR(shape.draught(), 6, 1e-6);
    EXPECT_NEAR(shape.top(), 4, 1e-6);
    EXPECT_NEAR(shape.waterline_radius(), 10, 1e-6) << "the axis is in the middle";
    EXPECT_NEAR(shape.waterline_ahead(), 50, 1e-6);
    EXPECT_NEAR(shape.volume(), 20000, 1e-3);
    EXPECT_NEAR(structure.hull_file.volume, 20000, 1e-3);
    EXPECT_TRUE(structure.hull_file.path.empty());
    EXPECT_EQ(shape.parts(), std::vector<std::string>{"hull"});
}

TEST(TakeHull, TextAndBytesGiveTheSamePieces) {
    const std::vector<Triangle3> triangles = box({-2, -3, -1}, {2, 3, 1});
    Structure text;
    Structure bytes;
    take_hull(text, stl_text({{"hull", triangles}}), "a.stl");
    take_hull(bytes, stl_bytes(triangles), "b.STL");
    EXPECT_EQ(text.shape.piece_rows(), bytes.shape.piece_rows());
}

TEST(TakeHull, SolidsAndBodiesAreParts) {
    const auto legs = [] {
        std::vector<std::pair<std::string, std::vector<Triangle3>>> all;
        for (const double x : {-20.0, 20.0})
            for (const double y : {-20.0, 20.0})
                all.emplace_back(fmt::format("leg {}", all.size() + 1), box({x - 4, y - 4, -10}, {x + 4, y + 4, 5}));
        return all;
    }();
    Structure named;
    take_hull(named, stl_text(legs), "legs.stl");
    EXPECT_EQ(named.shape.part_list(), "leg 1, leg 2, leg 3, leg 4");
    std::vector<Triangle3> together;
    for (const auto& [name, triangles] : legs) together.insert(together.end(), triangles.begin(), triangles.end());
    Structure one;
    take_hull(one, stl_bytes(together), "legs.stl");
    EXPECT_EQ(one.shape.part_list(), "body 1, body 2, body 3, body 4");
    one.shape.set_kind(HullKind::file);
    EXPECT_FALSE(one.shape.fault());
    EXPECT_EQ(one.shape.waterline_ellipses().size(), 4U);
}

TEST(TakeHull, SolidsMayTouch) {
    Structure structure;
    take_hull(structure, stl_text({{"fore", box({0, -1, -1}, {2, 1, 1})}, {"aft", box({-2, -1, -1}, {0, 1, 1})}}),
              "x.stl");
    EXPECT_EQ(structure.shape.part_list(), "fore, aft");
    EXPECT_NEAR(structure.hull_file.volume, 16, 1e-9);
}

TEST(TakeHull, GroupsOfAnObjAreFacesOfOneBody) {
    std::vector<Triangle3> bow;
    std::vector<Triangle3> rest;
    for (const Triangle3& one : box({-50, -10, -6}, {50, 10, 4})) {
        const bool ahead = std::ranges::all_of(one, [](const Vec3& corner) { return corner.x() == 50; });
        (ahead ? bow : rest).push_back(one);
    }
    Structure structure;
    take_hull(structure, obj_text({{"bow", bow}, {"sides", rest}}), "ship.obj");
    structure.shape.set_kind(HullKind::file);
    ASSERT_FALSE(structure.shape.fault()) << *structure.shape.fault();
    const std::vector<std::string> parts = structure.shape.parts();
    const std::vector<ConvexSolid> solids = structure.shape.solids();
    ASSERT_EQ(solids.size(), 1U);
    EXPECT_EQ(parts.at(static_cast<std::size_t>(solids[0].part_at({50, 0, 1}))), "bow");
    EXPECT_EQ(parts.at(static_cast<std::size_t>(solids[0].part_at({0, 0, 10}))), "sides");
}

TEST(TakeHull, TurnsABodyThatIsInsideOut) {
    std::vector<Triangle3> inside_out = box({-1, -1, -1}, {1, 1, 1});
    for (Triangle3& one : inside_out) std::swap(one[1], one[2]);
    Structure structure;
    take_hull(structure, stl_bytes(inside_out), "x.stl");
    EXPECT_NEAR(structure.hull_file.volume, 8, 1e-9);
}

// As programs print them: each triangle's corners round by themselves, so that no two meet.
TEST(TakeHull, SewsCornersThatDifferInTheLastDigit) {
    for (const double share : {5e-7, 5e-6, 5e-5}) {
        std::vector<Triangle3> torn = prism(l_shape, l_cut, 10);
        const double size = std::hypot(30, std::hypot(30, 10));
        double sign = 1;
        for (Triangle3& triangle : torn)
            for (auto& corner : triangle) {
                for (int k = 0; k < 3; ++k) corner[static_cast<std::size_t>(k)] += 0.3 * share * size * (sign = -sign);
                sign = -sign;
            }
        Structure structure;
        structure.hull_file.waterline = 5;
        take_hull(structure, stl_text({{"one", torn}}), "torn.stl");
        EXPECT_NEAR(structure.hull_file.volume / 5000, 1, 10 * share);
        structure.shape.set_kind(HullKind::file);
        double volume = 0;
        for (const ConvexSolid& solid : structure.shape.solids()) volume += solid.volume();
        EXPECT_NEAR(volume / 5000, 1, 20 * share);
    }
}

TEST(TakeHull, SaysWhatIsWrongWithAFile) {
    std::vector<Triangle3> closed = box({-1, -1, -1}, {1, 1, 1});
    std::vector<Triangle3> open(closed.begin() + 1, closed.end());
    EXPECT_NE(refusal_of(stl_bytes(open), "x.stl").find("x.stl: the surface is open: 3 edges"), std::string::npos);
    std::vector<Triangle3> twisted = closed;
    std::swap(twisted[0][1], twisted[0][2]);
    EXPECT_NE(refusal_of(stl_bytes(twisted), "x.stl").find("same direction"), std::string::npos);
    EXPECT_NE(refusal_of("nonsense", "x.stl").find("x.stl: this is no readable .stl file"), std::string::npos);
    EXPECT_NE(refusal_of("", "x.obj").find("x.obj: the file has no triangles"), std::string::npos);
    EXPECT_NE(refusal_of("x", "x.step").find("export one of these"), std::string::npos);
    EXPECT_NE(refusal_of(stl_bytes(box({-1, -1, 1}, {1, 1, 2})), "x.stl").find("does not stand in the water"),
              std::string::npos);
    EXPECT_NE(refusal_of(stl_bytes(closed), "x.stl", {.path = "", .up = HullAxis::plus_x, .forward = HullAxis::minus_x})
                  .find("right angles"),
              std::string::npos);
    EXPECT_EQ(refusal_of(stl_bytes(closed), "x.stl"), "");
}

}  // namespace hull_file_test
}  // namespace floes
