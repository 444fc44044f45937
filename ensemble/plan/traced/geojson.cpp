// The only door from GeoJSON (RFC 7946, and the member "crs" of its predecessor).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/error.hpp"
#include "core/utf8.hpp"
#include "traced/traced_file.hpp"

namespace floes {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kinds = "Polygon, MultiPolygon, Feature, FeatureCollection and GeometryCollection";
constexpr int deepest = 16;         // collections within collections
constexpr int deepest_value = 100;  // of any JSON; a coordinate of the above lies less deep

class Reader {
  public:
    explicit Reader(std::string file) : file_(std::move(file)) {}

    void take(const Json& object, const std::string& where, const std::string& name, int depth) {
        const std::string type = type_of(object, where);
        if (depth > deepest) throw InputError(fmt::format("{}: collections lie {} deep; flatten them", where, depth));
        if (type == "FeatureCollection") {
            take_each(object, "features", "feature", where, name, depth);
        } else if (type == "GeometryCollection") {
            take_each(object, "geometries", "geometry", where, name, depth);
        } else if (type == "Feature") {
            const auto geometry = object.find("geometry");
            if (geometry == object.end() || geometry->is_null())
                throw InputError(fmt::format("{}: this feature has no geometry; leave it out", where));
            take(*geometry, where, name_of(object), depth + 1);
        } else if (type == "Polygon") {
            take_polygon(coordinates(object, where), where, name);
        } else if (type == "MultiPolygon") {
            const Json& polygons = coordinates(object, where);
            for (std::size_t k = 0; k < polygons.size(); ++k)
                take_polygon(polygons[k], fmt::format("{}, polygon {}", where, k + 1),
                             name.empty() || polygons.size() == 1 ? name : fmt::format("{} part {}", name, k + 1));
        } else {
            throw InputError(fmt::format("{}: a {} encloses no ice; floes are read from {}", where, type, kinds));
        }
    }

    std::vector<TracedFloe> floes() && { return std::move(floes_); }

  private:
    static std::string type_of(const Json& object, const std::string& where) {
        const auto type = object.is_object() ? object.find("type") : object.end();
        if (!object.is_object() || type == object.end() || !type->is_string())
            throw InputError(fmt::format("{}: this is no GeoJSON, which has a \"type\"; allowed: {}", where, kinds));
        return type->get<std::string>();
    }

    void take_each(const Json& object, const char* member, const char* each, const std::string& where,
                   const std::string& name, int depth) {
        const auto list = object.find(member);
        if (list == object.end() || !list->is_array())
            throw InputError(fmt::format("{}: this collection has no list of {}", where, member));
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
            throw InputError(fmt::format("{}: it has no coordinates", where));
        return *found;
    }

    static Corner corner_of(const Json& position, const std::string& where, std::size_t number) {
        if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number())
            throw InputError(fmt::format("{}: place {} of the ring is none; write [x, y]", where, number));
        return {position[0].get<double>(), 0.0 - position[1].get<double>()};
    }

    Outline ring_of(const Json& ring, const std::string& where) {
        if (!ring.is_array() || ring.size() < 4)
            throw InputError(
                fmt::format("{}: a ring has at least 4 places, the last being the first again; this one "
                            "has {}",
                            where, ring.is_array() ? ring.size() : 0));
        Outline corners;
        for (const Json& position : ring) {
            corners.push_back(corner_of(position, where, corners.size() + 1));
            if (++corners_ > most_file_corners)
                throw InputError(fmt::format("{}: the file has more than {} corners; simplify its outlines", file_,
                                             most_file_corners));
        }
        if (corners.front() != corners.back())
            throw InputError(fmt::format(
                "{}: the ring is not closed: it begins at ({:.9g}, {:.9g}) and ends at "
                "({:.9g}, {:.9g}); let it end where it begins",
                where, corners.front().x, 0.0 - corners.front().z, corners.back().x, 0.0 - corners.back().z));
        corners.pop_back();
        return corners;
    }

    void take_polygon(const Json& rings, const std::string& where, const std::string& name) {
        if (!rings.is_array() || rings.empty()) throw InputError(fmt::format("{}: it has no coordinates", where));
        TracedFloe floe{name, where, ring_of(rings[0], where), {}};
        for (std::size_t k = 1; k < rings.size(); ++k)
            floe.holes.push_back(ring_of(rings[k], fmt::format("{}, hole {}", where, k)));
        floes_.push_back(std::move(floe));
        if (floes_.size() > most_outlines)
            throw InputError(
                fmt::format("{}: the file has more than {} outlines; take a part of it", file_, most_outlines));
    }

    std::string file_;
    std::vector<TracedFloe> floes_;
    std::size_t corners_ = 0;
};

/// The name of the file's reference system; empty without one.
std::string reference_system(const Json& object) {
    for (const Json::json_pointer& path :
         {"/crs/properties/name"_json_pointer, "/crs/properties/code"_json_pointer, "/coordRefSys"_json_pointer})
        if (object.contains(path) && !object.at(path).is_structured())
            return object.at(path).is_string() ? object.at(path).get<std::string>() : object.at(path).dump();
    return "";
}

void refuse_degrees(const Json& object, const std::string& file) {
    if (!object.is_object()) return;
    const std::string system = reference_system(object);
    const auto number =
        std::ranges::find_if_not(system.rbegin(), system.rend(), [](unsigned char c) { return std::isdigit(c) != 0; });
    const std::string code(number.base(), system.end());
    constexpr std::array geographic{"84", "4326", "4979", "4258", "4269", "4267"};
    constexpr std::array mercator{"3857", "900913", "3785", "102100"};
    if (std::ranges::find(geographic, code) != geographic.end())
        throw InputError(
            fmt::format("{}: its reference system {} is in degrees of longitude and latitude; project it "
                        "to lengths first, such as the UTM zone of the picture",
                        file, system));
    if (std::ranges::find(mercator, code) != mercator.end())
        throw InputError(
            fmt::format("{}: its reference system {} is the Mercator projection of web maps, in which "
                        "lengths are too long by one over the cosine of the latitude; project it to true "
                        "lengths first, such as the UTM zone of the picture",
                        file, system));
}

}  // namespace

std::vector<TracedFloe> read_geojson(const std::string& text, const std::string& file) {
    // What lies deeper would take a hundred bytes of memory for each bracket.
    const auto shallow = [&](int depth, Json::parse_event_t, Json&) {
        if (depth > deepest_value) throw InputError(fmt::format("{}: this is no GeoJSON: it is too deep", file));
        return true;
    };
    Json object;
    try {
        object = Json::parse(text, shallow);
    } catch (const Json::exception& error) {
        const std::string_view what = error.what();
        throw InputError(
            fmt::format("{}: this is no JSON: {}", file, beginning(what.substr(what.find("] ") + 2), 160)));
    }
    refuse_degrees(object, file);
    Reader reader(file);
    reader.take(object, file, "", 0);
    return std::move(reader).floes();
}

}  // namespace floes
