#include "campaign/given_hull.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <tuple>

#include "cad/hull_file.hpp"
#include "core/error.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace {

auto as_given(const HullFile& file) {
    return std::tie(file.path, file.unit, file.up, file.forward, file.waterline);
}

}  // namespace

void GivenHull::resolve(Scenario& scenario, const Origins& origins, const std::string& label) {
    Structure& structure = scenario.structure;
    const std::string& file = structure.hull_file.path;
    if (file.empty()) return;
    const auto refuse = [&](const std::string& what) {
        return InputError(
            fmt::format("{}: {}{} {}", origins.at("hull.file"), label, given(scenario, "hull.file"), what));
    };
    if (structure.shape.kind() != HullKind::file)
        throw refuse(fmt::format("is not used by {}; write hull.shape = \"file\"", given(scenario, "hull.shape")));
    if (!structure.shape.piece_rows().empty()) throw refuse("and hull.pieces are both given; keep one");
    if (load_file_ == nullptr) throw refuse("cannot be read here; give hull.pieces");
    const std::string path = (std::filesystem::path(configuration_).parent_path() / file).string();
    if (!cut_ || as_given(*cut_) != as_given(structure.hull_file)) {
        Structure fresh;
        fresh.hull_file = structure.hull_file;
        take_hull(fresh, load_file_(path), path);
        cut_ = structure.hull_file;
        pieces_ = fresh;
    }
    structure.shape.set_pieces(pieces_.shape.piece_rows());
    structure.shape.set_faces(pieces_.shape.face_rows());
    structure.shape.part_list() = pieces_.shape.part_list();
    structure.hull_file = {
        .path = "", .most_added = structure.hull_file.most_added, .volume = pieces_.hull_file.volume};
}

}  // namespace floes
