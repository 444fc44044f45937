#include "campaign/given.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <sstream>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "arrangement/arrangement.hpp"
#include "arrangement/check.hpp"
#include "campaign/hull_file.hpp"
#include "campaign/outline_file.hpp"
#include "core/error.hpp"
#include "keys/key.hpp"
#include "keys/read.hpp"
#include "scenario/keys.hpp"

namespace floes {

namespace {

constexpr std::string_view header = "x_m,z_m,yaw_deg";

/// The line without spaces, tabs and carriage returns.
std::string squeezed(const std::string& line) {
    std::string text;
    for (const char character : line) {
        if (character != ' ' && character != '\t' && character != '\r') text += character;
    }
    return text;
}

/// The numbers between commas; empty when there is anything else.
std::vector<Value> numbers_of(const std::string& line) {
    std::vector<Value> numbers;
    std::istringstream cells(line + ",");
    for (std::string cell; std::getline(cells, cell, ',');) {
        double number = 0;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
        if (error != std::errc() || end != cell.data() + cell.size()) return {};
        numbers.emplace_back(number);
    }
    return numbers;
}

}  // namespace

PoseFile read_poses(const std::string& text, const std::string& file) {
    std::vector<Value> poses;
    std::istringstream lines(text);
    std::vector<int> places;
    std::optional<std::string> header_seen;
    int number = 0;
    for (std::string raw; std::getline(lines, raw);) {
        ++number;
        const std::string line = squeezed(raw);
        if (line.empty()) continue;
        if (!header_seen) {
            const bool longer = line.size() > header.size() && line[header.size()] == ',';
            if (!line.starts_with(header) || !(line == header || longer)) {
                throw InputError(
                    fmt::format("{}:{}: {} is not the header of a pose file; write {}, and behind it keys "
                                "of which each floe has a value of its own, such as ice.thickness_m",
                                file, number, text_literal(line), header));
            }
            header_seen = line;
            continue;
        }
        std::vector<Value> numbers = numbers_of(line);
        const auto columns = static_cast<std::size_t>(1 + std::ranges::count(*header_seen, ','));
        if (numbers.size() != columns) {
            throw InputError(fmt::format("{}:{}: {} is not a pose; write {} numbers, {}", file, number,
                                         text_literal(line), columns, *header_seen));
        }
        if (poses.size() == std::size_t{most_floes})
            throw InputError(fmt::format("{}:{}: there are more than {} poses, the most floes of a field", file, number,
                                         most_floes));
        poses.emplace_back(std::move(numbers));
        places.push_back(number);
    }
    if (poses.empty())
        throw InputError(fmt::format("{}: there are no poses; write {} and a line for each floe", file, header));
    std::string columns = header_seen->substr(std::min(header_seen->size(), header.size() + 1));
    return {file, std::move(columns), {std::move(poses)}, std::move(places)};
}

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
