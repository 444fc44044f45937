#pragma once
// Files as a CAD program writes them.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/vector.hpp"

namespace floes {

using Triangle3 = std::array<Vec3, 3>;

/// A prism over a polygon in (x, y), counter-clockwise, cut into the triangles given; z from 0 to `breadth`.
inline std::vector<Triangle3> prism(const std::vector<std::pair<double, double>>& polygon,
                                    const std::vector<std::array<std::size_t, 3>>& cut, double breadth) {
    const auto at = [&](std::size_t k, double z) {
        return Vec3(polygon[k % polygon.size()].first, polygon[k % polygon.size()].second, z);
    };
    std::vector<Triangle3> all;
    for (const auto& [a, b, c] : cut) {
        all.push_back({at(a, 0), at(c, 0), at(b, 0)});
        all.push_back({at(a, breadth), at(b, breadth), at(c, breadth)});
    }
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        all.push_back({at(k, 0), at(k + 1, 0), at(k + 1, breadth)});
        all.push_back({at(k, 0), at(k + 1, breadth), at(k, breadth)});
    }
    return all;
}

inline std::vector<Triangle3> box(const Vec3& low, const Vec3& high) {
    std::vector<Triangle3> all =
        prism({{low.x(), low.y()}, {high.x(), low.y()}, {high.x(), high.y()}, {low.x(), high.y()}},
              {{0, 1, 2}, {0, 2, 3}}, high.z() - low.z());
    for (Triangle3& one : all)
        for (Vec3& corner : one) corner.z() += low.z();
    return all;
}

/// An hourglass of radius 1 + y² from y = -1 to 1, which curves inwards all round.
inline std::vector<Triangle3> hourglass(int sides, int rings) {
    const auto at = [&](int ring, int side) {
        const double y = -1 + 2.0 * ring / rings;
        const double angle = 2 * std::numbers::pi * (side % sides) / sides;
        return Vec3((1 + y * y) * std::cos(angle), y, (1 + y * y) * std::sin(angle));
    };
    std::vector<Triangle3> all;
    for (int s = 0; s < sides; ++s) {
        all.push_back({Vec3(0, -1, 0), at(0, s), at(0, s + 1)});
        all.push_back({Vec3(0, 1, 0), at(rings, s + 1), at(rings, s)});
        for (int r = 0; r < rings; ++r) {
            all.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
            all.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
        }
    }
    return all;
}

inline std::string stl_text(const std::vector<std::pair<std::string, std::vector<Triangle3>>>& solids) {
    std::string text;
    for (const auto& [name, triangles] : solids) {
        text += fmt::format("solid {}\n", name);
        for (const Triangle3& one : triangles) {
            const Vec3 n = (one[1] - one[0]).cross(one[2] - one[0]).normalized();
            text += fmt::format("facet normal {} {} {}\n outer loop\n", n.x(), n.y(), n.z());
            for (const Vec3& corner : one)
                text += fmt::format("  vertex {} {} {}\n", corner.x(), corner.y(), corner.z());
            text += " endloop\nendfacet\n";
        }
        text += fmt::format("endsolid {}\n", name);
    }
    return text;
}

inline std::string stl_bytes(const std::vector<Triangle3>& triangles) {
    std::string bytes(80, ' ');
    const auto put = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
    put(static_cast<std::uint32_t>(triangles.size()));
    for (const Triangle3& one : triangles) {
        const Vec3 n = (one[1] - one[0]).cross(one[2] - one[0]).normalized();
        for (const double value : n) put(static_cast<float>(value));
        for (const Vec3& corner : one)
            for (const double value : corner) put(static_cast<float>(value));
        put(std::uint16_t{0});
    }
    return bytes;
}

/// Each group a patch of triangles.
inline std::string obj_text(const std::vector<std::pair<std::string, std::vector<Triangle3>>>& groups) {
    std::string text;
    int point = 0;
    for (const auto& [name, triangles] : groups) {
        text += fmt::format("g {}\n", name);
        for (const Triangle3& one : triangles) {
            for (const Vec3& corner : one) text += fmt::format("v {} {} {}\n", corner.x(), corner.y(), corner.z());
            text += fmt::format("f {} {} {}\n", point + 1, point + 2, point + 3);
            point += 3;
        }
    }
    return text;
}

}  // namespace floes
