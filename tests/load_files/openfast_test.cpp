// OpenFAST reads what is written for it: readers made after its manual ("Structural Control", "SubDyn input files") and
// the order of names that its parser asks for, which its manual lists with one name cut short.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "load_files/load_file.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace openfast_test {

using testing::HasSubstr;

/// Without comments and the lines that are left empty, as OpenFAST counts lines.
std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        line = line.substr(0, line.find_first_of("#!%"));
        if (line.find_first_not_of(" \t") != std::string::npos) lines.push_back(line);
    }
    return lines;
}

/// Lower case and cut to the 20 letters that are compared.
std::string compared(std::string name) {
    std::ranges::transform(name, name.begin(), [](unsigned char letter) { return std::tolower(letter); });
    return name.substr(0, 20);
}

/// The input file of a structural control: a value and its name on each line, "-" a heading.
struct InputFile {
    std::map<std::string, std::string> values;
    std::string fault;
    std::size_t lines_left = 0;
};

InputFile read_input(const std::string& text, const std::string& unused_mass) {
    std::vector<std::string> names{"-",
                                   "-",
                                   "-",
                                   "Echo",
                                   "-",
                                   "StC_DOF_MODE",
                                   "StC_X_DOF",
                                   "StC_Y_DOF",
                                   "StC_Z_DOF",
                                   "-",
                                   "StC_P_X",
                                   "StC_P_Y",
                                   "StC_P_Z",
                                   "-",
                                   "StC_X_DSP",
                                   "StC_Y_DSP",
                                   "StC_Z_DSP",
                                   "StC_Z_PreLd",
                                   "-",
                                   "StC_X_PSP",
                                   "StC_X_NSP",
                                   "StC_Y_PSP",
                                   "StC_Y_NSP",
                                   "StC_Z_PSP",
                                   "StC_Z_NSP",
                                   "-",
                                   "StC_X_M",
                                   "StC_Y_M",
                                   "StC_Z_M",
                                   unused_mass,
                                   "StC_X_K",
                                   "StC_Y_K",
                                   "StC_Z_K",
                                   "StC_X_C",
                                   "StC_Y_C",
                                   "StC_Z_C",
                                   "StC_X_KS",
                                   "StC_Y_KS",
                                   "StC_Z_KS",
                                   "StC_X_CS",
                                   "StC_Y_CS",
                                   "StC_Z_CS",
                                   "-",
                                   "Use_F_TBL",
                                   "NKInpSt",
                                   "-",
                                   "-",
                                   "-",
                                   "-",
                                   "StC_CMODE",
                                   "StC_CChan",
                                   "StC_SA_MODE",
                                   "StC_X_C_HIGH",
                                   "StC_X_C_LOW",
                                   "StC_Y_C_HIGH",
                                   "StC_Y_C_LOW",
                                   "StC_Z_C_HIGH",
                                   "StC_Z_C_LOW",
                                   "StC_X_C_BRAKE",
                                   "StC_Y_C_BRAKE",
                                   "StC_Z_C_BRAKE",
                                   "-",
                                   "L_X",
                                   "B_X",
                                   "area_X",
                                   "area_ratio_X",
                                   "headLossCoeff_X",
                                   "rho_X",
                                   "L_Y",
                                   "B_Y",
                                   "area_Y",
                                   "area_ratio_Y",
                                   "headLossCoeff_Y",
                                   "rho_Y",
                                   "-",
                                   "PrescribedForcesCoordSys",
                                   "PrescribedForcesFile"};
    const std::vector<std::string> lines = lines_of(text);
    InputFile file;
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (k >= lines.size()) return file.fault = "too short", file;
        if (names[k] == "-") continue;
        std::istringstream words(lines[k]);
        std::string value;
        std::string name;
        words >> value >> name;
        if (compared(name) != compared(names[k])) return file.fault = "no " + names[k] + " in: " + lines[k], file;
        file.values[names[k]] = value;
    }
    file.lines_left = lines.size() - names.size();
    return file;
}

/// Rows of seven numbers, apart by blanks or commas; `header`: lines before them.
std::vector<std::vector<double>> read_rows(const std::vector<std::string>& lines, std::size_t header) {
    std::vector<std::vector<double>> rows;
    for (std::size_t k = header; k < lines.size(); ++k) {
        std::string line = lines[k];
        std::ranges::replace(line, ',', ' ');
        std::istringstream in(line);
        std::vector<double>& row = rows.emplace_back();
        for (double value = 0; in >> value;) row.push_back(value);
    }
    return rows;
}

/// Linear, with the ends held.
double at(const std::vector<std::vector<double>>& rows, double time, std::size_t column) {
    if (time <= rows.front()[0]) return rows.front()[column];
    for (std::size_t k = 1; k < rows.size(); ++k)
        if (time <= rows[k][0]) {
            const double share = (time - rows[k - 1][0]) / (rows[k][0] - rows[k - 1][0]);
            return rows[k - 1][column] + share * (rows[k][column] - rows[k - 1][column]);
        }
    return rows.back()[column];
}

/// Over the length, by midpoints so fine that rows lie on their edges.
double impulse_read(const std::vector<std::vector<double>>& rows, double length, std::size_t column) {
    constexpr int parts = 4000;
    double sum = 0;
    for (int k = 0; k < parts; ++k) sum += at(rows, length * (k + 0.5) / parts, column) * length / parts;
    return sum;
}

LoadToWrite load(LoadAxes axes = LoadAxes::earth) {
    LoadToWrite made;
    made.series = {
        .step = 0.5, .force = {{{-1, -7, -100.25, 0}, {2, 5, -3, 1}, {0.5, -0.25, 1, 2}}}, .moment = {10, -20, 30, 0}};
    made.origin = {.program = "floes 1", .campaign = "a", .fingerprint = "f", .case_name = "soft"};
    made.axes = axes;
    return made;
}

void expect_the_series(const std::vector<std::vector<double>>& rows, const LoadSeries& series) {
    ASSERT_EQ(rows.size(), series.cells());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        ASSERT_EQ(rows[k].size(), 7u);
        EXPECT_NEAR(rows[k][0], 0.5 * (static_cast<double>(k) + 0.5), 1e-9);
        for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(rows[k][1 + axis], series.force[axis][k]);
        EXPECT_EQ(rows[k][4], 0);
        EXPECT_EQ(rows[k][5], 0);
        EXPECT_EQ(rows[k][6], series.moment[k]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(impulse_read(rows, series.length(), 1 + axis), impulse(series)[axis], 1e-9);
    EXPECT_NEAR(impulse_read(rows, series.length(), 6), impulse(series)[3], 1e-9);
}

TEST(OpenFast, ReadsTheSeries) {
    for (const auto write : {openfast_files, openfast_4_files}) {
        const std::vector<WrittenLoad> files = write(load(), "folder/ice.dat");
        ASSERT_EQ(files.size(), 2u);
        EXPECT_EQ(files[0].path, "folder/ice.dat");
        EXPECT_EQ(files[1].path, "folder/ice_StC.dat");
        expect_the_series(read_rows(lines_of(files[0].text), 0), load().series);
    }
}

TEST(OpenFast, ReadsTheInputFileOfEitherVersion) {
    struct Version {
        std::vector<WrittenLoad> (*write)(const LoadToWrite&, const std::string&);
        const char* mode;
        const char* unused_mass;
        const char* of_the_other;
    };
    for (const Version& one : {Version{openfast_files, "6", "StC_Omni_M", "StC_XY_M"},
                               Version{openfast_4_files, "4", "StC_XY_M", "StC_Omni_M"}}) {
        const std::string text = one.write(load(), "ice.dat")[1].text;
        const InputFile file = read_input(text, one.unused_mass);
        EXPECT_EQ(file.fault, "");
        EXPECT_EQ(file.lines_left, 0u);
        EXPECT_EQ(file.values.at("StC_DOF_MODE"), one.mode);
        EXPECT_EQ(file.values.at("NKInpSt"), "0");
        EXPECT_EQ(file.values.at("PrescribedForcesCoordSys"), "1");
        EXPECT_EQ(file.values.at("PrescribedForcesFile"), "\"ice.dat\"");
        EXPECT_THAT(read_input(text, one.of_the_other).fault, HasSubstr("no StC_"));
    }
}

TEST(OpenFast, IsToldOfTheHullsOwnAxes) {
    const InputFile file = read_input(openfast_files(load(LoadAxes::hull), "ice.dat")[1].text, "StC_Omni_M");
    EXPECT_EQ(file.values.at("PrescribedForcesCoordSys"), "2");
}

TEST(OpenFast, GetsNoNameThatItTakesForAComment) {
    EXPECT_THAT(refusal([] { openfast_files(load(), "ice#1.dat"); }),
                HasSubstr("takes what is behind #, ! or % for a comment"));
}

// What docs/coupling.md says of a swing of ten or twenty steps: a mean keeps sin x / x of it, and lines between values
// that are taken so (sin x / x)², x = π S/T.
TEST(Interpolation, KeepsMostOfASwing) {
    for (const auto& [steps, kept] : {std::pair{10, 0.95}, std::pair{20, 0.99}}) {
        LoadToWrite made = load();
        const double turn = 2 * std::numbers::pi / steps;
        for (std::vector<double>& along : made.series.force) along.assign(static_cast<std::size_t>(20 * steps), 0);
        made.series.moment.clear();
        for (int k = 0; k < 20 * steps; ++k)  // means of the cosine over the cells
            made.series.force[0][static_cast<std::size_t>(k)] = (std::sin(turn * (k + 1)) - std::sin(turn * k)) / turn;
        const auto rows = read_rows(lines_of(openfast_files(made, "ice.dat")[0].text), 0);
        double sum = 0;
        const int parts = 100 * steps;
        for (int k = 0; k < parts; ++k) {
            const double time = 0.5 * steps * (5 + 10 * (k + 0.5) / parts);  // ten periods inside
            sum += 2.0 / parts * at(rows, time, 1) * std::cos(turn * time / 0.5);
        }
        const double x = std::numbers::pi / steps;
        EXPECT_NEAR(sum, std::pow(std::sin(x) / x, 3), 1e-3);
        EXPECT_NEAR(sum, kept, 0.005);
    }
}

// All lines but the first are values, one of them each: a legend in the file would be read as values.
TEST(SubDyn, ReadsTheSeries) {
    const std::vector<WrittenLoad> files = subdyn_files(load(), "ice.csv");
    std::vector<std::string> lines;
    std::istringstream in(files[0].text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    EXPECT_EQ(lines.front(), "#Time_[s],Fx_[N],Fy_[N],Fz_[N],Mx_[Nm],My_[Nm],Mz_[Nm]");
    expect_the_series(read_rows(lines, 1), load().series);
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files[1].path, "ice.legend.txt");
    EXPECT_THAT(files[1].text, HasSubstr("\"ice.csv\""));
    EXPECT_THAT(files[1].text, HasSubstr("; they are zero here."));
}

TEST(Legend, StaysAComment) {
    LoadToWrite made = load();
    made.origin.campaign = "good\nimport os\r1,2,3";
    for (const std::vector<WrittenLoad>& files : {csv_files(made, "ice.csv"), openfast_files(made, "ice.dat"),
                                                  orcaflex_files(made, "ice.py"), subdyn_files(made, "ice.dat")})
        for (const WrittenLoad& file : files) {
            EXPECT_THAT(file.text, testing::Not(HasSubstr("\nimport os"))) << file.path;
            EXPECT_THAT(file.text, testing::Not(HasSubstr("\r"))) << file.path;
        }
}

TEST(Legend, SaysWhatALoadIs) {
    LoadToWrite made = load();
    made.tow_towards = 180;
    made.begin = 8;
    made.origin.averaged_steps = 5;
    made.origin.mean_roll = 1.5;
    made.origin.mean_pitch = -2.5;
    const std::string text = csv_files(made, "ice.csv")[0].text;
    for (const char* words : {"case soft, arrangement 0, member 0", "the contact force of the ice on the hull",
                              "did not give way", "goes 180 degrees from X towards Y", "axis in the calm waterline",
                              "Units: s, N, N m", "means over 0.5 s each", "means over 5 time steps",
                              "t = 0 is 8 s of the run", "X -54.125, Y 2.5, Z 1.625; about Z 10 N m s",
                              "moments about X and Y are not kept step by step. Means in the window about the hull's "
                              "own X and Y: 1.5 and -2.5 "
                              "N m."})
        EXPECT_THAT(text, HasSubstr(words));
    EXPECT_THAT(text, HasSubstr("from_s,to_s,FX_N,FY_N,FZ_N,MZ_N_m\n0,0.5,-1,2,0.5,10\n"));
    made.series.moment.clear();
    const std::string without = csv_files(made, "ice.csv")[0].text;
    EXPECT_THAT(without, HasSubstr("nor is that about Z"));
    EXPECT_THAT(without, HasSubstr("about Z: unknown N m."));
    EXPECT_THAT(without, HasSubstr("FX_N,FY_N,FZ_N\n0,0.5,-1,2,0.5\n"));
}

}  // namespace openfast_test
}  // namespace floes
