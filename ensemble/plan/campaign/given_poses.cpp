#include "campaign/given_poses.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "arrangement/arrangement.hpp"
#include "arrangement/check.hpp"
#include "core/error.hpp"
#include "keys/read.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace {

/// What a field has to be for outlines that lie as they were traced.
std::string room_for_traced(const Scenario& scenario) {
    const TracedOutlines& traced = scenario.shapes.traced;
    Outline corners;
    for (const Outline& one : traced.outlines) corners.insert(corners.end(), one.begin(), one.end());
    const Corner size = traced.scale * size_of(corners);
    const double clearance = scenario.arrangement.clearance;
    const double covered = scenario.field.concentration * scenario.field_length();  // per width of the field
    return fmt::format(
        "; the outlines reach over {:.4g} m x {:.4g} m, for which field.concentration_percent is at most {:.3g} and "
        "field.half_width_m at least {:.4g}",
        size.x, size.z, 100 * covered / (size.x + 2 * clearance), size.z / 2 + clearance);
}

}  // namespace

std::optional<PoseFile> GivenPoses::resolve(Scenario& scenario, const Origins& origins,
                                            const std::string& label) const {
    std::string& file = scenario.arrangement.file;
    if (file.empty()) return {};
    const std::string given_file = given(scenario, "arrangement.file");
    const auto refuse = [&](const std::string& what) {
        return InputError(fmt::format("{}: {}{} {}", origins.at("arrangement.file"), label, given_file, what));
    };
    if (scenario.arrangement.method != ArrangementMethod::file) {
        throw refuse(fmt::format("is not used by {}; write arrangement.method = \"file\"",
                                 given(scenario, "arrangement.method")));
    }
    if (!scenario.arrangement.poses.empty()) throw refuse("and arrangement.poses are both given; keep one");
    if (load_file_ == nullptr) throw refuse("cannot be read here; give arrangement.poses");
    const std::string path = (std::filesystem::path(configuration_).parent_path() / file).string();
    const Keys keys = describe(scenario);
    PoseFile read = read_poses(load_file_(path), path);
    if (!scenario.arrangement.columns.empty() && scenario.arrangement.columns != read.columns)
        throw refuse("has its columns in its header; leave arrangement.columns out");
    scenario.arrangement.columns = read.columns;
    assign(*find_key(keys, "arrangement.poses"), {"arrangement.poses", read.poses, path});
    file.clear();
    return read;
}

void GivenPoses::refuse_faults(const Scenario& scenario, const std::optional<PoseFile>& file, const Origins& origins,
                               const std::string& label) {
    if (!scenario.arrangement.given()) return;
    if (!looked_at_.insert(geometry_key(scenario)).second) return;  // of an earlier case
    const std::optional<Fault> fault = find_fault(scenario, floes_of(scenario));
    if (!fault) return;
    const bool traced = scenario.arrangement.method == ArrangementMethod::traced;
    std::string where = file ? file->path : origins.at(traced ? "arrangement.method" : "arrangement.poses");
    if (file && !fault->floes.empty()) {
        std::vector<int> lines;
        for (const std::size_t floe : fault->floes) lines.push_back(file->lines[floe]);
        where += fmt::format(", line{} {}", lines.size() == 1 ? "" : "s", fmt::join(lines, " and "));
    }
    const std::string instead = traced && fault->floes.size() == 1 ? room_for_traced(scenario) : "";
    throw InputError(fmt::format("{}: {}{}{}", where, label, fault->sentence, instead));
}

}  // namespace floes
