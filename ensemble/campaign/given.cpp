#include "campaign/given.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "arrangement/arrangement.hpp"
#include "arrangement/check.hpp"
#include "campaign/campaign_keys.hpp"
#include "campaign/hull_file.hpp"
#include "campaign/outline_file.hpp"
#include "core/error.hpp"
#include "keys/csv.hpp"
#include "keys/key.hpp"
#include "keys/read.hpp"
#include "scenario/keys.hpp"

namespace floes {

namespace {

constexpr std::string_view header = "x_m,z_m,yaw_deg";

/// Its numbers; empty when a cell is anything else.
std::vector<Value> numbers_of(const CsvLine& line) {
    std::vector<Value> numbers;
    for (const std::string& cell : line.cells) {
        const std::optional<double> number = number_in(cell);
        if (!number) return {};
        numbers.emplace_back(*number);
    }
    return numbers;
}

}  // namespace

PoseFile read_poses(const std::string& text, const std::string& file) {
    const std::vector<CsvLine> lines = csv_lines(text, file);
    const std::string columns = lines.empty() ? "" : joined(lines.front());
    if (!lines.empty() && columns != header && !columns.starts_with(std::string{header} + ","))
        throw InputError(
            fmt::format("{}:{}: {} is not the header of a pose file; write {}, and behind it keys of which "
                        "each floe has a value of its own, such as ice.thickness_m",
                        file, lines.front().number, text_literal(columns), header));
    if (lines.size() < 2)
        throw InputError(fmt::format("{}: there are no poses; write {} and a line for each floe", file, header));
    std::vector<Value> poses;
    std::vector<int> places;
    for (const CsvLine& line : std::span(lines).subspan(1)) {
        std::vector<Value> numbers = numbers_of(line);
        if (numbers.size() != lines.front().cells.size())
            throw InputError(fmt::format("{}:{}: {} is not a pose; write {} numbers, {}", file, line.number,
                                         text_literal(joined(line)), lines.front().cells.size(), columns));
        if (poses.size() == std::size_t{most_floes})
            throw InputError(fmt::format("{}:{}: there are more than {} poses, the most floes of a field", file,
                                         line.number, most_floes));
        poses.emplace_back(std::move(numbers));
        places.push_back(line.number);
    }
    return {file, columns.substr(std::min(columns.size(), header.size() + 1)), {std::move(poses)}, std::move(places)};
}

std::vector<Block> read_points(const std::string& text, const std::string& file) {
    const std::vector<CsvLine> lines = csv_lines(text, file);
    if (lines.size() < 2)
        throw InputError(
            fmt::format("{}: there are no points; write keys, such as ice.thickness_m, in the first line "
                        "and a line for each point",
                        file));
    const CsvLine& keys = lines.front();
    Scenario scratch;
    const Keys known = describe(scratch);
    std::vector<Block> axes;
    for (std::size_t k = 0; k < keys.cells.size(); ++k) {
        const std::string where = fmt::format("{}:{}", file, keys.number);
        const Key* key = find_key(known, full_path(keys.cells[k]));  // none: refused as that of any axis
        std::vector<Value> values;
        for (const CsvLine& line : std::span(lines).subspan(1)) {
            if (line.cells.size() != keys.cells.size())
                throw InputError(fmt::format("{}:{}: {} is not a point; write {} values, of {}", file, line.number,
                                             text_literal(joined(line)), keys.cells.size(), joined(keys)));
            if (line.cells[k].empty())
                throw InputError(fmt::format("{}:{}: {} has no value", file, line.number, keys.cells[k]));
            values.push_back(parse_override(keys.cells[k] + "=" + line.cells[k], where).value);
            if (key != nullptr)
                assign(*key, {std::string(key->path), values.back(), fmt::format("{}:{}", file, line.number)});
        }
        axes.push_back({axis_block, where, {{"key", {keys.cells[k]}, where}, {"values", {std::move(values)}, where}}});
    }
    return axes;
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
