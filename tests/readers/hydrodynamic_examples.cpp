// Radiation, hydrostatics and mooring lines, as other programs write them.

#include "hydro/hydrostatic_file.hpp"
#include "hydro/mooring_file.hpp"
#include "hydro/radiation.hpp"
#include "readers/example.hpp"

namespace floes::test {

namespace {

void put(Numbers& numbers, const Mat6& matrix) {
    for (const double value : matrix.reshaped())
        if (value != 0) numbers.push_back(value);
}

Numbers radiation_numbers(const RadiationFile& file) {
    Numbers found;
    for (const RadiationPoint& point : file.points) {
        found.push_back(point.frequency);
        put(found, point.added);
        put(found, point.damping);
    }
    if (file.at_zero) put(found, *file.at_zero);
    if (file.at_infinity) put(found, *file.at_infinity);
    return found;
}

Example wamit() {
    Lines lines{" WAMIT Numeric Output"};
    for (const auto& [i, j] : {std::pair{1, 1}, {1, 5}, {3, 3}, {5, 5}}) {
        lines.push_back(fmt::format(" -1.0 {} {} {:.3f}", i, j, 2.0 + 0.1 * i));
        lines.push_back(fmt::format(" 0.0 {} {} {:.3f}", i, j, 1.0 + 0.1 * i));
        for (const double period : {8.0, 9.0, 10.0})
            lines.push_back(fmt::format(" {:.1f} {} {} {:.3f} {:.4f}", period, i, j, 1.2 + 0.1 * i + 0.01 * period,
                                        0.02 * j + 0.001 * period));
    }
    const std::size_t rows = lines.size() - 1;
    return {.name = "WAMIT's .1",
            .file = "hull.1",
            .lines = std::move(lines),
            .first = 1,
            .rows = rows,
            .read = [](const std::string& text) { return radiation_numbers(read_radiation(text, "hull.1", {})); },
            // The rows of one motion alone may be those of a hull of which no more was computed.
            .outcomes = "=======xxx-??"};
}

/// One zone has rows, so that what is changed in it is to be told by the other five.
Example nemoh() {
    Lines lines{
        R"head(VARIABLES="w (rad/s)" "A 1" "B 1" "A 2" "B 2" "A 3" "B 3" "A 4" "B 4" "A 5" "B 5" "A 6" "B 6")head"};
    for (int zone = 1; zone <= 6; ++zone) {
        lines.push_back(fmt::format("Zone t=\"Motion of body   1 in DoF    {}\",I=     3,F=POINT", zone));
        for (const double frequency : {0.5, 0.6, 0.7}) {
            std::string row = fmt::format(" {:.4f}", frequency);
            for (int force = 1; force <= 6; ++force)
                row += fmt::format(" {:.6f} {:.6f}", force == zone ? 1000.0 * zone + 100 * frequency : 0.0,
                                   force == zone ? 10.0 * zone + frequency : 0.0);
            lines.push_back(row);
        }
    }
    return {.name = "NEMOH's RadiationCoefficients.tec",
            .file = "RadiationCoefficients.tec",
            .lines = std::move(lines),
            .first = 10,
            .rows = 3,
            .unit = {"w (rad/s)", "w (furlongs)"},
            .read =
                [](const std::string& text) {
                    return radiation_numbers(read_radiation(text, "RadiationCoefficients.tec", {}));
                },
            .outcomes = "=======xxxxxx"};
}

Example wamit_hydrostatics() {
    return {
        .name = "WAMIT's .hst",
        .file = "hull.hst",
        .lines = {" WAMIT -- hydrostatics", " 3 3 3.8375", " 3 5 0.5000", " 4 4 0.6449", " 5 3 0.5000", " 5 5 0.7449"},
        .first = 1,
        .rows = 5,
        .read =
            [](const std::string& text) {
                Numbers found;
                put(found, read_hydrostatics(text, "hull.hst", {}, 9.81));
                return found;
            },
        // Heave with pitch may be left out, as where it is 0.
        .outcomes = "=======x?x-xx"};
}

Example nemoh_hydrostatics() {
    return {.name = "NEMOH's KH.dat",
            .file = "KH.dat",
            .lines = {"0.0 0.0 0.0 0.0 0.0 0.0", "0.0 0.0 0.0 0.0 0.0 0.0", "0.0 0.0 1333210.0 0.0 15.0 0.0",
                      "0.0 0.0 0.0 2500.0 0.0 0.0", "0.0 0.0 15.0 0.0 3500.0 0.0", "0.0 0.0 0.0 0.0 0.0 0.0"},
            .first = 0,
            .rows = 6,
            .read =
                [](const std::string& text) {
                    Numbers found;
                    put(found, read_hydrostatics(text, "KH.dat", {}, 9.81));
                    return found;
                },
            .outcomes = "=====-xxxx-xx"};
}

Numbers mooring_numbers(const std::string& text) {
    Numbers found;
    for (const HangingLine& line : read_moorings(text, "lines.dat", 1000, 9.81).lines)
        for (const double value :
             {line.fairlead.x(), line.fairlead.y(), line.fairlead.z(), line.azimuth, line.distance, line.depth,
              line.cable.length, line.cable.weight, line.cable.stiffness, line.cable.friction, line.break_load})
            found.push_back(value);
    return found;
}

/// Of the rows of one of its tables.
Example moordyn(const char* name, std::size_t first, std::size_t rows, const char* outcomes) {
    return {.name = name,
            .file = "lines.dat",
            .lines = {"MoorDyn input",
                      "--- LINE TYPES ---",
                      "Name Diam MassDen EA BA EI Cd Ca CdAx CaAx",
                      "(-) (m) (kg/m) (N) (N-s/-) (-) (-) (-) (-) (-)",
                      "main 0.09 77.7 384243000.0 -0.8 0.0 1.6 1.0 0.1 0.0",
                      "thin 0.08 67.7 284243000.0 -0.8 0.0 1.6 1.0 0.1 0.0",
                      "--- POINTS ---",
                      "ID Type X Y Z Mass Volume CdA Ca",
                      "(#) (-) (m) (m) (m) (kg) (m3) (m^2) (-)",
                      "1 Fixed -853.0 0.0 -320.0 0.0 0.0 0.0 0.0",
                      "2 Fixed 426.9 739.4 -320.0 0.0 0.0 0.0 0.0",
                      "3 Fixed 426.9 -739.4 -320.0 0.0 0.0 0.0 0.0",
                      "4 Coupled -5.2 0.0 -70.0 0.0 0.0 0.0 0.0",
                      "5 Coupled 2.6 4.5 -70.0 0.0 0.0 0.0 0.0",
                      "6 Coupled 2.6 -4.5 -70.0 0.0 0.0 0.0 0.0",
                      "--- LINES ---",
                      "ID LineType AttachA AttachB UnstrLen NumSegs LineOutputs",
                      "(#) (name) (#) (#) (m) (-) (-)",
                      "1 main 1 4 902.2 20 p",
                      "2 main 2 5 903.2 20 p",
                      "3 thin 3 6 904.2 20 p",
                      "--- OPTIONS ---",
                      "320.0 WtrDpth",
                      "1025.0 WtrDnsty",
                      "--- need this line ---"},
            .first = first,
            .rows = rows,
            .unit = {"(m) (kg/m) (N)", "(in) (kg/m) (N)"},
            .read = mooring_numbers,
            .outcomes = outcomes};
}

}  // namespace

std::vector<Example> hydrodynamic_examples() {
    return {wamit(),
            nemoh(),
            wamit_hydrostatics(),
            nemoh_hydrostatics(),
            moordyn("MoorDyn's lines", 18, 3, "=======xxxxxx"),
            moordyn("MoorDyn's points", 9, 6, "=======xxxxxx")};
}

}  // namespace floes::test
