// Floes of mixed sizes: whole elements, shares reached, the same floes in every arrangement.

#include "scenario/floes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenario/validate.hpp"

namespace floes {
namespace sizes_test {

Scenario mixed(SizeLaw law) {
    Scenario scenario;
    scenario.sizes.law = law;
    scenario.field.floes = 400;
    scenario.floe.element = 0.05;
    return scenario;
}

std::vector<double> areas(const std::vector<FloeShape>& shapes) {
    std::vector<double> found;
    for (const FloeShape& shape : shapes) found.push_back(shape.length * shape.breadth);
    return found;
}

double sum(const std::vector<double>& values) {
    double all = 0;
    for (const double value : values) all += value;
    return all;
}

TEST(Sizes, AListOfTheOneSizeIsThatSize) {
    Scenario scenario;
    scenario.sizes = {.law = SizeLaw::list, .list = {{0.6, 0.6, 1}}};
    for (const FloeShape& shape : floe_sizes(scenario)) EXPECT_EQ(shape, scenario.floe);
    EXPECT_NEAR(scenario.field_length(), Scenario{}.field_length(), 1e-12);
    EXPECT_EQ(find_contradictions(scenario).size(), 0U);
}

TEST(Sizes, ListedSharesAreReachedToAFloe) {
    Scenario scenario = mixed(SizeLaw::list);
    scenario.sizes.list = {{0.4, 0.4, 0.5}, {0.6, 0.6, 0.3}, {1.2, 0.6, 0.2}};
    EXPECT_EQ(listed_counts(scenario), (std::vector<int>{200, 120, 80}));
    scenario.field.floes = 7;
    EXPECT_EQ(listed_counts(scenario), (std::vector<int>{4, 2, 1}));  // of 3.5, 2.1 and 1.4
    scenario.sizes.by = SharesOf::area;
    scenario.field.floes = 400;
    const std::vector<double> all = areas(floe_sizes(scenario));
    EXPECT_EQ(all.size(), 400U);
    const std::vector<int> counts = listed_counts(scenario);
    for (std::size_t k = 0; k < counts.size(); ++k) {
        const ListedSize& one = scenario.sizes.list[k];
        const double area = one.length * one.breadth;
        EXPECT_NEAR(counts[k] * area / sum(all), one.share, 1.5 * area / sum(all));
    }
}

TEST(Sizes, AreWholeElementsThatFollowTheLaw) {
    Scenario scenario = mixed(SizeLaw::power_law);
    scenario.elements.form = ElementForm::squares;
    scenario.sizes.largest_ratio = 2;
    scenario.floe.element = 0.01;  // hardly rounds
    const std::vector<FloeShape> shapes = floe_sizes(scenario);
    double mean = 0;
    for (const FloeShape& shape : shapes) {
        for (const double side : {shape.length, shape.breadth})
            EXPECT_NEAR(side / shape.element, std::round(side / shape.element), 1e-9);
        EXPECT_GE(shape.length, shape.breadth);
        EXPECT_LE(shape.length, 2.05 * shape.breadth);
        mean += std::sqrt(shape.length * shape.breadth) / 400;
    }
    // D^-2.5 from 0.4 to 1.2: the mean is 3 (0.4^-0.5 - 1.2^-0.5) / (0.4^-1.5 - 1.2^-1.5).
    const double closed = 3 * (1 / std::sqrt(0.4) - 1 / std::sqrt(1.2)) / (std::pow(0.4, -1.5) - std::pow(1.2, -1.5));
    EXPECT_NEAR(mean, closed, 0.002);
}

TEST(Sizes, EveryArrangementHasTheSameFloesInAnotherOrder) {
    const Scenario scenario = mixed(SizeLaw::lognormal);
    const auto sides = [&](std::uint32_t number) {
        const FloeSet floes = floes_of(scenario, {1, number});
        std::vector<double> found;
        for (std::size_t i = 0; i < floes.size(); ++i) found.push_back(floes.shape(i).length);
        return found;
    };
    std::vector<double> first = sides(0);
    std::vector<double> second = sides(1);
    EXPECT_NE(first, second);
    EXPECT_EQ(first, sides(0));
    std::ranges::sort(first);
    std::ranges::sort(second);
    EXPECT_EQ(first, second);
    EXPECT_NEAR(covered_area(floes_of(scenario, {1, 1})),
                scenario.field_length() * 2 * scenario.field.half_width * scenario.field.concentration, 1e-9);
}

TEST(Sizes, ElementsFollowTheFloeOrTheIce) {
    Scenario scenario = mixed(SizeLaw::lognormal);
    scenario.sizes.element = ElementSide::of_floe;
    scenario.sizes.elements_across = 4;
    for (const FloeShape& shape : floe_sizes(scenario)) EXPECT_EQ(shape.elements(), 16);
    scenario.sizes.element = ElementSide::of_ice;
    scenario.sizes.element_share = 0.2;
    // (60 MPa 0.033³ / (12 (1 - 0.09) 1000 9.81))^¼ = 0.3767 m
    for (const FloeShape& shape : floe_sizes(scenario)) EXPECT_NEAR(shape.element, 0.2 * 0.3767, 1e-4);
}

TEST(Sizes, WhatCannotBeIsOneSentence) {
    const auto sentence = [](const Scenario& scenario) {
        const auto found = find_contradictions(scenario);
        return found.empty() ? "" : found.front().sentence;
    };
    Scenario scenario = mixed(SizeLaw::list);
    EXPECT_EQ(sentence(scenario),
              "sizes.law = \"list\" needs sizes.list_m = [[length_m, breadth_m, share_percent], ...]");
    scenario.sizes.list = {{0.4, 0.4, 0.5}, {0.6, 0.6, 0.4}};
    EXPECT_EQ(sentence(scenario), "the shares of sizes.list_m sum to 90 %; they are to sum to 100 %");
    scenario.sizes.list = {{0.4, 0.4, 0.5}, {0.61, 0.6, 0.5}};
    EXPECT_EQ(sentence(scenario), "") << "cells need no whole sides";
    scenario.elements.form = ElementForm::squares;
    EXPECT_EQ(sentence(scenario),
              "floe.element_m = 0.05 does not divide the side of 0.61 m in sizes.list_m; the nearest side that does is "
              "0.0508333, or take sizes.element = \"of_floe\"");
    scenario = mixed(SizeLaw::power_law);
    scenario.sizes.smallest = 1.2;
    EXPECT_EQ(sentence(scenario), "sizes.smallest_m = 1.2 is not below sizes.largest_m = 1.2");
    scenario = mixed(SizeLaw::lognormal);
    scenario.sizes.smallest = 20;
    scenario.sizes.largest = 50;
    EXPECT_THAT(sentence(scenario),
                testing::HasSubstr("of the lognormal law of sizes.mean_m = 0.6 and sizes.cov = 0.4"));
    scenario = mixed(SizeLaw::lognormal);
    scenario.floe.element = 0.5;
    EXPECT_EQ(sentence(scenario),
              "floe.element_m = 0.5 makes elements of 0.5 m, larger than the side of 0.4 m of the smallest floe; take "
              "smaller elements or larger floes");
    scenario = mixed(SizeLaw::lognormal);
    scenario.floe.element = 1e-5;
    EXPECT_EQ(sentence(scenario),
              "floe.element_m = 1e-05 makes elements of 1e-05 m, more than 10000 of them along the largest floe");
    scenario = mixed(SizeLaw::lognormal);
    scenario.arrangement.method = ArrangementMethod::file;
    EXPECT_EQ(sentence(scenario),
              "sizes.law = \"lognormal\" does not suit arrangement.method = \"file\"; give the sizes as columns of "
              "arrangement.file");
}

}  // namespace sizes_test
}  // namespace floes
