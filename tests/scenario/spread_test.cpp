// Ice that differs from floe to floe: moments, correlation, streams of its own.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "scenario/floes.hpp"
#include "scenario/validate.hpp"

namespace floes {
namespace spread_test {

constexpr int many = 20'000;

Scenario with(const std::function<void(IceSpread&)>& change) {
    Scenario scenario;
    scenario.field.floes = many;
    change(scenario.spread);
    return scenario;
}

using Of = double (*)(const FloeShape&, const Material&);
constexpr Of thickness = [](const FloeShape& shape, const Material&) { return shape.thickness; };
constexpr Of strength = [](const FloeShape&, const Material& of) { return of.ice.bending_strength; };
constexpr Of modulus = [](const FloeShape&, const Material& of) { return of.ice.elastic_modulus; };

std::vector<double> values(const Scenario& scenario, Of of, std::uint32_t number = 0) {
    const FloeSet floes = floes_of(scenario, {1, number});
    std::vector<double> found;
    for (std::size_t i = 0; i < floes.size(); ++i) found.push_back(of(floes.shape(i), floes.material(i)));
    return found;
}

double mean(const std::vector<double>& of) {
    return std::accumulate(of.begin(), of.end(), 0.0) / static_cast<double>(of.size());
}

std::vector<double> ranks(const std::vector<double>& of) {
    std::vector<std::size_t> order(of.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return of[i]; });
    std::vector<double> found(of.size());
    for (std::size_t k = 0; k < order.size(); ++k) found[order[k]] = static_cast<double>(k);
    return found;
}

double rank_correlation(const std::vector<double>& x, const std::vector<double>& y) {
    const std::vector<double> a = ranks(x);
    const std::vector<double> b = ranks(y);
    // Means of ranks are known, so that this takes no mean for each floe.
    const double middle = 0.5 * static_cast<double>(a.size() - 1);
    double both = 0;
    double own = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both += (a[i] - middle) * (b[i] - middle);
        own += (a[i] - middle) * (a[i] - middle);
    }
    return both / own;
}

TEST(Spread, DrawsHaveTheMomentsOfTheirLaw) {
    for (const LawKind kind : {LawKind::normal, LawKind::lognormal, LawKind::weibull, LawKind::uniform}) {
        const Scenario scenario = with([&](IceSpread& spread) { spread.thickness = {kind, 0.2, {0.01, 20}}; });
        const std::vector<double> drawn = values(scenario, thickness);
        const double nominal = scenario.floe.thickness;
        const double average = mean(drawn);
        double squares = 0;
        for (const double one : drawn) squares += (one - average) * (one - average) / many;
        // Standard errors of the mean and, with a kurtosis of at most 4, of the deviation; four of each.
        EXPECT_NEAR(average / nominal, 1, 4 * 0.2 / std::sqrt(many));
        EXPECT_NEAR(std::sqrt(squares) / nominal, 0.2, 4 * 0.2 * std::sqrt(3.0 / 4 / many));
    }
}

TEST(Spread, ThicknessAndStrengthCorrelateAsStated) {
    for (const double correlation : {-0.5, 0.0, 0.7}) {
        const Scenario scenario = with([&](IceSpread& spread) {
            spread.thickness = {LawKind::normal, 0.2};
            spread.strength = {LawKind::weibull, 0.3};
            spread.correlation = correlation;
        });
        EXPECT_NEAR(rank_correlation(values(scenario, thickness), values(scenario, strength)),
                    6 / std::numbers::pi * std::asin(correlation / 2), 4 / std::sqrt(many));
    }
}

TEST(Spread, AddingADrawChangesNoOther) {
    const Scenario one = with([](IceSpread& spread) { spread.strength = {LawKind::normal, 0.2}; });
    Scenario more = one;
    more.spread.thickness = {LawKind::lognormal, 0.2};
    more.spread.density = {LawKind::normal, 0.01, {0.95, 1.05}};
    more.spread.elastic_modulus = {LawKind::uniform, 0.3};
    EXPECT_EQ(values(one, strength), values(more, strength));
    EXPECT_NE(values(one, thickness), values(more, thickness));
    EXPECT_NEAR(rank_correlation(values(more, modulus), values(more, strength)), 0, 4 / std::sqrt(many));
    Scenario correlated = more;
    correlated.spread.correlation = 0.5;
    EXPECT_EQ(values(correlated, thickness), values(more, thickness));
    EXPECT_EQ(values(correlated, modulus), values(more, modulus));
    EXPECT_NE(values(correlated, strength), values(more, strength));
}

TEST(Spread, DiffersByArrangementAndByDraw) {
    const Scenario first = with([](IceSpread& spread) { spread.thickness = {LawKind::normal, 0.2}; });
    Scenario second = first;
    second.spread.draw = 1;
    EXPECT_EQ(values(first, thickness), values(first, thickness));
    EXPECT_NE(values(first, thickness, 0), values(first, thickness, 1));
    EXPECT_NE(values(first, thickness), values(second, thickness));
    EXPECT_NEAR(rank_correlation(values(first, thickness), values(second, thickness)), 0, 4 / std::sqrt(many));
    EXPECT_EQ(first.field_length(), second.field_length());
}

TEST(Spread, StrengthsKeepTheirRatios) {
    const Scenario scenario = with([](IceSpread& spread) { spread.strength = {LawKind::normal, 0.2}; });
    const FloeSet floes = floes_of(scenario);
    for (std::size_t i = 0; i < 100; ++i) {
        const Ice& ice = floes.material(i).ice;
        EXPECT_NEAR(ice.compressive_strength / ice.bending_strength, 4, 1e-12);
        EXPECT_NEAR(ice.shear_strength / ice.bending_strength, 2, 1e-12);
        EXPECT_EQ(ice.tensile_strength, 0);
    }
}

TEST(Spread, BrineSaysStrengthAndModulus) {
    Scenario scenario;
    scenario.brine = {5e-3, -5};
    const FloeSet floes = floes_of(scenario);
    EXPECT_TRUE(floes.alike());
    const Ice& ice = floes.material(0).ice;
    EXPECT_NEAR(ice.bending_strength, 0.46e6, 0.005e6);
    EXPECT_NEAR(ice.compressive_strength, 4 * ice.bending_strength, 1e-9 * ice.bending_strength);
    EXPECT_NEAR(ice.elastic_modulus, 8.18e9, 0.005e9);
}

std::string sentence(const std::function<void(Scenario&)>& change) {
    Scenario scenario;
    change(scenario);
    const auto found = find_contradictions(scenario);
    return found.empty() ? "" : found.front().sentence;
}

TEST(Spread, WhatCannotBeIsOneSentence) {
    EXPECT_EQ(sentence([](Scenario& s) {
                  s.spread.thickness = {LawKind::normal, 0.2, {1.5}};
              }),
              "spread.thickness_within = [1.5] is not two rising factors, such as [0.5, 2.0]");
    EXPECT_THAT(sentence([](Scenario& s) {
                    s.spread.thickness = {LawKind::normal, 0.1, {2, 3}};
                }),
                testing::HasSubstr("spread.thickness_within = [2.0, 3.0] leaves"));
    EXPECT_THAT(sentence([](Scenario& s) {
                    s.joint.model = JointModel::cfm;
                    s.spread.elastic_modulus = {LawKind::normal, 0.2};
                }),
                testing::HasSubstr("spread.elastic_modulus = \"normal\" needs joint.model = \"beam\""));
    EXPECT_THAT(sentence([](Scenario& s) {
                    s.spread.salinity = {LawKind::normal, 0.2};
                }),
                testing::HasSubstr("spread.salinity = \"normal\" needs brine.salinity_ppt above 0"));
    EXPECT_THAT(sentence([](Scenario& s) {
                    s.ice.elastic_modulus = 2e6;
                    s.spread.strength = {LawKind::normal, 0.2, {0.5, 8}};
                }),
                testing::HasSubstr("at an end of the laws of [spread]: ice.bending_strength_kPa = 291.2"));
    EXPECT_THAT(sentence([](Scenario& s) {
                    s.spread.density = {LawKind::normal, 0.05, {0.9, 1.2}};
                }),
                testing::HasSubstr("so the ice sinks"));
    EXPECT_THAT(sentence([](Scenario& s) {
                    s.brine = {5e-3, -2};
                    s.spread.temperature = {LawKind::normal, 0.2};
                    s.spread.temperature.within = {0.2, 2};
                }),
                testing::HasSubstr("reaches from -4 to -0.4 °C; the formula is for -22.9 to -0.5 °C"));
    EXPECT_THAT(sentence([](Scenario& s) { s.brine = {8e-3, -1}; }), testing::HasSubstr("no stiffness"));
    EXPECT_EQ(sentence([](Scenario& s) { s.spread.thickness = {LawKind::lognormal, 0.2}; }), "");
}

}  // namespace spread_test
}  // namespace floes
