// OpenFAST: a structural control (StC) on the platform that applies a prescribed series, and SubDyn's own driver.
//
// The series has seven columns and comments behind #, ! or %; the input file of the StC names it and has a value and
// its name on each line, in one order (ServoDyn's manual, "Structural Control", and its parser). Prescribed series are
// StC_DOF_MODE 4 up to OpenFAST 4.2 and 6 from 5.0 on, whose file also calls one unused mass otherwise.

#include <cstddef>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "core/error.hpp"
#include "load_files/load_file.hpp"

namespace floes {

namespace {

namespace fs = std::filesystem;

/// Seven columns: the middle of each cell, FX, FY, FZ, MX, MY, MZ.
std::string rows(const LoadSeries& series, const char* between) {
    std::string text;
    for (std::size_t k = 0; k < series.cells(); ++k)
        text += fmt::format("{1:.9g}{0}{2:.9g}{0}{3:.9g}{0}{4:.9g}{0}0{0}0{0}{5:.9g}\n", between,
                            series.step * (static_cast<double>(k) + 0.5), series.force[0][k], series.force[1][k],
                            series.force[2][k], series.moment.empty() ? 0 : series.moment[k]);
    return text;
}

/// Beside `path`: "loads.dat" and "_StC.dat" give "loads_StC.dat".
std::string beside(const std::string& path, const char* end) {
    const fs::path whole(path);
    return (whole.parent_path() / (whole.stem().string() + end)).string();
}

struct Version {
    const char* words;
    int mode;                 ///< of a prescribed series
    const char* unused_mass;  ///< what the file calls it
};

std::string line(const std::string& value, const std::string& name, const char* remark = "") {
    return *remark == 0 ? fmt::format("{:>12}   {}\n", value, name)
                        : fmt::format("{:>12}   {:<26}{}\n", value, name, remark);
}

std::string lines_of(const char* value, std::initializer_list<const char*> names) {
    std::string text;
    for (const char* name : names) text += line(value, name);
    return text;
}

std::string section(const char* title) {
    return fmt::format("---------------------- {} ----------------------\n", title);
}

/// What a prescribed series does not use, in its place.
std::string unused(const Version& version) {
    std::string text = section("STC INITIAL CONDITIONS (not used)");
    text += lines_of("0", {"StC_X_DSP", "StC_Y_DSP", "StC_Z_DSP"}) + line("\"none\"", "StC_Z_PreLd");
    text += section("STC CONFIGURATION (not used)");
    text += lines_of("0", {"StC_X_PSP", "StC_X_NSP", "StC_Y_PSP", "StC_Y_NSP", "StC_Z_PSP", "StC_Z_NSP"});
    text += section("STC MASS, STIFFNESS AND DAMPING (not used)");
    text +=
        lines_of("0", {"StC_X_M", "StC_Y_M", "StC_Z_M", version.unused_mass, "StC_X_K", "StC_Y_K", "StC_Z_K", "StC_X_C",
                       "StC_Y_C", "StC_Z_C", "StC_X_KS", "StC_Y_KS", "StC_Z_KS", "StC_X_CS", "StC_Y_CS", "StC_Z_CS"});
    text += section("STC USER-DEFINED SPRING FORCES (not used)");
    text += line("False", "Use_F_TBL") + line("0", "NKInpSt");
    text += section("STC SPRING FORCES TABLE (not used)");
    text += "    X    F_X    Y    F_Y    Z    F_Z\n   (m)   (N)   (m)   (N)   (m)   (N)\n";
    text += section("STRUCTCTRL CONTROL (not used)");
    text += lines_of("0", {"StC_CMODE", "StC_CChan"}) + line("1", "StC_SA_MODE");
    text += lines_of("0", {"StC_X_C_HIGH", "StC_X_C_LOW", "StC_Y_C_HIGH", "StC_Y_C_LOW", "StC_Z_C_HIGH", "StC_Z_C_LOW",
                           "StC_X_C_BRAKE", "StC_Y_C_BRAKE", "StC_Z_C_BRAKE"});
    text += section("TLCD (not used)");
    return text + lines_of("1", {"L_X", "B_X", "area_X", "area_ratio_X", "headLossCoeff_X", "rho_X", "L_Y", "B_Y",
                                 "area_Y", "area_ratio_Y", "headLossCoeff_Y", "rho_Y"});
}

std::string title(const Version& version) {
    return fmt::format("------- STRUCTURAL CONTROL (StC) INPUT FILE, {} -------\n", version.words);
}

std::string prescribed(const LoadToWrite& load, const std::string& series) {
    return section("PRESCRIBED TIME SERIES") +
           (load.axes == LoadAxes::earth ? line("1", "PrescribedForcesCoordSys", "- global")
                                         : line("2", "PrescribedForcesCoordSys", "- local")) +
           line("\"" + series + "\"", "PrescribedForcesFile");
}

std::string input_file(const LoadToWrite& load, const std::string& series, const Version& version) {
    std::string text = title(version);
    text += fmt::format("Load of ice on the platform, by {}; the series says more. ServoDyn: NumSStC, SStCfiles\n",
                        load.origin.program);
    text += section("SIMULATION CONTROL") + line("False", "Echo");
    text += section("STC DEGREES OF FREEDOM");
    text += line(std::to_string(version.mode), "StC_DOF_MODE", "- a prescribed series of forces and moments");
    text += lines_of("False", {"StC_X_DOF", "StC_Y_DOF", "StC_Z_DOF"});
    text += section("STC LOCATION");
    for (const char* name : {"StC_P_X", "StC_P_Y", "StC_P_Z"})
        text += line("0", name, "- the structure's axis in the waterline, from the platform's reference point (m)");
    text += unused(version);
    return text + prescribed(load, series);
}

std::vector<WrittenLoad> files_for(const LoadToWrite& load, const std::string& path, const Version& version) {
    const std::string name = fs::path(path).filename().string();
    if (name.find_first_of("#!%\"") != std::string::npos)
        throw InputError(fmt::format(
            "OpenFAST takes what is behind #, ! or % for a comment, so that no file can be called {}: name another.",
            name));
    std::string text = commented(legend(load, true, "N", "N m"));
    text += fmt::format("# For {}: StC_DOF_MODE {}.\n", version.words, version.mode);
    text += "# Time  FX  FY  FZ  MX  MY  MZ\n# (s)  (N)  (N)  (N)  (N m)  (N m)  (N m)\n";
    return {{path, text + rows(load.series, "  ")},
            {beside(path, "_StC.dat"), input_file(load, name, version), {title(version), prescribed(load, name)}}};
}

}  // namespace

std::vector<WrittenLoad> openfast_files(const LoadToWrite& load, const std::string& path) {
    return files_for(load, path, {"OpenFAST 5.0 and later", 6, "StC_Omni_M"});
}

std::vector<WrittenLoad> openfast_4_files(const LoadToWrite& load, const std::string& path) {
    return files_for(load, path, {"OpenFAST 3.1 to 4.2", 4, "StC_XY_M"});
}

// A header of one line, then seven columns with commas: every other line would be read as values, so the legend stands
// beside it (SubDyn's manual, "Applied loads", and its driver).
std::vector<WrittenLoad> subdyn_files(const LoadToWrite& load, const std::string& path) {
    std::string text;
    for (const std::string& one : legend(load, true, "N", "N m")) text += one + "\n";
    text += fmt::format(
        "Use: in the input file of SubDyn's own driver, a line of the table of applied loads:\n"
        "  JOINT  0  0  0  0  0  0  \"{}\"\n",
        fs::path(path).filename().string());
    return {{path, "#Time_[s],Fx_[N],Fy_[N],Fz_[N],Mx_[Nm],My_[Nm],Mz_[Nm]\n" + rows(load.series, ",")},
            {beside(path, ".legend.txt"), text}};
}

}  // namespace floes
