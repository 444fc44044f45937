// floes hydro: what other programs' files say of a hull's hydrodynamics and moorings, as keys of [moorings].

#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.hpp"
#include "cli/config.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "hydro/mooring_file.hpp"
#include "hydro/radiation.hpp"

namespace floes {
namespace {

struct HydroOptions {
    std::string file;
    std::optional<double> period;
    WamitUnits wamit;
    double gravity = 9.80665;
    double depth = std::numeric_limits<double>::infinity();
    std::optional<double> waterplane;
};

std::string matrix_text(const char* key, const Matrix6& matrix) {
    std::string text = fmt::format("{} = [\n", key);
    for (const std::vector<double>& row : matrix) {
        std::vector<std::string> numbers;
        for (const double value : row) numbers.push_back(fmt::format("{:.6g}", value / unit::tonne));
        text += fmt::format("  [{}],\n", fmt::join(numbers, ", "));
    }
    return text + "]\n";
}

/// A first column that is no period, a length or a density that are others give another waterplane.
std::string guard(const HydroOptions& options, const RadiationFile& radiation) {
    const std::optional<double> implied =
        waterplane_by_waves(radiation, options.wamit.density, options.gravity, options.depth);
    if (!implied) return "# its longest waves say nothing of the waterplane: no damping in heave\n";
    constexpr double most = 1.5;
    if (options.waterplane && std::abs(std::log(*implied / *options.waterplane)) > std::log(most))
        throw InputError(fmt::format(
            "{}: the damping in heave of its longest waves is that of a waterplane of {:.4g} m², not of the {:.4g} m² "
            "of "
            "--waterplane-m2; is its first column a period in s, --length-m its length, --density its water, --depth-m "
            "its depth?",
            options.file, *implied, *options.waterplane));
    return fmt::format("# the damping in heave of its longest waves is that of a waterplane of {:.4g} m²{}\n", *implied,
                       options.waterplane ? "" : "; compare it with your hull's, or give --waterplane-m2");
}

std::string moorings_text(const HydroOptions& options, const std::string& text) {
    const MooringFile moorings = read_moorings(text, options.file, options.wamit.density, options.gravity);
    std::string out;
    for (const std::string& remark : moorings.remarks) out += "# " + remark + "\n";
    out +=
        "# x, height and z of the fairlead, azimuth, distance, depth, length, weight, stiffness, friction, break load\n"
        "hanging_lines = [\n";
    for (const HangingLine& line : moorings.lines)
        out += fmt::format("  [{:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:g}, {:g}],\n",
                           line.fairlead.x(), line.fairlead.y(), line.fairlead.z(), line.azimuth / unit::degree,
                           line.distance, line.depth, line.cable.length, line.cable.weight,
                           line.cable.stiffness / unit::kilonewton, line.cable.friction,
                           line.break_load / unit::kilonewton);
    return out + "]\n";
}

std::string radiation_text(const HydroOptions& options, const std::string& text) {
    const RadiationFile radiation = read_radiation(text, options.file, options.wamit);
    if (!options.period)
        throw InputError(
            fmt::format("{}: give the period at which its values are to hold, --period-s, the hull's own in heave or "
                        "pitch; the file "
                        "has {:.4g} to {:.4g} s",
                        options.file, 2 * std::numbers::pi / radiation.points.back().frequency,
                        2 * std::numbers::pi / radiation.points.front().frequency));
    const RadiationPoint at = radiation_at(radiation, 2 * std::numbers::pi / *options.period);
    std::string out = fmt::format("# {} at {:g} s, about its own reference point\n", options.file, *options.period);
    for (const std::string& remark : radiation.remarks) out += "# " + remark + "\n";
    return out + guard(options, radiation) + matrix_text("added_mass", at.added) +
           matrix_text("radiation_damping", at.damping);
}

}  // namespace

void add_hydro(CommandLine& line) {
    auto options = std::make_shared<HydroOptions>();
    Verb verb = line.verb("hydro", "Keys of [moorings] from the files of other programs: WAMIT's .1, NEMOH, MoorDyn");
    verb.option("file", options->file, "WAMIT's .1, NEMOH's RadiationCoefficients.tec, or a file of MoorDyn or MoorPy")
        .required();
    verb.option("--period-s", options->period, "Period at which added mass and damping are taken").positive();
    verb.option("--density", options->wamit.density, "Density of the water, kg/m³, which WAMIT's files do not say")
        .positive()
        .shows_default();
    verb.option("--length-m", options->wamit.length, "Length of WAMIT's units, ULEN; 1 where SI was written")
        .positive()
        .shows_default();
    verb.option("--depth-m", options->depth, "Depth of the water of the radiation file; default: deep").positive();
    verb.option("--gravity", options->gravity, "Gravity, m/s²").positive().shows_default();
    verb.option("--waterplane-m2", options->waterplane,
                "Waterplane of the hull, against which the file's longest waves are checked")
        .positive();
    verb.footer(
        "What it prints goes under [moorings] of a configuration. Values of a radiation file are constant in a run, "
        "so\n"
        "take them at the natural period that matters, which floes config --check says; matrices are about the\n"
        "file's reference point, which has to be the structure's axis at the calm water.\n\n"
        "  floes hydro hull.1 --period-s 9 --waterplane-m2 3850 >> my.toml\n"
        "  floes hydro moorings.dat");
    verb.runs([options] {
        const std::string text = read_text(options->file);
        const bool radiation =
            text.find("VARIABLES") < 4096 || text.find("LINE") == std::string::npos;  // MoorDyn has sections of lines
        std::cout << (radiation ? radiation_text(*options, text) : moorings_text(*options, text));
        return 0;
    });
}

}  // namespace floes
