#include "hydro/mooring_file.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "hydro/mooring_options.hpp"
#include "hydro/mooring_sections.hpp"
#include "hydro/rows.hpp"
#include "scenario/validate.hpp"

namespace floes {

namespace {

struct Point {
    bool anchor;
    Vec3 place;  ///< floes' axes, m
};

struct Type {
    double diameter, mass, stiffness;
};

/// A line with the places of its ends and its file.
struct Line {
    HangingLine hanging;
    std::string fairlead;  ///< the number of the point
    MooringRow row;
};

using Once = GivenOnce<std::string, std::vector<std::string>>;

void refuse_another(const MooringSections& file, Once& once, const MooringRow& row, const char* what) {
    std::vector<std::string> plain;  // the same however its numbers are written
    for (const std::string& word : row.words) {
        const std::optional<double> number = number_of(word);
        plain.push_back(number ? fmt::format("{}", *number) : word);
    }
    if (const auto other = once.other_line(row.words[0], plain, row.line))
        throw file.wrong(row, "gives {} {} again, otherwise than line {}", what, row.words[0], *other);
}

std::optional<std::size_t> column_of(const MooringSection& section, std::initializer_list<const char*> names) {
    for (const char* name : names) {
        const auto at = std::ranges::find(section.columns, name);
        if (at != section.columns.end()) return static_cast<std::size_t>(at - section.columns.begin());
    }
    return {};
}

/// Columns of a row that stand for something, other than 0, that is not modelled: "M 5000, V 2".
std::string present(const MooringSection& section, const MooringRow& row, std::initializer_list<const char*> columns) {
    std::vector<std::string> found;
    for (const char* name : columns) {
        const std::optional<std::size_t> at = column_of(section, {name});
        if (at && *at < row.words.size() && number_of(row.words[*at]) != 0.0)
            found.push_back(fmt::format("{} {}", name, row.words[*at]));
    }
    return fmt::format("{}", fmt::join(found, ", "));
}

std::map<std::string, Point> points_of(const MooringSections& file, std::vector<std::string>& remarks) {
    std::map<std::string, Point> found;
    Once once;
    for (const MooringSection* section : file.need("points")) {
        for (const std::size_t column : {2, 3, 4}) file.refuse_other_unit(*section, column, "m");
        for (const MooringRow& row : section->rows) {
            if (row.words.size() < 5) throw file.wrong(row, "is no point: number, kind, x, y and z");
            refuse_another(file, once, row, "point");
            const std::string kind = upper(row.words[1]);
            const auto is = [&](std::initializer_list<const char*> names) {
                return std::ranges::any_of(names, [&](const char* name) { return kind == name; });
            };
            const bool anchor = is({"FIX", "FIXED", "ANCHOR"});
            if (!anchor && !is({"VESSEL", "COUPLED", "FAIRLEAD", "BODY1", "VES", "CPLD"}))
                throw file.wrong(
                    row, "has a point that is {}; lines go from a fairlead on the vessel to a fixed anchor here",
                    row.words[1]);
            const std::string more =
                anchor ? "" : present(*section, row, {"M", "MASS", "V", "VOLUME", "FX", "FY", "FZ"});
            if (!more.empty())
                remarks.push_back(
                    fmt::format("{}:{}: point {} has {}, which is not modelled: give the hull what it bears",
                                file.file(), row.line, row.words[0], more));
            // x ahead, y to port, z up: floes has z to starboard and y up.
            found[row.words[0]] = {anchor,
                                   {file.number(row, 2, "x"), file.number(row, 4, "z"), 0 - file.number(row, 3, "y")}};
        }
    }
    return found;
}

std::map<std::string, Type> types_of(const MooringSections& file, std::vector<std::string>& remarks) {
    std::map<std::string, Type> found;
    Once once;
    for (const MooringSection* section : file.need("types")) {
        file.refuse_other_unit(*section, 1, "m");
        file.refuse_other_unit(*section, 2, "kg/m");
        file.refuse_other_unit(*section, 3, "N");
        for (const MooringRow& row : section->rows) {
            if (row.words.size() < 4) throw file.wrong(row, "is no line type: name, diameter, mass and EA");
            refuse_another(file, once, row, "line type");
            MooringRow plain = row;
            plain.words[3] = row.words[3].substr(0, row.words[3].find('|'));  // static | dynamic
            std::string more = present(*section, row, {"EI", "CL"});
            if (plain.words[3] != row.words[3]) more += (more.empty() ? "" : ", ") + fmt::format("EA {}", row.words[3]);
            if (!more.empty())
                remarks.push_back(
                    fmt::format("{}:{}: line type {} has {}, which is not modelled: lines bend freely and have "
                                "their static EA",
                                file.file(), row.line, row.words[0], more));
            found[row.words[0]] = {file.number(row, 1, "the diameter"), file.number(row, 2, "the mass"),
                                   file.number(plain, 3, "EA")};
        }
    }
    return found;
}

/// Parts that the lines are made of, and which of them lines use.
struct Parts {
    std::map<std::string, Type> types;
    std::map<std::string, Point> points;
    MooringFileOptions options;
    std::set<std::string> used_types{};
    std::set<std::string> used_points{};
};

/// An anchor lies on the bottom, which floes takes as flat there.
void look_at_depth(const MooringSections& file, const Line& line, const MooringFileOptions& options,
                   std::vector<std::string>& remarks) {
    if (!options.depth || !(*options.depth > 0)) return;
    const double depth = line.hanging.depth;
    constexpr double rounding = 0.01;
    if (std::abs(depth - *options.depth) <= rounding * *options.depth) return;
    const std::string what =
        fmt::format("has its anchor {:g} m deep, in water of {:g} m by the options", depth, *options.depth);
    if (depth > *options.depth) throw file.wrong(line.row, "{}; which of the two is right?", what);
    remarks.push_back(fmt::format("{}:{}: {}: the bottom is taken at the anchor", file.file(), line.row.line, what));
}

Line line_of(const MooringSections& file, const MooringSection& section, const MooringRow& row, Parts& parts) {
    const auto column = [&](std::initializer_list<const char*> names) {
        const std::optional<std::size_t> found = column_of(section, names);
        if (!found) throw InputError("{}: the section of lines has no column {}", file.file(), *names.begin());
        return *found;
    };
    const std::size_t from = column({"ATTACHA", "NODEANCH", "NODEA", "ENDA"});
    const std::size_t to = column({"ATTACHB", "NODEFAIR", "NODEB", "ENDB"});
    const std::size_t length = column({"UNSTRLEN", "LENGTH"});
    file.refuse_other_unit(section, length, "m");
    if (row.words.size() <= std::max({from, to, length})) throw file.wrong(row, "is no line: words are missing");
    const auto type = parts.types.find(row.words[1]);
    if (type == parts.types.end()) throw file.wrong(row, "has no line type {} above it", row.words[1]);
    const auto a = parts.points.find(row.words[from]);
    const auto b = parts.points.find(row.words[to]);
    if (a == parts.points.end() || b == parts.points.end())
        throw file.wrong(row, "ends at {} and {}, of which one is no point above it", row.words[from], row.words[to]);
    if (a->second.anchor == b->second.anchor)
        throw file.wrong(row, "goes from {0} to {0}", a->second.anchor ? "anchor" : "fairlead");
    const auto& [anchor, fairlead] = a->second.anchor ? std::tie(*a, *b) : std::tie(*b, *a);
    const Vec3 way = anchor.second.place - fairlead.second.place;
    const double area = std::numbers::pi / 4 * type->second.diameter * type->second.diameter;
    const double weight = parts.options.gravity * (type->second.mass - parts.options.density * area);
    if (!(weight > 0)) throw file.wrong(row, "floats: it weighs {:.4g} N/m in water", weight);
    parts.used_types.insert(type->first);
    parts.used_points.insert({a->first, b->first});
    return {{.fairlead = fairlead.second.place,
             .azimuth = std::atan2(way.z(), way.x()),
             .distance = std::hypot(way.x(), way.z()),
             .depth = -anchor.second.place.y(),
             .cable = {file.number(row, length, "the length"), weight, type->second.stiffness, parts.options.friction}},
            fairlead.first,
            row};
}

/// FAILURE: number, point, lines, time, tension. One line that breaks at its fairlead above a tension is a break load.
void take_failures(const MooringSections& file, std::vector<Line>& lines) {
    GivenOnce<std::string, double> once;
    for (const MooringSection* section : file.all("failures")) {
        file.refuse_other_unit(*section, 3, "s");
        file.refuse_other_unit(*section, 4, "N");
        for (const MooringRow& row : section->rows) {
            const double time = file.number(row, 3, "the time of failure");
            const double tension = file.number(row, 4, "the tension of failure");
            if (time > 0) throw file.wrong(row, "has a failure at {:g} s; lines fail by their tension here", time);
            if (!(tension > 0)) continue;
            const auto line = std::ranges::find(lines, row.words[2], [](const Line& one) { return one.row.words[0]; });
            if (line == lines.end() || line->fairlead != row.words[1])
                throw file.wrong(row,
                                 "has the failure of {} at point {}; one line that breaks at its own fairlead is read",
                                 row.words[2], row.words[1]);
            if (const auto other = once.other_line(row.words[2], tension, row.line))
                throw file.wrong(row, "has line {} fail at another tension than line {} of the file", row.words[2],
                                 *other);
            line->hanging.break_load = tension;
        }
    }
}

/// What a configuration would say of it.
void refuse_as_configuration(const MooringSections& file, const Line& line) {
    Contradictions found;
    check_hanging(line.hanging, fmt::format("{}:{}: line {}", file.file(), line.row.line, line.row.words[0]), found);
    if (!found.empty()) throw InputError(found.front().sentence);
}

/// Sections that say something and are not read.
void name_other_sections(const MooringSections& file, std::vector<std::string>& remarks) {
    constexpr auto silent = std::to_array<std::string_view>(
        {"types", "points", "lines", "options", "failures", "rod types", "outputs", "title", "end"});
    for (const MooringSection& section : file.sections())
        if (!section.rows.empty() && std::ranges::find(silent, section.name) == silent.end())
            remarks.push_back(
                fmt::format("{}:{}: the section {} is not modelled", file.file(), section.line, section.title));
}

void refuse(const MooringSections& file, const std::string& name, const char* why) {
    for (const MooringSection* section : file.all(name))
        if (!section->rows.empty()) throw file.wrong(section->rows.front(), "{}", why);
}

}  // namespace

MooringFile read_moorings(std::string_view text, const std::string& name, double density, double gravity) {
    const MooringSections file(text, name);
    refuse(file, "rods", "has rods, and lines alone are read");
    refuse(file, "bodies", "has bodies, and one vessel alone is read");
    MooringFile found;
    std::vector<std::string>& remarks = found.remarks;
    Parts parts{types_of(file, remarks), points_of(file, remarks), mooring_options(file, density, gravity, remarks)};
    std::vector<Line> lines;
    Once once;
    std::set<std::string> seen;
    for (const MooringSection* section : file.need("lines")) {
        for (const MooringRow& row : section->rows) {
            refuse_another(file, once, row, "line");
            if (!seen.insert(row.words[0]).second) continue;
            if (row.words.size() < 2) throw file.wrong(row, "is no line: words are missing");
            lines.push_back(line_of(file, *section, row, parts));
            look_at_depth(file, lines.back(), parts.options, remarks);
        }
    }
    if (lines.empty()) throw InputError("{}: has no lines", name);
    for (const auto& [number, point] : parts.points)
        if (!parts.used_points.contains(number))
            throw InputError("{}: no line ends at point {}; was a line lost? Leave out a point that holds none", name,
                             number);
    take_failures(file, lines);
    name_other_sections(file, remarks);
    std::size_t break_loads = 0;
    for (const Line& line : lines) {
        refuse_as_configuration(file, line);
        found.lines.push_back(line.hanging);
        break_loads += line.hanging.break_load > 0 ? 1 : 0;
    }
    found.extent = fmt::format(
        "{}, {} of {} line types, {} points; density {:g} kg/m³, gravity {:g} m/s², friction {:g}, {}; lines "
        "hang at "
        "rest, without their damping, drag and added mass",
        counted(std::ssize(lines), "line"), parts.used_types.size(), parts.types.size(), parts.points.size(),
        parts.options.density, parts.options.gravity, parts.options.friction,
        break_loads == 0 ? "no break loads" : counted(static_cast<std::int64_t>(break_loads), "break load"));
    return found;
}

}  // namespace floes
