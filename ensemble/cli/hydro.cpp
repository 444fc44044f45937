// floes hydro: what other programs' files say of a hull's hydrodynamics and moorings, as keys of [moorings].

#include "cli/commands.hpp"
#include "hydro/mooring_keys.hpp"

namespace floes {
namespace {

struct HydroOptions {
    MooringKeysRequest request;
    std::string case_name;
};

std::string text_of(const HydroOptions& options) {
    MooringKeysRequest request = options.request;
    const std::string bytes = read_bytes(request.file);
    if (!request.hull_name.empty())
        request.hull = chosen_case(load_campaign(request.hull_name, {}), options.case_name).scenario;
    return mooring_keys(request, bytes);
}

}  // namespace

void add_hydro(CommandLine& line) {
    auto options = std::make_shared<HydroOptions>();
    Verb verb = line.verb(
        "hydro", "Keys of [moorings] from the files of other programs: WAMIT, NEMOH, Capytaine, MoorDyn, MoorPy");
    verb.option("file", options->request.file,
                "WAMIT's .1 or .hst, NEMOH's RadiationCoefficients.tec or KH.dat, Capytaine's NetCDF, or a file of "
                "MoorDyn or MoorPy")
        .required();
    verb.option("--hull", options->request.hull_name,
                "Configuration of the hull: its water, its waterplane, and each motion at its natural period")
        .value_name("CONFIG");
    verb.option("--case", options->case_name, "Which of its cases").value_name("NAME");
    verb.option("--period-s", options->request.period,
                "Period at which added mass and damping are taken, of all motions")
        .positive();
    verb.option("--density", options->request.density,
                "Density of the water, kg/m³, which WAMIT's files do not say; default: the hull's, or 1025")
        .positive();
    verb.option("--length-m", options->request.length, "Length of WAMIT's units, ULEN; 1 where SI was written")
        .positive()
        .shows_default();
    verb.option("--depth-m", options->request.depth, "Depth of the water of the radiation file; default: deep")
        .positive();
    verb.option("--gravity", options->request.gravity, "Gravity, m/s²; default: the hull's, or 9.80665").positive();
    verb.option("--waterplane-m2", options->request.waterplane,
                "Waterplane of the hull, against which the file's longest waves are checked")
        .positive();
    verb.option("--reference-m", options->request.reference,
                "The file's reference point from the axis at the calm water: ahead, to port, up; default: there")
        .comma_separated()
        .exactly(3);
    verb.option("--weight", options->request.weight,
                "Whether the stiffness of a .hst or KH.dat holds the hull's weight")
        .one_of({"inside", "outside"});
    verb.footer(
        "What it prints goes under [moorings] of a configuration. Values of a radiation file are constant in a run:\n"
        "those at the natural period of each motion with --hull, or all at one period. A .hst gives no keys; it is\n"
        "compared with the hull.\n\n"
        "  floes hydro hull.nc --hull my.toml\n"
        "  floes hydro hull.1 --period-s 9 --waterplane-m2 3850 >> my.toml\n"
        "  floes hydro hull.hst --hull my.toml --weight inside\n"
        "  floes hydro moorings.dat");
    verb.prints([options] { return text_of(*options); });
}

}  // namespace floes
