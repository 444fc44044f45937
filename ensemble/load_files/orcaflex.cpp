// OrcaFlex: a vessel's applied load that an external function in Python gives. The program makes an object of the named
// class for each data item and calls Initialise and Calculate with what has DataName ("GlobalAppliedForceX[1]"),
// SimulationTime (s, below 0 while it builds up) and Value, which is set (OrcFxAPI's manual, "Python external
// functions"; OrcaFlex's, "Vessel data: Applied loads"). kN and kN m are its SI units.

#include <string>
#include <utility>

#include <fmt/format.h>

#include "load_files/load_file.hpp"

namespace floes {

namespace {

/// After the table LOADS of rows FX, FY, FZ, MZ.
constexpr const char* function_text = R"(

def value_at(column, time):
    """Linear between the middles of the steps, with the first and the last value held."""
    place = min(max(time / STEP - 0.5, 0.0), len(LOADS) - 1.0)
    first = min(int(place), len(LOADS) - 2) if len(LOADS) > 1 else 0
    last = min(first + 1, len(LOADS) - 1)
    return LOADS[first][column] + (place - first) * (LOADS[last][column] - LOADS[first][column])


class IceLoad(object):
    def Initialise(self, info):
        self.Calculate(info)

    def Calculate(self, info):
        name = info.DataName.split("[")[0]
        if name not in COLUMNS:
            raise Exception("IceLoad gives {}, not {}".format(", ".join(sorted(COLUMNS)), name))
        column = COLUMNS[name]
        info.Value = 0.0 if column is None else value_at(column, info.SimulationTime)
)";

}  // namespace

std::vector<WrittenLoad> orcaflex_files(const LoadToWrite& load, const std::string& path) {
    const LoadSeries& series = load.series;
    std::string text = commented(legend(load, true, "kN", "kN m"));
    const char* applied = load.axes == LoadAxes::earth ? "GlobalApplied" : "LocalApplied";
    text += fmt::format(
        "# Use: an external function of the class IceLoad for the components of an applied load of the vessel "
        "({}ForceX\n"
        "# and so on), whose point is the structure's axis in the waterline; the model in SI units.\n\nSTEP = {:.9g}  "
        "# s\n"
        "COLUMNS = {{",
        applied, series.step);
    const std::pair<const char*, const char*> columns[]{
        {"ForceX", "0"},     {"ForceY", "1"},     {"ForceZ", "2"},
        {"MomentX", "None"}, {"MomentY", "None"}, {"MomentZ", series.moment.empty() ? "None" : "3"}};
    for (const auto& [name, place] : columns) text += fmt::format("\"{}{}\": {}, ", applied, name, place);
    text += "}\nLOADS = [[float(value) for value in row.split()] for row in \"\"\"\\\n";
    for (std::size_t k = 0; k < series.cells(); ++k)
        text += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g}\n", 1e-3 * series.force[0][k], 1e-3 * series.force[1][k],
                            1e-3 * series.force[2][k], series.moment.empty() ? 0 : 1e-3 * series.moment[k]);
    return {{path, text + "\"\"\".splitlines()]\n" + function_text}};
}

}  // namespace floes
