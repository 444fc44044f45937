// Hulls and traced floes.

#include <cmath>

#include "campaign/drawn.hpp"
#include "campaign/hull_file.hpp"
#include "campaign/outline_file.hpp"
#include "readers/example.hpp"

namespace floes::test {

namespace {

Numbers hull_numbers(const std::string& text, const std::string& file) {
    Structure structure;
    take_hull(structure, text, file);
    Numbers found{structure.hull_file.volume};
    for (const std::vector<double>& row : structure.shape.piece_rows())
        found.insert(found.end(), row.begin(), row.end());
    return found;
}

/// A box half in the water: z up, as CAD programs have it.
std::vector<Triangle3> afloat() {
    return box({-6.5, -2.5, -1.5}, {6.5, 2.5, 1.25});
}

std::string numbers(const Vec3& point) {
    return fmt::format("{:.3f} {:.3f} {:.3f}", point.x(), point.y(), point.z());
}

Example stl() {
    Lines lines{"solid barge"};
    for (const Triangle3& one : afloat())
        lines.push_back(
            fmt::format("facet normal 0.0 0.0 0.0 outer loop vertex {} vertex {} vertex {} endloop endfacet",
                        numbers(one[0]), numbers(one[1]), numbers(one[2])));
    const std::size_t rows = lines.size() - 1;
    lines.push_back("endsolid barge");
    return {.name = "STL in letters",
            .file = "barge.stl",
            .lines = std::move(lines),
            .first = 1,
            .rows = rows,
            .read = [](const std::string& text) { return hull_numbers(text, "barge.stl"); },
            .outcomes = "=======xxx-xx"};
}

Example obj() {
    Lines lines{"o barge"};
    const std::vector<Triangle3> triangles = afloat();
    for (const Triangle3& one : triangles)
        for (const Vec3& corner : one) lines.push_back("v " + numbers(corner));
    const std::size_t first = lines.size();
    for (std::size_t k = 0; k < triangles.size(); ++k)
        lines.push_back(fmt::format("f {} {} {}", 3 * k + 1, 3 * k + 2, 3 * k + 3));
    return {.name = "OBJ",
            .file = "barge.obj",
            .lines = std::move(lines),
            .first = first,
            .rows = triangles.size(),
            .read = [](const std::string& text) { return hull_numbers(text, "barge.obj"); },
            .outcomes = "=======-xx-xx"};
}

Numbers outline_numbers(const std::string& text, const std::string& file) {
    TracedOutlines traced;
    traced.path = file;
    take_outlines(traced, text, file);
    Numbers found = traced.areas;
    for (const Outline& outline : traced.outlines)
        for (const Corner& corner : outline) {
            found.push_back(std::abs(corner.x));
            found.push_back(std::abs(corner.z));
        }
    return found;
}

Example geojson() {
    const auto floe = [](double x, double y, double size) {
        return fmt::format(
            R"({{"type": "Feature", "properties": {{}}, "geometry": {{"type": "Polygon", "coordinates": )"
            "[[[{0:.2f}, {1:.2f}], [{2:.2f}, {1:.2f}], [{2:.2f}, {3:.2f}], [{0:.2f}, {1:.2f}]]]}}}}",
            x, y, x + size, y + 1.5 * size);
    };
    Lines lines{R"({"type": "FeatureCollection", "features": [)"};
    for (int k = 0; k < 4; ++k) lines.push_back(floe(20.5 * k, 3.25 * k, 10.5 + k) + ",");
    lines.push_back(floe(100.5, 3.25, 11.75) + "]}");
    return {.name = "GeoJSON of floes",
            .file = "floes.geojson",
            .lines = std::move(lines),
            .first = 1,
            .rows = 4,
            .read = [](const std::string& text) { return outline_numbers(text, "floes.geojson"); },
            .outcomes = "======xx?x-xx",
            .plus = false};
}

Example outlines_csv() {
    Lines lines{"floe,x,y"};
    for (int k = 0; k < 3; ++k) {
        const double x = 20.5 * k;
        for (const auto& [dx, dy] : {std::pair{0.0, 0.0}, {10.5, 0.0}, {10.5, 12.25}, {0.0, 12.25}})
            lines.push_back(fmt::format("{},{:.2f},{:.2f}", k + 1, x + dx, dy));
    }
    return {.name = "CSV of floes",
            .file = "floes.csv",
            .lines = std::move(lines),
            .read = [](const std::string& text) { return outline_numbers(text, "floes.csv"); },
            .outcomes = "=====------??"};
}

}  // namespace

std::vector<Example> shape_examples() {
    return {stl(), obj(), geojson(), outlines_csv()};
}

}  // namespace floes::test
