// What impulses do to a piece: two bodies by closed form, and the same bits however many columns are made at a time.

#include "solver/piece_compliance.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
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

/// Along x, of body `of` by an impulse along x on body `source`.
double along_x(PieceCompliance& piece, std::size_t of, std::size_t source) {
    return piece.column(source)[of * compliance_block];
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

TEST(PieceCompliance, HasTheSameBitsHoweverManyColumnsAreMadeAtATime) {
    constexpr std::size_t count = 11;
    PieceCompliance one_by_one = row_of(count);
    PieceCompliance together = row_of(count);
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0U);
    together.make_columns(all);
    for (std::size_t source = 0; source < count; ++source) {
        const double* const column = together.column(source);
        for (std::size_t k = 0; k < count * compliance_block; ++k)
            EXPECT_EQ(one_by_one.column(source)[k], column[k]) << source << " " << k;
        for (std::size_t k = 0; k < 3; ++k) {
            for (const std::size_t part : {0U, 1U}) {
                std::vector<double> impulse(8 * count, 0.0);
                std::vector<double> change(8 * count, 0.0);
                impulse[8 * source + 4 * part + k] = 1;
                together.velocity_changes(impulse.data(), change.data());
                for (std::size_t i = 0; i < 3 * count; ++i)
                    EXPECT_EQ(change[i / 3 * 8 + 4 * part + i % 3],
                              column[i / 3 * compliance_block + 8 * k + 4 * part + i % 3]);
            }
        }
    }
}

}  // namespace piece_compliance_test
}  // namespace floes
