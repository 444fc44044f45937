// History matching on a toy simulator whose truth is known: what is left holds it, and no more than it should.

#include "match/matching.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace matching_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Function = double (*)(double, double);

double load(double x, double y) {
    return 30 + 8 * x + 4 * y + 3 * x * x;
}

double breakage(double x, double y) {
    return 12 - 5 * x + 6 * y + 2 * x * y;
}

/// A tank with scatter: the simulator at points of [-1, 1]², and measurements of it.
class Tank {
  public:
    explicit Tank(unsigned seed) : random_(seed) {
        data_.axes = {{"structure.keel_radius_m", 0.4, 0.5}, {"contact.ice_ice_friction", 0.1, 0.5}};
        for (int k = 0; k < points; ++k)
            data_.points.push_back({{2.0 * halton(k, 2) - 1, 2.0 * halton(k, 3) - 1}, 0, k});
    }

    /// Data of one quantity, and its measured value.
    void add(Function truth, const char* key, double measured, int runs = 1) {
        TargetData target;
        target.target.quantity = *any_quantity(key);
        target.target.value = measured;
        target.target.runs = runs;
        for (int k = 0; k < points; ++k) {
            const std::vector<double>& at = data_.points[static_cast<std::size_t>(k)].coordinates;
            double sum = 0;
            double squares = 0;
            for (int run = 0; run < arrangements; ++run) {
                const double value = truth(at[0], at[1]) + scatter * normal_(random_);
                sum += value;
                squares += value * value;
            }
            target.point.push_back(k);
            target.mean.push_back(sum / arrangements);
            target.sample_variance.push_back((squares - sum * sum / arrangements) / (arrangements - 1));
            target.variance.push_back(scatter * scatter);
            target.runs.push_back(arrangements);
        }
        data_.targets.push_back(std::move(target));
    }
    double measured(Function truth, double x, double y) { return truth(x, y) + scatter * normal_(random_); }
    double uniform() { return std::uniform_real_distribution(-0.9, 0.9)(random_); }
    const MatchData& data() const { return data_; }

    static constexpr int points = 20;
    static constexpr int arrangements = 4;
    static constexpr double scatter = 1.5;

  private:
    static double halton(int k, int base) {
        double value = 0;
        double part = 1;
        for (int left = k + 1; left > 0; left /= base) value += (part /= base) * (left % base);
        return value;
    }

    std::mt19937 random_;
    std::normal_distribution<double> normal_;
    MatchData data_;
};

/// Share of the space that the truth itself, known without an emulator, does not rule out.
double exact_share(double first, double second) {
    constexpr int cells = 64;
    int left = 0;
    for (int i = 0; i < cells * cells; ++i) {
        const double x = (2.0 * (i % cells) + 1) / cells - 1;
        const double y = (2.0 * (i / cells) + 1) / cells - 1;
        left +=
            std::abs(load(x, y) - first) <= 3 * Tank::scatter && std::abs(breakage(x, y) - second) <= 3 * Tank::scatter;
    }
    return static_cast<double>(left) / (cells * cells);
}

// With one measured run of two quantities, the truth is ruled out with the probability that one of two deviations is
// above three standard ones, 0.5 %. What is left is what the truth leaves and half as much again at most: emulators are
// not sure, least of all of the scatter.
TEST(Matching, HoldsTheTruthAndLittleElse) {
    int held = 0;
    double share = 0;
    double exact = 0;
    constexpr int repetitions = 100;
    for (unsigned k = 0; k < repetitions; ++k) {
        Tank tank(k);
        const double x = tank.uniform();
        const double y = tank.uniform();
        const double first = tank.measured(load, x, y);
        const double second = tank.measured(breakage, x, y);
        tank.add(load, "mean_load", first);
        tank.add(breakage, "mean_maximum", second);
        const std::vector<EmulatedTarget> targets = emulate(tank.data());
        held += targets[0].implausibility(Eigen::Vector2d(x, y)) <= 3 &&
                targets[1].implausibility(Eigen::Vector2d(x, y)) <= 3;
        share += match(tank.data(), targets, 256, k).share() / repetitions;
        exact += exact_share(first, second) / repetitions;
    }
    EXPECT_GE(held, 98);
    EXPECT_GT(share, 0.97 * exact);
    EXPECT_LT(share, 1.5 * exact);
}

TEST(Matching, LeavesLessTheMoreIsMeasured) {
    std::vector<double> shares;
    for (const int runs : {1, 4, 100}) {
        Tank tank(1);
        tank.add(load, "mean_load", load(0.3, -0.2), runs);
        tank.add(breakage, "mean_maximum", breakage(0.3, -0.2), runs);
        const Matching found = match(tank.data(), emulate(tank.data()), 1024, 1);
        EXPECT_GT(found.left, 0);
        shares.push_back(found.share());
    }
    EXPECT_LT(shares[1], 0.7 * shares[0]);
    EXPECT_LT(shares[2], 0.7 * shares[1]);
}

TEST(Matching, FindsTheInputsAgainFromManyRuns) {
    Tank tank(2);
    tank.add(load, "mean_load", load(0.3, -0.2), 100);
    tank.add(breakage, "mean_maximum", breakage(0.3, -0.2), 100);
    const Matching found = match(tank.data(), emulate(tank.data()), 4096, 1);
    ASSERT_EQ(found.axes.size(), 2u);
    EXPECT_LT(found.axes[0].low, 0.465);  // 0.3 is 0.465 m
    EXPECT_GT(found.axes[0].high, 0.465);
    EXPECT_LT(found.axes[0].high - found.axes[0].low, 0.06);
    EXPECT_LT(found.axes[1].low, 0.26);  // -0.2 is 0.26
    EXPECT_GT(found.axes[1].high, 0.26);
    EXPECT_NEAR(found.best[0], 0.3, 0.2);
    EXPECT_NEAR(found.best[1], -0.2, 0.2);
    EXPECT_EQ(found.points_left.rows(), found.left);
}

TEST(Matching, NamesTargetsThatContradictEachOther) {
    Tank tank(3);
    tank.add(load, "mean_load", load(0.8, 0.8), 10);
    tank.add(load, "sd_load", load(-0.8, -0.8), 10);
    tank.add(breakage, "mean_maximum", breakage(0, 0), 1);
    const std::vector<EmulatedTarget> targets = emulate(tank.data());
    const Matching found = match(tank.data(), targets, 1024, 1);
    EXPECT_EQ(found.left, 0);
    EXPECT_THAT(found.conflicts, ElementsAre(std::pair(0, 1)));
    EXPECT_THAT(found.axes, IsEmpty());
    EXPECT_GT(found.best_implausibility, 3);
    EXPECT_EQ(next_points(found, tank.data(), 5).rows(), 0);
    EXPECT_THAT(match_sections(tank.data(), targets, found).front().before,
                HasSubstr("No combination meets both mean_load and sd_load."));
}

TEST(Matching, UsesNoTargetThatIsHeldOut) {
    Tank tank(4);
    tank.add(load, "mean_load", load(0.3, -0.2), 10);
    const double alone = match(tank.data(), emulate(tank.data()), 512, 1).share();
    tank.add(breakage, "mean_maximum", -1000);
    MatchData data = tank.data();
    data.targets[1].target.held_out = true;
    const std::vector<EmulatedTarget> targets = emulate(data);
    EXPECT_EQ(targets[1].unused(), "held out");
    const Matching found = match(data, targets, 512, 1);
    EXPECT_EQ(found.share(), alone);
    EXPECT_EQ(found.verdicts[1].rules_out, 0);
    EXPECT_GT(found.verdicts[1].least, 3);
    EXPECT_NEAR(found.verdicts[0].rules_out, 1 - alone, 1e-12);
    EXPECT_NEAR(found.verdicts[0].alone, 1 - alone, 1e-12);
}

// An error that all points share moves them together, which no emulator can see.
TEST(Matching, CountsTheErrorThatPointsHaveInCommon) {
    Tank tank(5);
    tank.add(load, "mean_load", load(0, 0), 100);
    const double apart = match(tank.data(), emulate(tank.data()), 1024, 1).share();
    MatchData data = tank.data();
    data.targets[0].shared = 0.9;
    EXPECT_GT(match(data, emulate(data), 1024, 1).share(), 1.2 * apart);
}

/// Forty points of a load that scatters with a standard deviation of 2 + 1.5 x, with two runs each.
EmulatedTarget uneven(unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    MatchData data;
    data.axes = {{"structure.keel_radius_m", 0.4, 0.5}};
    TargetData target;
    target.target.quantity = *any_quantity("mean_load");
    constexpr int points = 40;
    for (int k = 0; k < points; ++k) {
        const double x = 2.0 * k / (points - 1) - 1;
        data.points.push_back({{x}, 0, k});
        const double one = 30 + 10 * x + (2 + 1.5 * x) * normal(random);
        const double other = 30 + 10 * x + (2 + 1.5 * x) * normal(random);
        target.point.push_back(k);
        target.mean.push_back((one + other) / 2);
        target.sample_variance.push_back((one - other) * (one - other) / 2);
        target.variance.push_back(4);
        target.runs.push_back(2);
    }
    return EmulatedTarget(data, target);
}

// Two runs a point are enough to know that high loads scatter more, and low ones are not taken for as uncertain.
TEST(Matching, KnowsThatTheScatterDependsOnTheInputs) {
    const auto at = [](double x) { return Eigen::VectorXd::Constant(1, x); };
    constexpr unsigned repetitions = 10;
    for (const double x : {-0.8, 0.0, 0.8}) {
        double off = 0;
        for (unsigned seed = 1; seed <= repetitions; ++seed)
            off += std::log(std::sqrt(uneven(seed).scatter(at(x))) / (2 + 1.5 * x)) / repetitions;
        EXPECT_GT(std::exp(off), 1.0) << x << ": the expectation of the variance is above the likeliest one";
        EXPECT_LT(std::exp(off), 1.8) << x << ": pooled over all points it would be 2.7 at -0.8";
    }
    EXPECT_LT(uneven(1).mean().at(at(-0.7)).variance, 0.4 * uneven(1).mean().at(at(0.7)).variance);
}

/// A load of 30 N that scatters by 2 N, at six points of one axis with so many runs each.
MatchData six_points(int runs) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    MatchData data;
    data.axes = {{"structure.keel_radius_m", 0.4, 0.5}};
    TargetData target;
    target.target.quantity = *any_quantity("mean_load");
    target.target.value = 70;
    for (int k = 0; k < 6; ++k) {
        data.points.push_back({{2.0 * k / 5 - 1}, 0, k});
        double sum = 0;
        double squares = 0;
        for (int run = 0; run < runs; ++run) {
            const double off = 2 * normal(random);
            sum += off;
            squares += off * off;
        }
        target.point.push_back(k);
        target.mean.push_back(30 + sum / runs);
        target.sample_variance.push_back((squares - sum * sum / runs) / (runs - 1));
        target.variance.push_back(4);
        target.runs.push_back(runs);
    }
    data.targets = {target};
    return data;
}

// What is printed adds up, and with few runs the output says that the bound is not three.
TEST(Matching, SaysWhichMultipleOfTheExpectedDifferenceRulesOut) {
    const Eigen::VectorXd at = Eigen::VectorXd::Constant(1, 0.2);
    for (const int runs : {2, 200}) {
        const MatchData data = six_points(runs);
        const std::vector<EmulatedTarget> targets = emulate(data);
        const Comparison here = targets[0].compared(at);
        EXPECT_DOUBLE_EQ(here.ratio, (70 - here.predicted) / here.expected);
        EXPECT_DOUBLE_EQ(targets[0].implausibility(at), 3 * here.ratio / here.bound);
        EXPECT_EQ(targets[0].rules_out(at), here.ratio > here.bound);
        const Section point = point_section(data, targets, at);
        const std::string said =
            fmt::format("mean_load: ruled out only beyond {:.1f} times the expected difference, not 3", here.bound);
        if (runs == 2) {
            EXPECT_GT(here.bound, 4);
            EXPECT_THAT(point.notes, ElementsAre(HasSubstr(said)));
        } else {
            EXPECT_NEAR(here.bound, 3, 0.1);
            EXPECT_THAT(point.notes, IsEmpty());
        }
        const Section all = match_sections(data, targets, match(data, targets, 64, 1)).front();
        EXPECT_EQ(all.notes.size(), point.notes.size() + 1) << "and that six points make no Gaussian process";
    }
}

// What is predicted by less than was asked for is said beside the figures, with what would do.
TEST(Matching, SaysWhereAnEmulatorIsSimpler) {
    Tank tank(3);
    tank.add(load, "mean_load", 40);
    MatchData data = tank.data();
    const auto notes_at = [&](std::size_t points) {
        TargetData& target = data.targets.front();
        for (auto* all : {&target.mean, &target.sample_variance, &target.variance}) all->resize(points);
        target.point.resize(points);
        target.runs.resize(points);
        const std::vector<EmulatedTarget> targets = emulate(data);
        EXPECT_EQ(targets.front().simplifications().empty(), points >= 12);
        return text(match_sections(data, targets, match(data, targets, 64, 1)), 400);
    };
    EXPECT_THAT(notes_at(12), testing::Not(HasSubstr("Gaussian process, which follows them")));
    EXPECT_THAT(notes_at(8), HasSubstr("because it has 8 points; 12 or more make it a Gaussian process"));
    EXPECT_THAT(notes_at(5),
                HasSubstr("mean_load: its emulator is a constant, the same at all inputs, because it has 5"));
    data.targets.front().runs.assign(5, 1);
    const EmulatedTarget single(data, data.targets.front());
    EXPECT_THAT(single.simplifications().back(),
                HasSubstr("the scatter of single runs is taken as the same at all inputs: fewer than two points"));
}

// The correlation of one input with itself is no finding.
TEST(Matching, OfOneInputHasNoCorrelations) {
    const MatchData data = six_points(4);
    const std::vector<EmulatedTarget> targets = emulate(data);
    const Matching found = match(data, targets, 64, 1);
    EXPECT_EQ(match_sections(data, targets, found).size(), 2u);
    const Figure along = along_figure(data, found);
    EXPECT_EQ(along.x.label, "structure.keel_radius_m");
    EXPECT_EQ(along.x.high, 0.5);
}

// From many runs of two quantities a third one is known, one that was not measured; from one run it is less so.
TEST(Predicted, HoldsTheTruthOfAQuantityThatWasNotMeasured) {
    std::vector<double> widths;
    for (const int runs : {1, 100}) {
        Tank tank(7);
        tank.add(load, "mean_load", load(0.3, -0.2), runs);
        tank.add(breakage, "mean_maximum", breakage(0.3, -0.2), runs);
        const std::vector<EmulatedTarget> targets = emulate(tank.data());
        const Matching found = match(tank.data(), targets, 2048, 1);
        Tank same(7);
        same.add([](double x, double y) { return 50 + 10 * x - 10 * y; }, "sd_load", NAN);
        const Predicted third = predict(OverLeft(found, targets), emulate(same.data()).front());
        for (const Estimate& range : {third.mean, third.weighted, third.run}) {
            EXPECT_LT(range.low, 55);
            EXPECT_GT(range.high, 55);
            EXPECT_NEAR(range.value, 55, runs == 1 ? 5 : 1.5);
        }
        EXPECT_LE(third.weighted.high - third.weighted.low, third.mean.high - third.mean.low);
        EXPECT_GT(third.run.high - third.run.low, third.weighted.high - third.weighted.low);
        EXPECT_GT(third.effective, 5);
        EXPECT_LT(third.effective, found.left);
        widths.push_back(third.weighted.high - third.weighted.low);
    }
    EXPECT_LT(widths[1], 0.5 * widths[0]);
    EXPECT_GT(widths[1], 0.1);
}

TEST(Predicted, NeedsSomethingLeftAndAKnownQuantity) {
    Tank tank(8);
    tank.add(load, "mean_load", 1000);
    const std::vector<EmulatedTarget> targets = emulate(tank.data());
    const Matching found = match(tank.data(), targets, 128, 1);
    EXPECT_THAT(refusal([&] { OverLeft(found, targets); }), HasSubstr("nothing is left"));
    EXPECT_THAT(refusal([] { to_predict("largest_load", ""); }), HasSubstr("is no quantity of a member"));
    EXPECT_TRUE(to_predict("mean_maximum_1s", "E60").held_out);
}

TEST(NextPoints, AreLeftAndSpreadOut) {
    Tank tank(6);
    tank.add(load, "mean_load", load(0.3, -0.2), 10);
    const Matching found = match(tank.data(), emulate(tank.data()), 2048, 1);
    const Eigen::MatrixXd points = next_points(found, tank.data(), 12);
    ASSERT_EQ(points.rows(), 12);
    const EmulatedTarget target(tank.data(), tank.data().targets[0]);
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        EXPECT_LE(target.implausibility(points.row(k).transpose()), 3);
        for (Eigen::Index other = 0; other < k; ++other) EXPECT_GT((points.row(k) - points.row(other)).norm(), 0.1);
    }
    EXPECT_EQ(points, next_points(match(tank.data(), emulate(tank.data()), 2048, 1), tank.data(), 12));
}

/// Of axes of whole numbers as many as there are, none twice.
TEST(NextPoints, DifferAsTheirAxesTakeThem) {
    Tank tank(6);
    tank.add(load, "mean_load", load(0.3, -0.2), 10);
    MatchData data = tank.data();
    data.axes = {{"field.floes", 20, 25, AxisScale::linear, true},
                 {"general.iterations", 1, 4, AxisScale::linear, true}};
    const Matching found = match(data, emulate(data), 2048, 1);
    const Eigen::MatrixXd points = next_points(found, data, 40);
    ASSERT_GE(points.rows(), 2);
    EXPECT_LE(points.rows(), 24);
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        const double floes = data.axes[0].value(points(k, 0));
        EXPECT_NEAR(floes, std::round(floes), 1e-9);
        for (Eigen::Index other = 0; other < k; ++other) EXPECT_NE(points.row(k), points.row(other));
    }
}

}  // namespace matching_test
}  // namespace floes
