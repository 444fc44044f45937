// What impulses do to a piece: two bodies by closed form, and the same bits however its columns are asked for.

#include "solver/piece_compliance.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <deque>
#include <numeric>
#include <utility>
#include <vector>

namespace floes {
namespace piece_compliance_test {

constexpr double mass = 3;
constexpr double hold = 5;

/// A row of bodies 1 m apart along x, held alike in every direction; the first is fixed if asked.
PieceCompliance row_of(std::size_t count, bool fixed = false) {
    std::vector<PieceBody> bodies(count, {.mass = mass, .inertia = Vec3(0.3, 0.5, 0.4).asDiagonal()});
    if (fixed) bodies.front() = {};
    std::vector<PieceJoint> joints;
    for (int i = 1; i < static_cast<int>(count); ++i)
        joints.push_back({.a = i - 1,
                          .b = i,
                          .lever_a = {0.5, 0, 0},
                          .lever_b = {-0.5, 0, 0},
                          .hold = {hold, 1.1 * hold, 1.2 * hold, 0.1 * hold, 0.2 * hold, 0.3 * hold}});
    return {std::move(bodies), std::move(joints)};
}

std::vector<std::uint32_t> all_of(std::size_t count) {
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0U);
    return all;
}

/// Along x, of body `of` by an impulse along x on body `source`.
double along_x(PieceCompliance& piece, std::size_t of, std::size_t source) {
    piece.make_columns(all_of(piece.bodies()));
    return piece.column(source)[piece.number(of) * compliance_block];
}

std::vector<PieceBody> bodies_of_square(int side) {
    return {static_cast<std::size_t>(side * side), {.mass = mass, .inertia = Vec3(0.3, 0.5, 0.4).asDiagonal()}};
}

/// Of a square of bodies 1 m apart, held alike.
std::vector<PieceJoint> joints_of_square(int side) {
    std::vector<PieceJoint> joints;
    for (int i = 0; i < side * side; ++i) {
        PieceJoint joint{.a = i, .hold = {hold, 1.1 * hold, 1.2 * hold, 0.1 * hold, 0.2 * hold, 0.3 * hold}};
        for (const auto& [step, ahead] : {std::pair(1, Vec3(0.5, 0, 0)), std::pair(side, Vec3(0, 0, 0.5))}) {
            if (step == 1 ? i % side == side - 1 : i + side >= side * side) continue;
            joint.b = i + step;
            joint.lever_a = ahead;
            joint.lever_b = -ahead;
            joints.push_back(joint);
        }
    }
    return joints;
}

PieceCompliance square_of(int side) {
    return {bodies_of_square(side), joints_of_square(side)};
}

/// Every block that the piece knows between these bodies is what it does by velocity_changes(), to the bit.
void expect_blocks(PieceCompliance& piece, const std::vector<std::uint32_t>& bodies) {
    for (const std::uint32_t source : bodies) {
        for (std::size_t k = 0; k < 6; ++k) {
            std::vector<double> impulse(8 * piece.bodies(), 0.0);
            std::vector<double> change(8 * piece.bodies(), 0.0);
            impulse[8 * source + 4 * (k / 3) + k % 3] = 1;
            piece.velocity_changes(impulse.data(), all_of(piece.bodies()), change.data());
            std::vector<double> of_these(8 * piece.bodies(), 0.0);
            piece.velocity_changes(impulse.data(), bodies, of_these.data());
            for (const std::uint32_t of : bodies)
                for (std::size_t i = 8 * of; i < 8 * of + 8; ++i) EXPECT_EQ(of_these[i], change[i]) << of;
            for (const std::uint32_t of : bodies) {
                const double* const block = piece.column(source) + piece.number(of) * compliance_block + 8 * (k % 3);
                for (std::size_t i = 0; i < 3; ++i)
                    EXPECT_EQ(block[4 * (k / 3) + i], change[8 * of + 4 * (k / 3) + i]) << source << " " << of;
            }
        }
    }
}

// (m + h) v₁ - h v₂ = 1, (m + h) v₂ - h v₁ = 0.
TEST(PieceCompliance, OfTwoBodiesIsTheirClosedForm) {
    PieceCompliance pair = row_of(2);
    const double all = mass * (mass + 2 * hold);
    EXPECT_NEAR(along_x(pair, 0, 0), (mass + hold) / all, 1e-15);
    EXPECT_NEAR(along_x(pair, 1, 0), hold / all, 1e-15);
}

TEST(PieceCompliance, OfABodyHeldByAFixedOneIsThatOfASpring) {
    PieceCompliance pair = row_of(2, true);
    EXPECT_NEAR(along_x(pair, 1, 1), 1 / (mass + hold), 1e-15);
    EXPECT_EQ(along_x(pair, 0, 1), 0);
    EXPECT_EQ(along_x(pair, 1, 0), 0) << "a fixed body feels no impulse";
}

TEST(PieceCompliance, OfASmallPieceIsKnownWhole) {
    PieceCompliance piece = row_of(11);
    piece.make_columns(std::vector<std::uint32_t>{7});
    for (const std::uint32_t body : all_of(11)) EXPECT_EQ(piece.number(body), body);
    expect_blocks(piece, all_of(11));
}

// As contacts come to a sheet: bodies far from each other, neighbours of them, some twice, four and more at a time.
TEST(PieceCompliance, OfALargePieceHasTheSameBitsInWhateverOrderItsBodiesAreTouched) {
    PieceCompliance piece = square_of(12);
    std::vector<std::uint32_t> touched;
    for (const std::vector<std::uint32_t>& more :
         {std::vector<std::uint32_t>{143}, {0, 143, 70}, {}, {1, 2, 3, 4, 5, 71, 130, 142, 0}, {12}}) {
        piece.make_columns(more);
        touched.insert(touched.end(), more.begin(), more.end());
        expect_blocks(piece, touched);
    }
    piece.make_columns(all_of(144));
    expect_blocks(piece, all_of(144));
}

// A joint that cracks bends more easily; then it holds less in the plane, too, and last it is gone.
TEST(PieceCompliance, OfALargePieceHasTheSameBitsWhateverItWasBefore) {
    std::vector<PieceJoint> joints = joints_of_square(9);
    std::deque<PieceCompliance> before;
    before.emplace_back(bodies_of_square(9), joints);
    const auto expect_same = [&] {
        PieceCompliance& made = before.emplace_back(bodies_of_square(9), joints, &before.back());
        PieceCompliance alone(bodies_of_square(9), joints);
        std::vector<double> impulses(8 * 81);
        for (std::size_t i = 0; i < impulses.size(); ++i)
            impulses[i] = i % 4 == 3 ? 0 : 1.0 / static_cast<double>(i + 1);
        std::vector<double> by_before(8 * 81);
        std::vector<double> by_none(8 * 81);
        made.velocity_changes(impulses.data(), all_of(81), by_before.data());
        alone.velocity_changes(impulses.data(), all_of(81), by_none.data());
        EXPECT_EQ(by_before, by_none);
        return by_none;
    };
    const std::vector<double> sound = expect_same();
    joints[70].hold[3] *= 0.5;
    joints[70].hold[5] *= 0.5;
    const std::vector<double> cracked = expect_same();
    EXPECT_NE(cracked, sound);
    joints[30].hold[0] *= 0.5;
    EXPECT_NE(expect_same(), cracked);
    joints.erase(joints.begin() + 70);
    expect_same();
}

}  // namespace piece_compliance_test
}  // namespace floes
