#include "statistics/averaged_load.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"

namespace floes {
namespace peaks_test {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Peaks, AreLocalMaximaFromTheHighestDown) {
    const std::vector<double> load{0, 3, 1, 5, 1, 4, 0};
    EXPECT_THAT(declustered_peaks(load, 1, 0), ElementsAre(5, 4, 3));
    EXPECT_THAT(declustered_peaks(load, 3, 0), ElementsAre(5));  // 4 and 3 are two places away
    EXPECT_THAT(declustered_peaks(load, 2, 0), ElementsAre(5, 4, 3));
    EXPECT_THAT(declustered_peaks(load, 1, 3), ElementsAre(5, 4));  // above, not at
}

TEST(Peaks, AtTheEndsCountWhereTheLoadRisesToThem) {
    EXPECT_THAT(declustered_peaks(std::vector<double>{4, 1, 2, 3}, 1, 0), ElementsAre(4, 3));
    EXPECT_THAT(declustered_peaks(std::vector<double>{}, 1, 0), IsEmpty());
    EXPECT_THAT(declustered_peaks(std::vector<double>{2}, 1, 0), ElementsAre(2));
}

TEST(Peaks, OfAPlateauAreOne) {
    EXPECT_THAT(declustered_peaks(std::vector<double>{0, 2, 2, 2, 0}, 1, 0), ElementsAre(2));
}

std::vector<double> noise(std::size_t count) {
    RandomStream random{3, 0, StreamId::bootstrap, 0};
    std::vector<double> values(count);
    double state = 0;
    for (double& value : values) value = state = 0.9 * state + random.uniform(-1, 1);
    return values;
}

// Declustering again above a higher level changes nothing: the same peaks, from the highest down.
TEST(Peaks, AboveAHigherLevelAreTheSamePeaks) {
    const std::vector<double> load = noise(5000);
    const std::vector<double> all = declustered_peaks(load, 50, 0);
    EXPECT_TRUE(std::ranges::is_sorted(all, std::ranges::greater{}));
    for (const double level : {0.5, 1.0, 2.0}) {
        const auto above = std::ranges::count_if(all, [&](double peak) { return peak > level; });
        EXPECT_EQ(declustered_peaks(load, 50, level), std::vector<double>(all.begin(), all.begin() + above));
    }
}

// No two are nearer than asked for, and no more would fit: of 5000 values there are at most 5000 / 50 + 1.
TEST(Peaks, AreApart) {
    const std::vector<double> load = noise(5000);
    const std::vector<double> peaks = declustered_peaks(load, 50, -1e9);
    EXPECT_LE(peaks.size(), 101u);
    EXPECT_GE(peaks.size(), 40u);
    std::vector<std::ptrdiff_t> places;
    for (const double peak : peaks) places.push_back(std::ranges::find(load, peak) - load.begin());
    std::ranges::sort(places);
    for (std::size_t k = 1; k < places.size(); ++k) EXPECT_GE(places[k] - places[k - 1], 50);
}

}  // namespace peaks_test
}  // namespace floes
