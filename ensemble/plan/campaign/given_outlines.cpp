#include "campaign/given_outlines.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "core/error.hpp"
#include "scenario/keys.hpp"
#include "traced/take_outlines.hpp"

namespace floes {

void GivenOutlines::resolve(Scenario& scenario, const Origins& origins, const std::string& label) {
    TracedOutlines& traced = scenario.shapes.traced;
    if (traced.path.empty()) return;
    if (!scenario.shapes.from_file()) return traced.path.clear();  // of another case; KeyEffects sees one of none
    const auto refuse = [&](const std::string& what) {
        return InputError(
            fmt::format("{}: {}{} {}", origins.at("shapes.file"), label, given(scenario, "shapes.file"), what));
    };
    if (!traced.outlines.empty()) throw refuse("and shapes.outlines are both given; keep one");
    if (load_file_ == nullptr) throw refuse("cannot be read here; give shapes.outlines");
    if (!read_ || read_path_ != traced.path || read_unit_ != traced.unit) {
        read_path_ = traced.path;
        read_unit_ = traced.unit;
        TracedOutlines fresh = traced;
        const std::string path = (std::filesystem::path(configuration_).parent_path() / traced.path).string();
        take_outlines(fresh, load_file_(path), path);
        read_ = std::move(fresh);
    }
    const double scale = traced.scale;
    const double most_added = traced.most_added;
    traced = *read_;
    traced.scale = scale;
    traced.most_added = most_added;
}

}  // namespace floes
