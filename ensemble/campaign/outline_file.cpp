// The only door from GeoJSON (RFC 7946, and the member "crs" of its predecessor).

#include "campaign/outline_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/lost_digits.hpp"
#include "campaign/shared_area.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "keys/csv.hpp"
#include "shapes/elements.hpp"

namespace floes {

namespace {

using Json = nlohmann::json;

constexpr std::string_view kinds = "Polygon, MultiPolygon, Feature, FeatureCollection and GeometryCollection";
constexpr int deepest = 16;         // collections within collections
constexpr int deepest_value = 100;  // of any JSON; a coordinate of the above lies less deep

/// The name of the file's reference system; empty without one.
std::string reference_system(const Json& object) {
    for (const Json::json_pointer& path :
         {"/crs/properties/name"_json_pointer, "/crs/properties/code"_json_pointer, "/coordRefSys"_json_pointer})
        if (object.contains(path) && !object.at(path).is_structured())
            return object.at(path).is_string() ? object.at(path).get<std::string>() : object.at(path).dump();
    return "";
}

/// Whether a code of EPSG is that of a projection with true lengths in metres, of those that maps of ice are in: UTM
/// zones, polar maps, and Canada's, Greenland's and Finland's.
bool is_in_metres(const std::string& code) {
    struct Range {
        int first, last;
    };
    constexpr std::array known{Range{3031, 3032},   Range{3035, 3035},   Range{3067, 3067},   Range{3178, 3189},
                               Range{3347, 3348},   Range{3408, 3413},   Range{3571, 3576},   Range{3973, 3976},
                               Range{3978, 3979},   Range{3995, 3996},   Range{5041, 5042},   Range{5921, 5940},
                               Range{6931, 6932},   Range{25828, 25838}, Range{26701, 26722}, Range{26901, 26923},
                               Range{32201, 32260}, Range{32301, 32360}, Range{32601, 32661}, Range{32701, 32761}};
    int number = 0;
    const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), number);
    return error == std::errc{} && end == code.data() + code.size() &&
           std::ranges::any_of(known,
                               [&](const Range& range) { return range.first <= number && number <= range.last; });
}

/// By the name of the reference system of the file, or of an object in it, at `file`.
void refuse_other_systems(const Json& object, const std::string& file) {
    const std::string system = reference_system(object);
    for (const char* member : {"crs", "coordRefSys"})
        if (const auto found = object.find(member); system.empty() && found != object.end() && !found->is_null())
            throw InputError(
                "{}: its reference system is not known, since {} has no name in it: {}; name it, as EPSG:32633, or, if "
                "its places are lengths, take it out of the file and give shapes.unit",
                file, member, beginning(found->dump(-1, ' ', true), 100));
    const auto number =
        std::ranges::find_if_not(system.rbegin(), system.rend(), [](unsigned char c) { return std::isdigit(c) != 0; });
    const std::string code(number.base(), system.end());
    constexpr std::array geographic{"84", "4326", "4979", "4258", "4269", "4267"};
    constexpr std::array mercator{"3857", "900913", "3785", "102100"};
    if (std::ranges::find(geographic, code) != geographic.end())
        throw InputError(
            "{}: its reference system {} is in degrees of longitude and latitude; project it to lengths first, such as "
            "the UTM zone of the picture",
            file, system);
    if (std::ranges::find(mercator, code) != mercator.end())
        throw InputError(
            "{}: its reference system {} is the Mercator projection of web maps, in which lengths are too long by one "
            "over the cosine of the latitude; project it to true lengths first, such as the UTM zone of the picture",
            file, system);
    if (!system.empty() && !is_in_metres(code))
        throw InputError(
            "{}: its reference system {} is none that is known here to have lengths in metres, which UTM zones "
            "(EPSG:326.., 327.., 258.., 269..) and polar maps (EPSG:3413, 3995, 3996, 3031) have; project it to one of "
            "these, or, if its places are lengths, take the system out of the file and give shapes.unit",
            file, system);
}

class Reader {
  public:
    explicit Reader(std::string file) : file_(std::move(file)) {}

    void take(const Json& object, const std::string& where, const std::string& name, int depth) {
        const std::string type = type_of(object, where);
        refuse_other_systems(object, where);
        if (depth > deepest) throw InputError("{}: collections lie {} deep; flatten them", where, depth);
        if (type == "FeatureCollection") {
            take_each(object, "features", "feature", where, name, depth);
        } else if (type == "GeometryCollection") {
            take_each(object, "geometries", "geometry", where, name, depth);
        } else if (type == "Feature") {
            const auto geometry = object.find("geometry");
            if (geometry == object.end() || geometry->is_null())
                throw InputError("{}: this feature has no geometry; leave it out", where);
            take(*geometry, where, name_of(object), depth + 1);
        } else if (type == "Polygon") {
            take_polygon(coordinates(object, where), where, name);
        } else if (type == "MultiPolygon") {
            const Json& polygons = coordinates(object, where);
            for (std::size_t k = 0; k < polygons.size(); ++k)
                take_polygon(polygons[k], fmt::format("{}, polygon {}", where, k + 1),
                             name.empty() || polygons.size() == 1 ? name : fmt::format("{} part {}", name, k + 1));
        } else {
            throw InputError("{}: a {} encloses no ice; floes are read from {}", where, type, kinds);
        }
    }

    std::vector<TracedFloe> floes() && { return std::move(floes_); }

  private:
    static std::string type_of(const Json& object, const std::string& where) {
        const auto type = object.is_object() ? object.find("type") : object.end();
        if (!object.is_object() || type == object.end() || !type->is_string())
            throw InputError("{}: this is no GeoJSON, which has a \"type\"; allowed: {}", where, kinds);
        return type->get<std::string>();
    }

    void take_each(const Json& object, const char* member, const char* each, const std::string& where,
                   const std::string& name, int depth) {
        const auto list = object.find(member);
        if (list == object.end() || !list->is_array())
            throw InputError("{}: this collection has no list of {}", where, member);
        for (std::size_t k = 0; k < list->size(); ++k)
            take((*list)[k], fmt::format("{}, {} {}", where, each, k + 1), name, depth + 1);
    }

    static std::string text_of(const Json& value) {
        if (value.is_string()) return value.get<std::string>();
        return value.is_number() ? value.dump() : "";
    }

    static std::string name_of(const Json& feature) {
        if (const auto id = feature.find("id"); id != feature.end()) return text_of(*id);
        const auto properties = feature.find("properties");
        if (properties == feature.end() || !properties->is_object()) return "";
        for (const char* key : {"floe", "name"})
            if (const auto found = properties->find(key); found != properties->end()) return text_of(*found);
        return "";
    }

    static const Json& coordinates(const Json& object, const std::string& where) {
        const auto found = object.find("coordinates");
        if (found == object.end() || !found->is_array() || found->empty())
            throw InputError("{}: it has no coordinates", where);
        return *found;
    }

    static Corner corner_of(const Json& position, const std::string& where, std::size_t number) {
        if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number())
            throw InputError("{}: place {} of the ring is none; write [x, y]", where, number);
        return {position[0].get<double>(), 0.0 - position[1].get<double>()};
    }

    Outline ring_of(const Json& ring, const std::string& where) {
        if (!ring.is_array() || ring.size() < 4)
            throw InputError("{}: a ring has at least 4 places, the last being the first again; this one has {}", where,
                             ring.is_array() ? ring.size() : 0);
        Outline corners;
        for (const Json& position : ring) {
            corners.push_back(corner_of(position, where, corners.size() + 1));
            if (++corners_ > most_file_corners)
                throw InputError("{}: the file has more than {} corners; simplify its outlines", file_,
                                 most_file_corners);
        }
        if (corners.front() != corners.back())
            throw InputError(
                "{}: the ring is not closed: it begins at ({:.9g}, {:.9g}) and ends at ({:.9g}, {:.9g}); let it end "
                "where it begins",
                where, corners.front().x, 0.0 - corners.front().z, corners.back().x, 0.0 - corners.back().z);
        corners.pop_back();
        return corners;
    }

    void take_polygon(const Json& rings, const std::string& where, const std::string& name) {
        if (!rings.is_array() || rings.empty()) throw InputError("{}: it has no coordinates", where);
        TracedFloe floe{name, where, ring_of(rings[0], where), {}};
        for (std::size_t k = 1; k < rings.size(); ++k)
            floe.holes.push_back(ring_of(rings[k], fmt::format("{}, hole {}", where, k)));
        floes_.push_back(std::move(floe));
        if (floes_.size() > most_outlines)
            throw InputError("{}: the file has more than {} outlines; take a part of it", file_, most_outlines);
    }

    std::string file_;
    std::vector<TracedFloe> floes_;
    std::size_t corners_ = 0;
};

/// Floes of a GeoJSON text: polygons, multipolygons (each polygon a floe), and features or collections of such. A
/// floe's name is its feature's id, or else the property "floe" or "name". Throws InputError, beginning with `file`:
/// what is no such text, other geometries, rings that are not closed, and coordinates that are degrees or no lengths by
/// the file's own reference system.
std::vector<TracedFloe> read_geojson(const std::string& text, const std::string& file) {
    // What lies deeper would take a hundred bytes of memory for each bracket.
    const auto shallow = [&](int depth, Json::parse_event_t, Json&) {
        if (depth > deepest_value) throw InputError("{}: this is no GeoJSON: it is too deep", file);
        return true;
    };
    Json object;
    try {
        object = Json::parse(text, shallow);
    } catch (const Json::exception& error) {
        const std::string_view what = error.what();
        throw InputError("{}: this is no JSON: {}", file, beginning(what.substr(what.find("] ") + 2), 160));
    }
    Reader reader(file);
    reader.take(object, file, "", 0);
    return std::move(reader).floes();
}

double finite_number(const std::string& cell, const std::string& where) {
    if (const std::optional<double> number = number_in(cell)) return *number;
    throw InputError("{}: {:?} is not a finite number", where, beginning(cell, 40));
}

/// Where all floes end as they begin, the last one with fewer corners shows that the file was cut off.
void refuse_open_end(const std::vector<TracedFloe>& floes) {
    const auto is_closed = [](const TracedFloe& one) {
        return one.ring.size() > 3 && one.ring.front() == one.ring.back();
    };
    if (floes.size() < 2 || std::ranges::find_if_not(floes, is_closed) != floes.end() - 1) return;
    throw InputError(
        "{}: floe {} does not end at the corner with which it begins, as all others do; was the file cut off? Close it "
        "too, or none",
        floes.back().where, floes.back().name);
}

/// Floes of a CSV text: the header floe,x,y, and a line for each corner; lines of a floe follow one another. Throws
/// InputError, beginning with file and line.
std::vector<TracedFloe> read_outline_csv(const std::string& text, const std::string& file) {
    const std::vector<CsvLine> lines = csv_lines(text, file);
    if (lines.empty()) throw InputError("{}: the file is empty; write floe,x,y and a line for each corner", file);
    if (lines.front().cells != std::vector<std::string>{"floe", "x", "y"})
        throw InputError(
            "{}:{}: {:?} is not the header of a file of outlines; write floe,x,y and below it a line for each corner",
            file, lines.front().number, beginning(joined(lines.front()), 60));
    std::vector<TracedFloe> floes;
    std::set<std::string> names;
    std::size_t corners = 0;
    for (const CsvLine& line : std::span(lines).subspan(1)) {
        const std::string where = fmt::format("{}:{}", file, line.number);
        const std::vector<std::string>& cells = line.cells;
        if (cells.size() != 3 || cells[0].empty())
            throw InputError("{}: {:?} is not a corner; write the floe's name, x and y", where,
                             beginning(joined(line), 60));
        const Corner corner{finite_number(cells[1], where), 0.0 - finite_number(cells[2], where)};
        if (floes.empty() || floes.back().name != cells[0]) {
            const std::string& name = cells[0];
            if (!names.insert(name).second)
                throw InputError(
                    "{}: floe {} comes again after another one; keep the corners of a floe together, and give each "
                    "floe a name of its own",
                    where, name);
            if (floes.size() == most_outlines)
                throw InputError("{}: the file has more than {} outlines; take a part of it", where, most_outlines);
            floes.push_back({name, where, {}, {}});
        }
        if (++corners > most_file_corners)
            throw InputError("{}: the file has more than {} corners; simplify its outlines", where, most_file_corners);
        floes.back().ring.push_back(corner);
    }
    refuse_open_end(floes);
    return floes;
}

constexpr double smallest_map = 0.01;  // m, of all outlines together
constexpr double largest_map = 1e5;

std::vector<TracedFloe> floes_of(const std::string& text, const std::string& file) {
    const bool csv = has_ending(file, ".csv");
    if (!csv && !has_ending(file, ".geojson") && !has_ending(file, ".json"))
        throw InputError("{}: outlines are read from .geojson, .json and .csv files; export one of these", file);
    if (text.size() > longest_outline_file)
        throw InputError("{}: this file has {} bytes, more than {}; simplify its outlines, or take a part of it", file,
                         text.size(), longest_outline_file);
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) throw InputError("{}: the file is empty", file);
    std::vector<TracedFloe> floes = csv ? read_outline_csv(text, file) : read_geojson(text, file);
    if (floes.empty()) throw InputError("{}: the file has no outlines", file);
    return floes;
}

/// The ring without corners that lie on the one before.
Outline ring_of(const Outline& corners, const std::string& where) {
    Outline ring = corners;
    ring.erase(std::ranges::unique(ring).begin(), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() > most_ring_corners)
        throw InputError("{}: the outline has {} corners, more than {}; simplify it", where, ring.size(),
                         most_ring_corners);
    if (const auto fault = ring_fault_of(ring)) throw InputError("{}: {}; trace it anew", where, *fault);
    return ring;
}

/// What the file says covers, in its unit.
double area_of(const TracedFloe& floe) {
    double area = std::abs(floes::area_of(floe.ring));
    for (const Outline& hole : floe.holes) area -= std::abs(floes::area_of(hole));
    if (!(area > 0)) throw InputError("{}: its holes leave nothing of it", floe.where);
    return area;
}

void refuse_doubles(const std::vector<TracedFloe>& floes) {
    std::map<std::string, const TracedFloe*> named;
    for (const TracedFloe& one : floes) {
        if (one.name.empty()) continue;
        const auto [found, is_new] = named.try_emplace(one.name, &one);
        if (!is_new)
            throw InputError(
                "{}: floe {} is there already ({}); was it traced twice? Give each floe a name of its own, or none a "
                "name",
                one.where, one.name, found->second->where);
    }
}

/// How wide a floe is that lies across the date line, where longitudes jump from 180 to -180; nothing of another.
std::optional<double> width_across_date_line(const Outline& ring) {
    constexpr double widest = 10;  // degrees
    double east = -180;
    double west = 180;
    for (const Corner& one : ring) {
        if (!(std::abs(one.x) <= 180)) return std::nullopt;
        (one.x > 0 ? west : east) = one.x > 0 ? std::min(west, one.x) : std::max(east, one.x);
    }
    const double width = (180 - west) + (east + 180);
    const auto [low, high] = std::ranges::minmax(ring, {}, &Corner::x);
    return low.x < 0 && high.x > 0 && width < widest ? std::optional(width) : std::nullopt;
}

/// Floes of some metres are some 1e-5 degrees wide, and no file in lengths has floes as small beside its coordinates.
void refuse_degrees(const std::vector<TracedFloe>& floes, const Box2& bounds, const std::string& file) {
    constexpr double widest = 0.1;  // degrees, of one floe: 11 km
    double size = 0;
    bool across = false;
    for (const TracedFloe& one : floes) {
        const std::optional<double> width = width_across_date_line(one.ring);
        across = across || width;
        size = std::max({size, width.value_or(size_of(one.ring).x), size_of(one.ring).z});
    }
    const double most = across ? std::numeric_limits<double>::infinity() : widest;
    const Vec2& low = bounds.min();
    const Vec2& high = bounds.max();
    if (size > most || low.x() < -180 || high.x() > 360 || low.y() < -90 || high.y() > 90) return;
    throw InputError(
        "{}: its coordinates look like degrees of longitude and latitude: the largest floe is {:.3g} across{}, and all "
        "lie within x = {:.6g} to {:.6g} and y = {:.6g} to {:.6g}; project them to lengths first, such as the UTM zone "
        "of the picture, or, if they are lengths, write them in a smaller unit with shapes.unit",
        file, size, across ? " over the date line" : "", low.x(), high.x(), 0.0 - high.y(), 0.0 - low.y());
}

/// Two standard deviations of the area over it, where each corner is rounded to steps along x and z.
double area_off(const Outline& ring, const Corner& step) {
    double variance = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Corner beside = after(ring, (k + 1) % ring.size()) - ring[k];  // of the corner between, times 1/2
        variance += (std::pow(step.x * beside.z, 2) + std::pow(step.z * beside.x, 2)) / 48;
    }
    return 2 * std::sqrt(variance) / std::abs(floes::area_of(ring));
}

/// Of coordinates far from the origin, in single precision or in so many digits, little is left of a floe.
void refuse_lost_digits(const std::vector<TracedFloe>& floes) {
    constexpr double most_off = 0.1;  // what filled holes may add by default (shapes.most_added_percent)
    std::vector<double> along;
    std::vector<double> aside;
    for (const TracedFloe& one : floes) {
        for (const Corner& corner : one.ring) {
            along.push_back(corner.x);
            aside.push_back(corner.z);
        }
    }
    const auto step_of = [](const std::vector<double>& numbers) {
        return std::max(single_precision_step(numbers), decimal_step(numbers));
    };
    const Corner step{step_of(along), step_of(aside)};
    const auto worst =
        std::ranges::max_element(floes, {}, [&](const TracedFloe& one) { return area_off(one.ring, step); });
    const double off = area_off(worst->ring, step);
    if (off <= most_off) return;
    const auto multiples = [](double one, const char* axis) {
        return one > 0 ? fmt::format("in {} all are multiples of {:.4g}", axis, one) : std::string();
    };
    throw InputError(
        "{}: the coordinates of this file lost their last digits: {}{}{}, so that the area of this floe may be off by "
        "{:.2g} %; export them with all digits, or with an origin near the floes",
        worst->where, multiples(step.x, "x"), step.x > 0 && step.z > 0 ? ", " : "", multiples(step.z, "y"), 100 * off);
}

/// With as many corners as a floe may have. Bays of less than a hundredth of the area are closed.
Outline outline_of(Outline ring) {
    constexpr double least_bay = 0.01;
    if (floes::area_of(ring) < 0) std::ranges::reverse(ring);
    Outline hull = convex_hull(ring);
    if (floes::area_of(hull) <= (1 + least_bay) * floes::area_of(ring))
        return with_fewer_corners(hull, most_outline_corners);
    Outline fewer = with_fewer_corners(ring, most_bayed_corners);
    return is_convex(fewer) ? with_fewer_corners(fewer, most_outline_corners) : fewer;
}

/// The names of all floes, divided by commas; empty if none has one.
std::string names_of(const std::vector<TracedFloe>& floes) {
    if (std::ranges::all_of(floes, &std::string::empty, &TracedFloe::name)) return "";
    std::string names;
    for (std::size_t i = 0; i < floes.size(); ++i) {
        std::string name = floes[i].name.empty() ? fmt::format("{}", i + 1) : floes[i].name;
        std::ranges::replace_if(
            name, [](unsigned char c) { return c == ',' || c < ' '; }, ' ');
        names += (i > 0 ? ", " : "") + name;
    }
    return names;
}

}  // namespace

void take_outlines(TracedOutlines& traced, const std::string& text, const std::string& file) {
    std::vector<TracedFloe> floes = floes_of(text, file);
    refuse_doubles(floes);
    Box2 bounds;
    for (TracedFloe& one : floes) {
        one.ring = ring_of(one.ring, one.where);
        for (Outline& hole : one.holes) hole = ring_of(hole, one.where + ", a hole");
        bounds.extend(box_round(one.ring));
    }
    refuse_degrees(floes, bounds, file);
    refuse_lost_digits(floes);
    const double unit = metres(traced.unit);
    const double size = unit * bounds.sizes().maxCoeff();
    if (!(size > smallest_map && size < largest_map))
        throw InputError("{}: the outlines reach over {:.4g} m, which is no field of ice; is shapes.unit right?", file,
                         size);
    Box2 of_floes;  // which reach a little farther where they have fewer corners
    const Corner low{bounds.min().x(), bounds.min().y()};
    std::vector<Outline> outlines;
    std::vector<double> areas;
    for (const TracedFloe& one : floes) {
        areas.push_back(unit * unit * area_of(one));
        Outline placed;
        for (const Corner& corner : one.ring) placed.push_back(unit * (corner - low));
        outlines.push_back(outline_of(std::move(placed)));
        of_floes.extend(box_round(outlines.back()));
    }
    refuse_shared_area(floes, file);
    const Corner origin{of_floes.min().x(), of_floes.center().y()};
    for (Outline& one : outlines)
        for (Corner& corner : one) corner = corner - origin;
    traced.outlines = std::move(outlines);
    traced.areas = std::move(areas);
    traced.names = names_of(floes);
    traced.path.clear();
    traced.unit = LengthUnit::m;
}

}  // namespace floes
