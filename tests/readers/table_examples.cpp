// Configurations, and the tables that stand beside them.

#include <regex>

#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "match/contour_section.hpp"
#include "match/regimes.hpp"
#include "match/waves.hpp"
#include "readers/example.hpp"

namespace floes::test {

namespace {

/// All numbers of the resolved text.
Numbers campaign_numbers(const Campaign& campaign) {
    static const std::regex number(R"([-+]?\d+\.?\d*([eE][-+]?\d+)?)");
    const std::string text = write_campaign(campaign);
    Numbers found;
    for (std::sregex_iterator one(text.begin(), text.end(), number), none; one != none; ++one)
        found.push_back(std::stod(one->str()));
    return found;
}

Example configuration() {
    return {.name = "configuration",
            .file = "my.toml",
            .lines = {"[ice]", "thickness_m = 0.035", "density_kg_m3 = 910.0", "elastic_modulus_MPa = 70.0",
                      "[structure]", "speed_m_s = 0.0625"},
            .first = 1,
            .rows = 3,
            .unit = {"thickness_m", "thickness_cm"},
            .read =
                [](const std::string& text) {
                    return campaign_numbers(read_campaign({text, "my.toml", {}, true}, nullptr));
                },
            .outcomes = "==x===xx?xx??"};
}

std::string beside;  // what a LoadFile gives, which has no state of its own

Campaign with_file(const std::string& text, const std::string& configuration) {
    beside = text;
    return read_campaign({configuration, "my.toml", {}, true}, [](const std::string&) { return beside; });
}

Example poses() {
    return {.name = "poses",
            .file = "poses.csv",
            .lines = {"x_m,z_m,yaw_deg", "6.5,0.25,1.5", "8.5,-0.75,20.5", "10.5,1.25,-30.5", "12.5,0.5,45.5"},
            .first = 1,
            .rows = 4,
            .unit = {"x_m", "x_cm"},
            .read =
                [](const std::string& text) {
                    return campaign_numbers(with_file(text,
                                                      "[arrangement]\nmethod = \"file\"\nfile = \"poses.csv\"\n"
                                                      "[field]\nfloes = 4\nconcentration_percent = 3\n"
                                                      "[structure]\nspeed_m_s = 0.03\n"));
                },
            .outcomes = "======xxxxxx?"};
}

Example points() {
    return {
        .name = "points of a design",
        .file = "points.csv",
        .lines = {"ice.thickness_m,structure.speed_m_s", "0.025,0.045", "0.035,0.055", "0.045,0.065"},
        .first = 1,
        .rows = 3,
        .unit = {"thickness_m", "thickness_cm"},
        .read =
            [](const std::string& text) {
                return campaign_numbers(with_file(text, "[design]\nmethod = \"list\"\npoints_file = \"points.csv\"\n"));
            },
        // Points are independent of each other.
        .outcomes = "======x??xx??"};
}

Example scatter() {
    Lines lines{"ice.thickness_m,structure.speed_m_s,hours_per_year"};
    for (const double h : {0.025, 0.035, 0.045})
        for (const double v : {0.105, 0.205, 0.305})
            lines.push_back(fmt::format("{:.3f},{:.3f},{:.1f}", h, v, 500 * v));
    return {.name = "scatter diagram",
            .file = "ice.csv",
            .lines = std::move(lines),
            .first = 1,
            .rows = 9,
            .unit = {"hours_per_year", "days_per_year"},
            .read =
                [](const std::string& text) {
                    const ContourInputs inputs = read_contour_inputs(text, "ice.csv");
                    Numbers found{inputs.time};
                    for (const ClassHours& one : inputs.classes)
                        for (const double value : {one.value[0], one.value[1], one.hours}) found.push_back(value);
                    return found;
                },
            // Classes of no hours may be left out.
            .outcomes = "======xx?xx??"};
}

Numbers regime_numbers(const std::vector<Regime>& regimes) {
    Numbers found;
    for (const Regime& one : regimes) {
        found.push_back(one.time);
        for (const Entry& entry : one.values) found.push_back(*number_of(entry.value));
    }
    return found;
}

Example regimes() {
    return {.name = "regimes",
            .file = "year.toml",
            .lines = {"regime = [", "{ice.thickness_m = 0.525, hours_per_year = 300.5},",
                      "{ice.thickness_m = 0.725, hours_per_year = 200.5},",
                      "{ice.thickness_m = 0.925, hours_per_year = 100.5},", "]"},
            .first = 1,
            .rows = 3,
            .unit = {"hours_per_year", "days_per_year"},
            .read = [](const std::string& text) { return regime_numbers(read_regimes(text, "year.toml")); },
            .outcomes = "==x===xx?xxxx"};
}

Example targets() {
    return {.name = "targets",
            .file = "targets.toml",
            .lines = {"target = [", "{quantity = \"mean_load\", value = 38.85, uncertainty = 0.5},",
                      "{quantity = \"mean_maximum_0.5s\", value = 102.5, uncertainty = 2.5},",
                      "{quantity = \"failure_ratio\", value = 22.5, uncertainty = 1.5},", "]"},
            .first = 1,
            .rows = 3,
            .unit = {"uncertainty", "uncertainty_kN"},
            .read =
                [](const std::string& text) {
                    Numbers found;
                    for (const Target& one : read_targets(text, "targets.toml")) {
                        found.push_back(one.value);
                        found.push_back(one.uncertainty);
                    }
                    return found;
                },
            .outcomes = "==x===xx?xxxx"};
}

}  // namespace

std::vector<Example> table_examples() {
    return {configuration(), poses(), points(), scatter(), regimes(), targets()};
}

}  // namespace floes::test
