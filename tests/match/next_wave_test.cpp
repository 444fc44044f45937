// The next wave: a campaign that reads back, at the points that were chosen.

#include "match/matching.hpp"

#include <gmock/gmock.h>

#include "campaign/campaign.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "core/error.hpp"

namespace floes {
namespace next_wave_test {

MatchWave wave() {
    MatchWave made;
    made.file = "wave1.h5";
    made.campaign = read_campaign({"[campaign]\narrangements = 3\n[design]\nmethod = \"sobol\"\npoints = 4\n"
                                   "[[design.axis]]\nkey = \"contact.ice_ice_friction\"\nfrom = 0.1\nto = 0.5\n"
                                   "[[design.axis]]\nkey = \"joint.cfm\"\nfrom = 0.001\nto = 0.1\nscale = \"log\"\n"
                                   "[[design.axis]]\nkey = \"arrangement.ordering_sweeps\"\nfrom = 0\nto = 10\n"
                                   "[arrangement]\nmethod = \"scattered\"\n[[case]]\nname = \"A\"\n[[case]]\nname = "
                                   "\"B\"\ngeneral.iterations = 20\n",
                                   "wave1.toml",
                                   {}},
                                  nullptr);
    return made;
}

TEST(NextWave, IsTheCampaignAtThePointsThatWereChosen) {
    MatchWave first = wave();
    first.campaign.run.base_case = "A+p001";  // points of this wave
    first.campaign.stop.half_width = 0.1;
    first.campaign.stop.contrast = "B+p003 - A+p003";
    const std::vector<RangedAxis> axes = match_axes(std::span(&first, 1));
    Eigen::MatrixXd coordinates(2, 3);
    coordinates << 0, 0, 0, 0.123456789, 1, -1;
    const Campaign next = next_wave(first, axes, coordinates, "wave2", 8);
    EXPECT_EQ(next.name, "wave2");
    EXPECT_EQ(next.seed, 8u);
    EXPECT_EQ(next.arrangements, 3);
    ASSERT_EQ(next.cases.size(), 4u);
    EXPECT_EQ(next.cases[3].base, "B");
    EXPECT_EQ(next.cases[3].name, "B+p001");
    EXPECT_EQ(numeric_value(next.cases[0], "contact.ice_ice_friction"), 0.3);
    EXPECT_EQ(numeric_value(next.cases[0], "joint.cfm"), 0.01);
    EXPECT_EQ(numeric_value(next.cases[0], "arrangement.ordering_sweeps"), 5);
    EXPECT_EQ(numeric_value(next.cases[3], "contact.ice_ice_friction"), 0.324691);
    EXPECT_EQ(numeric_value(next.cases[3], "joint.cfm"), 0.1);
    EXPECT_EQ(next.cases[3].scenario.general.iterations, 20);
    const Campaign again = read_campaign({write_campaign(next), "wave2.toml", {}}, nullptr);
    EXPECT_EQ(fingerprint(again), fingerprint(next));
    EXPECT_EQ(again.design.axes.size(), 3u);
    EXPECT_EQ(again.cases[3].base, "B");
    EXPECT_EQ(again.cases[3].point, 1);
}

// The radius at the keel is a part of the profile, which stands in full in the text of the next wave.
TEST(NextWave, VariesAPartOfAnotherKey) {
    MatchWave first;
    first.file = "wave1.h5";
    first.campaign = read_campaign({"[design]\nmethod = \"sobol\"\npoints = 4\n[[design.axis]]\n"
                                    "key = \"structure.keel_radius_m\"\nfrom = 0.3\nto = 0.5\n",
                                    "wave1.toml",
                                    {}},
                                   nullptr);
    const std::vector<RangedAxis> axes = match_axes(std::span(&first, 1));
    const Campaign next = next_wave(first, axes, Eigen::MatrixXd::Constant(1, 1, 0.5), "wave2", 8);
    MatchWave second;
    second.file = "wave2.h5";
    second.campaign = read_campaign({write_campaign(next), "wave2.toml", {}}, nullptr);
    EXPECT_EQ(numeric_value(second.campaign.cases[0], "structure.keel_radius_m"), 0.45);
    std::vector<MatchWave> both{first, second};
    EXPECT_EQ(match_axes(both).size(), 1u);
    both[1].campaign.cases[0].scenario.structure.speed = 1;
    EXPECT_THROW(match_axes(both), InputError);
}

}  // namespace next_wave_test
}  // namespace floes
