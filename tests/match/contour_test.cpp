// Environmental contours from text: what is read, fitted and refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/units.hpp"
#include "match/contour_section.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace contour_test {

using testing::HasSubstr;

const std::string distributions =
    "hours_per_year = 600\n"
    "[[input]]\nkey = \"ice.thickness_m\"\ndistribution = \"weibull\"\nscale = 0.03\nshape = 3\n"
    "[[input]]\nkey = \"structure.speed_m_s\"\ndistribution = \"lognormal\"\nmedian = [0.1, 4, 1.5]\nsd_log = 0.3\n";

std::string table(const std::string& more = "") {
    std::string text = "ice.thickness_m,structure.speed_m_s,hours_per_year\n";
    for (const double h : {0.02, 0.03, 0.04})
        for (const double v : {0.1, 0.2, 0.3}) text += std::to_string(h) + "," + std::to_string(v) + ",50\n";
    return text + more;
}

TEST(ContourInputs, AreDistributionsOfToml) {
    const ContourInputs inputs = read_contour_inputs(distributions, "ice.toml");
    EXPECT_EQ(inputs.keys[0], "ice.thickness_m");
    EXPECT_EQ(inputs.time, 600 * unit::hour);
    EXPECT_FALSE(inputs.fit);
    const std::array<double, 2> at = inputs.inputs.at(1, -2);
    EXPECT_NEAR(at[0], 0.03 * std::pow(-std::log(0.5 * std::erfc(1 / std::sqrt(2.0))), 1.0 / 3), 1e-12);
    EXPECT_NEAR(at[1], (0.1 + 4 * std::pow(at[0], 1.5)) * std::exp(-0.6), 1e-12);
}

TEST(ContourInputs, AreFittedToAScatterDiagram) {
    const ContourInputs inputs = read_contour_inputs(table(), "ICE.CSV");
    EXPECT_EQ(inputs.keys[1], "structure.speed_m_s");
    EXPECT_NEAR(inputs.time, 450 * unit::hour, 1e-6);
    EXPECT_EQ(inputs.classes.size(), 9u);
    ASSERT_TRUE(inputs.fit);
    EXPECT_NEAR(inputs.inputs.other.first.c, 0, 1e-4);  // the second does not depend on the first
    std::string toml;
    for (const ClassHours& one : inputs.classes)
        toml += "[[regime]]\nhours_per_year = 50\nice.thickness_m = " + std::to_string(one.value[0]) +
                "\nstructure.speed_m_s = " + std::to_string(one.value[1]) + "\n";
    EXPECT_EQ(read_contour_inputs(toml, "ice.toml").inputs.one.first.a, inputs.inputs.one.first.a);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

TEST(ContourInputs, AreTheSameHoweverTheDiagramIsWritten) {
    const JointFit fit = read_contour_inputs(table(), "ice.csv").fit.value();
    for (const std::string& text :
         {replaced(table(), ",", "\t"), "sep=,\n" + table(), table(",,\n,,\n"), replaced(table(), "\n", "\r"),
          replaced(table(), "\n", "\r\n"), replaced(table(), "\n", ",,\n"),
          replaced(replaced(table(), ",", ";"), "0.", "0,")}) {
        const ContourInputs read = read_contour_inputs(text, "ice.csv");
        EXPECT_EQ(read.classes.size(), 9u) << text;
        EXPECT_NEAR(read.time, 450 * unit::hour, 1e-6) << text;
        EXPECT_EQ(read.inputs.one.first.a, fit.inputs.one.first.a) << text;
    }
}

TEST(ContourInputs, RefuseWhatIsNoJointDistribution) {
    const auto said = [](const std::string& text, const std::string& file) {
        return refusal([&] { read_contour_inputs(text, file); });
    };
    const auto instead = [](const std::string& from, const std::string& to) {
        return replaced(distributions, from, to);
    };
    EXPECT_THAT(said(table("0.05,-0.1,3\n"), "a.csv"),
                HasSubstr("a.csv:11: structure.speed_m_s = -0.1 is not above 0"));
    EXPECT_THAT(said("ice.thickness_m,hours_per_year\n0.02,3\n", "a.csv"), HasSubstr("a contour is of two inputs"));
    EXPECT_THAT(said("ice.thickness_m,structure.speed_m_s,hours_per_year\n0.02,0.1,3\n0.03,0.1,3\n", "a.csv"),
                HasSubstr("ice.thickness_m has 2 different values, and a distribution wants at least 3"));
    EXPECT_EQ(said(replaced(table(), "thickness_m", "thickness_cm"), "a.csv"),
              "a.csv:2: ice.thickness_cm is not a key of a case that takes a number; did you mean ice.thickness_m?");
    EXPECT_THAT(said(instead("ice.thickness_m", "ice.thickness_mm"), "a.toml"),
                HasSubstr("a.toml:3: ice.thickness_mm is not a key of a case that takes a number"));
    EXPECT_THAT(said(instead("ice.thickness_m", "field.floes"), "a.toml"),
                HasSubstr("a.toml:3: field.floes takes whole numbers or words"));
    EXPECT_THAT(said(instead("hours_per_year = 600\n", ""), "a.toml"), HasSubstr("hours_per_year is missing"));
    EXPECT_THAT(said(instead("600", "9000"), "a.toml"),
                HasSubstr("hours_per_year = 9000 must be above 0 and at most 8784"));
    EXPECT_THAT(said(instead("\"weibull\"", "\"gamma\""), "a.toml"),
                HasSubstr("distribution = \"gamma\" is not one of normal, lognormal, weibull, exponential"));
    EXPECT_THAT(said(instead("shape = 3", "sd = 3"), "a.toml"),
                HasSubstr("sd is no key of a weibull distribution; it has scale and shape"));
    EXPECT_THAT(said(instead("shape = 3\n", ""), "a.toml"), HasSubstr("this [[input]] has no shape"));
    EXPECT_THAT(said(instead("shape = 3", "shape = [1, 2, 3]"), "a.toml"),
                HasSubstr("give a number, because the first input depends on none"));
    EXPECT_THAT(said(instead("[0.1, 4, 1.5]", "[0.1, 4]"), "a.toml"),
                HasSubstr("or [a, b, c] for a + b x^c, x the first input"));
    EXPECT_THAT(said(instead("shape = 3", "shape = -3"), "a.toml"), HasSubstr("scale and shape must be above 0"));
    EXPECT_THAT(said(instead("structure.speed_m_s", "ice.thickness_m"), "a.toml"), HasSubstr("is an input already"));
    EXPECT_THAT(said("hours_per_year = 3\n", "a.toml"), HasSubstr("this text has 0 of [[input]]"));
}

TEST(Contours, AreRefusedWhereTheyDoNotExist) {
    ContourInputs inputs = read_contour_inputs(distributions, "ice.toml");
    ContourRequest request;
    inputs.inputs.other.first = {1, -20, 1};
    EXPECT_THAT(refusal([&] { find_contours(inputs, request); }),
                HasSubstr("the distribution of structure.speed_m_s does not exist where ice.thickness_m is"));
    request.state = 1e5 * inputs.time;
    EXPECT_THAT(refusal([&] { find_contours(inputs, request); }), HasSubstr("are so few"));
}

TEST(Contours, AreToldWithTheirPoints) {
    const ContourInputs inputs = read_contour_inputs(table(), "ice.csv");
    const ContourRequest request{.points = 8};
    const std::vector<ContourOf> contours = find_contours(inputs, request);
    ASSERT_EQ(contours.size(), 2u);
    EXPECT_NEAR(contours[0].radius, contour_radius(0.01, 150), 1e-12);
    const std::vector<Section> sections = contour_sections(inputs, request, contours);
    const auto told = nlohmann::json::parse(json(sections));
    EXPECT_EQ(told.at("contours").size(), 16u);
    EXPECT_EQ(told.at("contours")[0].at("ice.thickness_m"), contours[0].points[0].value[0]);
    EXPECT_EQ(told.at("inputs")[1].at("distribution"), "lognormal");
    EXPECT_THAT(text(sections, 120), HasSubstr("Ice of 450 h a year: 150 states of 3 h."));
    EXPECT_THAT(csv(sections), HasSubstr("per_year,radius,angle_deg,ice.thickness_m,structure.speed_m_s"));
}

}  // namespace contour_test
}  // namespace floes
