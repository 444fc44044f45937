// What emulators do not depend on, what they bear and what they refuse.

#include <gtest/gtest.h>

#include <ctime>
#include <limits>

#include "core/error.hpp"
#include "toy_simulator.hpp"

namespace floes {
namespace emulator_data_test {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

TEST(Emulator, DoesNotDependOnUnits) {
    const toy::Toy toy = toy::drawn(30, Vector{{1, 1}}, 0.05);
    const Emulator first(toy.data);
    const Emulator second({toy.data.at, toy.data.values.array() * 1000 - 7e5, toy.data.noise * 1e6});
    for (Eigen::Index i = 0; i < 20; ++i) {
        const Emulated a = first.at(toy.further.row(i));
        const Emulated b = second.at(toy.further.row(i));
        EXPECT_NEAR(a.mean, (b.mean + 7e5) / 1000, 1e-6);
        EXPECT_NEAR(a.variance, b.variance / 1e6, 1e-6);
    }
}

TEST(Emulator, DoesNotDependOnTheOrderOfPoints) {
    const toy::Toy toy = toy::drawn(30, Vector{{1, 1}}, 0.05);
    const Emulator first(toy.data);
    const Emulator second({toy.data.at.colwise().reverse(), toy.data.values.reverse(), toy.data.noise.reverse()});
    for (std::size_t i = 0; i < 30; ++i) {
        EXPECT_EQ(first.left_out()[i].predicted, second.left_out()[29 - i].predicted);
        EXPECT_EQ(first.left_out()[i].sd, second.left_out()[29 - i].sd);
    }
    EXPECT_EQ(first.at(Vector{{0.1, 0.2}}).variance, second.at(Vector{{0.1, 0.2}}).variance);
}

// Two runs of one point that disagree, and an axis along which nothing was moved.
TEST(Emulator, BearsPointsThatSayLittle) {
    toy::Toy toy = toy::drawn(30, Vector{{1, 1}}, 0);
    toy.data.noise.setZero();
    toy.data.at.row(1) = toy.data.at.row(0);
    toy.data.values(1) = toy.data.values(0) + 1;
    const Emulator repeated(toy.data);
    EXPECT_NEAR(repeated.at(toy.data.at.row(0)).mean, toy.data.values(0) + 0.5, 0.5);
    EXPECT_TRUE(std::isfinite(repeated.left_out()[0].standardised()));
    toy.data.at.col(1).setConstant(0.5);
    const Emulated still = Emulator(toy.data).at(Vector{{0, 0.5}});
    EXPECT_TRUE(std::isfinite(still.mean) && still.variance > 0);
}

TEST(Emulator, RefusesWhatIsNoData) {
    const Vector two{{-1, 1}};
    EXPECT_THROW(Emulator({Matrix{{1.0}}, Vector{{1}}, Vector{{1}}}), InputError);
    EXPECT_THROW(Emulator({Matrix(2, 0), two, two.cwiseAbs()}), InputError);
    EXPECT_THROW(Emulator(toy::on_line(two, Vector{{1, 2, 3}}, two.cwiseAbs())), InputError);
    EXPECT_THROW(Emulator(toy::on_line(two, two, Vector{{1}})), InputError);
    EXPECT_THROW(Emulator(toy::on_line(two, two, Vector{{1, -1e-9}})), InputError);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(Emulator(toy::on_line(Vector{{nan, 1}}, two, two.cwiseAbs())), InputError);
    EXPECT_THROW(Emulator(toy::on_line(two, Vector{{nan, 1}}, two.cwiseAbs())), InputError);
    EXPECT_THROW(Emulator(toy::on_line(two, two, Vector{{nan, 1}})), InputError);
    EXPECT_THROW(Emulator(toy::on_line(two, two, two.cwiseAbs())).at(two), InputError);
}

TEST(Emulator, OfSevenAxesAndSixtyPointsIsQuick) {
    const toy::Toy toy = toy::drawn(60, Vector::Constant(7, 2), 0.1);
    const std::clock_t before = std::clock();
    const Emulator emulator(toy.data);
    EXPECT_LT(std::clock() - before, 2 * CLOCKS_PER_SEC);
    EXPECT_EQ(emulator.covariances().size(), 9);
}

}  // namespace emulator_data_test
}  // namespace floes
