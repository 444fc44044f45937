// floes export CONFIG --fmu: a member as an FMU, which other programs step beside their own models.

#include "cli/export_fmu.hpp"

#include <fstream>
#include <set>

#include "campaign/write.hpp"
#include "cli/commands.hpp"
#include "fmu/fmu_file.hpp"
#include "scenario/validate.hpp"
#include "shapes/hydrostatics.hpp"
#include "store/session.hpp"

namespace floes {

namespace {

namespace fs = std::filesystem;

/// The library of FMUs: beside the program in a build, otherwise where it was installed.
fs::path fmu_library() {
    std::error_code unknown;
    const fs::path folder = fs::read_symlink("/proc/self/exe", unknown).parent_path();
    for (const fs::path& path :
         {folder / "floes_fmu.so", (folder / FLOES_FMU_FROM_PROGRAM / "floes_fmu.so").lexically_normal()})
        if (fs::exists(path, unknown)) return path;
    throw RunError(fmt::format(
        "the library of FMUs, floes_fmu.so, is neither beside the program in {} nor in {} from there; it is made for "
        "x86-64 Linux and installed with the program.",
        folder.string(), FLOES_FMU_FROM_PROGRAM));
}

/// Bullet's libraries, which an FMU's library needs beside it: those that this program has loaded.
std::vector<ArchivedFile> bullet_libraries() {
    std::set<std::string> paths;
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        const std::size_t path = line.find('/');
        if (path == std::string::npos) continue;
        const std::string name = fs::path(line.substr(path)).filename().string();
        if (name.starts_with("libBullet") || name.starts_with("libLinearMath")) paths.insert(line.substr(path));
    }
    std::vector<ArchivedFile> found;
    for (const fs::path path : paths) found.emplace_back(path.filename().string(), read_bytes(path.string()));
    return found;
}

/// How many times the heaviest floe with its water the hull weighs: on its moorings, or floating.
double hull_over_floe(Scenario scenario) {
    if (!scenario.moorings.give_way()) {
        scenario.moorings = {};
        scenario.moorings.mass = hydrostatics(scenario.structure.shape).volume * scenario.water.density;
    }
    const double along = scenario.water.added_mass_from == WaterFrom::share ? scenario.water.added_mass
                                                                            : scenario.water.added_mass_in_plane;
    return structure_over_floe(scenario) / (1 + along);
}

/// What moving the hull outside costs in stability (docs/coupling.md).
void tell_of_mass(const Scenario& scenario) {
    constexpr double ample = 10;
    const double ratio = hull_over_floe(scenario);
    if (ratio >= ample) return;
    note(
        "the hull{} weighs {:.2g} times the heaviest floe with its water. Moved outside, it is stable against less ice "
        "than it weighs with its added mass, whatever the step: {}. The parameter added_mass raises that limit by "
        "twice its value, and moorings in the configuration (--motion inside) have none; docs/coupling.md.",
        scenario.moorings.give_way() ? "" : ", taken to weigh what it displaces,", ratio,
        ratio <= 1 ? "a single floe is too heavy" : "a jam of a few floes is too heavy");
}

HullMover mover_of(const FmuOptions& options, const Case& one) {
    const bool moored = one.scenario.moorings.give_way();
    if (options.motion == "inside" && !moored)
        throw InputError(fmt::format(
            "case {} has no moorings (moorings.mass_t), so that the FMU cannot move its hull; give it some, or take "
            "--motion outside.",
            one.name));
    return options.motion == "outside" || !moored ? HullMover::outside : HullMover::inside;
}

}  // namespace

int write_fmu(const FmuOptions& options, const std::string& config, const std::string& case_name) {
    const Campaign campaign = load_campaign(config, options.overrides);
    const Case& one = case_name.empty() ? campaign.cases.front() : chosen_case(campaign, case_name);
    if (one.pairing == Pairing::find_cfm)
        throw InputError(fmt::format(
            "case {} has joints whose Σ is to be calibrated; state joint.cfm, or take beam joints.", one.name));
    const HullMover mover = mover_of(options, one);
    if (mover == HullMover::outside) tell_of_mass(one.scenario);
    FmuParts parts{.description = {.model_name = campaign.name,
                                   .token = {},
                                   .program = "floes " + floes_version(),
                                   .case_name = one.name,
                                   .arrangement = options.arrangement.value_or(0),
                                   .time_step = one.scenario.general.time_step,
                                   .stop_time = one.scenario.general.time_step * one.scenario.step_count(),
                                   .can_be_saved = saves_state(one.scenario.general.solver),
                                   .mover = mover},
                   .configuration = write_campaign(campaign),
                   .library = read_bytes(fmu_library().string()),
                   .libraries = bullet_libraries(),
                   .licences = {{"license.txt", std::string(starter("LICENSE").value())},
                                {"third_party.md", std::string(starter("THIRD_PARTY.md").value())}}};
    write_page(options.file, fmu_file(std::move(parts), options.version == 2 ? FmiVersion::two : FmiVersion::three));
    std::printf("%s\n", options.file.c_str());
    return 0;
}

void add_fmu_options(Verb& verb, FmuOptions& options) {
    verb.option("--fmu", options.file, "Of a configuration: an FMU for co-simulation, of one case")
        .writes_file()
        .file_ending({".fmu"});
    verb.option("--version", options.version, "Of FMI, 2 or 3").within(2, 3).shows_default();
    verb.option("--motion", options.motion,
                "Who moves the hull: the FMU on its moorings, or the other program; default: inside with moorings")
        .one_of({hull_mover_words.begin(), hull_mover_words.end()});
    add_overrides(verb, options.overrides);
}

}  // namespace floes
