#include "serve/served_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "campaign/read.hpp"
#include "core/error.hpp"
#include "support/synthetic.hpp"

namespace floes {
namespace served_model_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

Design design(const std::string& text) {
    return read_campaign({text, "a.toml", {}}, nullptr).design;
}

const char* const sobol =
    "structure = {start_m = 5}\nanalysis = {steady_start_s = 20, window_s = 9}\n[design]\nmethod = \"sobol\"\npoints = "
    "2\n"
    "[[design.axis]]\nkey = \"ice.thickness_m\"\nfrom = 0.02\nto = 0.05\n"
    "[[design.axis]]\nkey = \"field.floes\"\nfrom = 24\nto = 32\n";

std::vector<std::string> keys_of(const std::vector<ModelInput>& inputs) {
    std::vector<std::string> keys;
    for (const ModelInput& one : inputs) keys.push_back(one.key);
    return keys;
}

TEST(ModelInputs, AreTheAxes) {
    const std::vector<ModelInput> inputs = model_inputs(design(sobol), {});
    EXPECT_THAT(keys_of(inputs), ElementsAre("ice.thickness_m", "field.floes"));
    EXPECT_EQ(inputs[0].from, 0.02);
    EXPECT_EQ(inputs[0].to, 0.05);
    EXPECT_FALSE(inputs[0].whole);
    EXPECT_TRUE(inputs[1].whole);
}

TEST(ModelInputs, LieBetweenTheValuesOfAGrid) {
    const Campaign grid = synthetic::campaign_with_design();
    const std::vector<ModelInput> inputs = model_inputs(grid.design, {});
    EXPECT_THAT(keys_of(inputs), ElementsAre("ice.thickness_m", "joint.cfm"));
    EXPECT_EQ(inputs[0].from, 0.03);
    EXPECT_EQ(inputs[0].to, 0.05);
    EXPECT_TRUE(inputs[1].bounded());
}

TEST(ModelInputs, AreNamedAlso) {
    const std::vector<ModelInput> inputs =
        model_inputs(design(sobol), {"structure.speed_m_s", "ice.thickness_m", "field.floes"});
    EXPECT_THAT(keys_of(inputs), ElementsAre("structure.speed_m_s", "ice.thickness_m", "field.floes"));
    EXPECT_FALSE(inputs[0].bounded());
    EXPECT_TRUE(inputs[1].bounded());
    EXPECT_TRUE(inputs[2].whole);
    EXPECT_TRUE(model_inputs({}, {"field.floes"})[0].whole);
}

TEST(ModelInputs, AreNumbersEach) {
    EXPECT_THAT([] { model_inputs({}, {}); }, ThrowsMessage<InputError>(HasSubstr(
                                                  "has no [[design.axis]] whose keys could be the inputs; name them by "
                                                  "--input")));
    EXPECT_THAT([] { model_inputs({}, {"ice.thicknes_m"}); },
                ThrowsMessage<InputError>(
                    "--input ice.thicknes_m: this is not a key that a case takes; did you mean ice.thickness_m?"));
    EXPECT_THAT([] { model_inputs({}, {"contact.friction"}); },
                ThrowsMessage<InputError>(HasSubstr("contact.friction takes no single number")));
    EXPECT_THAT(
        [] {
            model_inputs({}, {"ice.thickness_m", "ice.thickness_m"});
        },
        ThrowsMessage<InputError>("--input ice.thickness_m is given twice; keep one"));
    EXPECT_THAT(
        [] {
            model_inputs(design("[design]\nmethod = \"grid\"\n[[design.axis]]\nkey = \"field.far_end\"\n"
                                "values = [\"open\", \"ice_sheet\"]\n"),
                         {});
        },
        ThrowsMessage<InputError>(HasSubstr("field.far_end takes no single number")));
}

TEST(ModelOutputs, AreMeasured) {
    Campaign campaign = synthetic::campaign();  // averages over 0.1 and 0.4 s
    EXPECT_THAT(model_outputs(campaign, {}), ElementsAre("mean_load", "mean_maximum_0.4s"));
    EXPECT_THAT(model_outputs(campaign, {"failure_ratio", "mean_maximum_0.1s"}),
                ElementsAre("failure_ratio", "mean_maximum_0.1s"));
    EXPECT_THAT([&] { model_outputs(campaign, {"mean_lod"}); },
                ThrowsMessage<InputError>(HasSubstr("--output mean_lod: this is no quantity of a member")));
    EXPECT_THAT([&] { model_outputs(campaign, {"mean_maximum_1s"}); },
                ThrowsMessage<InputError>(HasSubstr("the load is not averaged over 1 s here")));
}

TEST(ModelQuestion, IsTheSamePointWhateverIsTold) {
    const ModelQuestion one{{0.03, 1}, 4, 2, false};
    EXPECT_TRUE(one.same_point({{0.03, 1}, 4, 2, true}));
    EXPECT_FALSE(one.same_point({{0.03, 2}, 4, 2, false}));
    EXPECT_FALSE(one.same_point({{0.03, 1}, {}, 2, false}));
    EXPECT_FALSE(one.same_point({{0.03, 1}, 4, 3, false}));
}

}  // namespace served_model_test
}  // namespace floes
