#include "campaign/closed_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace floes {

namespace {

using TriangleNumbers = std::vector<std::size_t>;

std::string place_text(const Vec3& at) {
    return fmt::format("({:.9g}, {:.9g}, {:.9g})", at.x(), at.y(), at.z());
}

/// The triangle on the left of each directed edge.
std::map<std::pair<int, int>, std::size_t> edge_owners(const Surface& surface, const TriangleNumbers& triangles,
                                                       const std::string& file) {
    std::map<std::pair<int, int>, std::size_t> owner;
    for (const std::size_t t : triangles) {
        for (std::size_t e = 0; e < 3; ++e) {
            const std::pair<int, int> edge{surface.triangles[t][e], surface.triangles[t][(e + 1) % 3]};
            if (owner.try_emplace(edge, t).second) continue;
            throw InputError(
                "{}: two triangles at {} have the same edge in the same direction, so the surface has no inside; let "
                "the CAD program unite its bodies and orient its faces",
                file, place_text(surface.corner(t, e)));
        }
    }
    std::size_t open = 0;
    const Vec3* at = nullptr;
    for (const auto& [edge, triangle] : owner) {
        if (owner.contains({edge.second, edge.first})) continue;
        ++open;
        at = &surface.points[static_cast<std::size_t>(edge.first)];
    }
    if (open > 0)
        throw InputError(
            "{}: the surface is open: {} edges have a triangle on one side only, one of them at {}; close it (a deck, "
            "a bottom, the middle plane of a half model), or let the CAD program sew it",
            file, open, place_text(*at));
    return owner;
}

/// Of each body, those that edges join.
std::vector<TriangleNumbers> joined_by_edges(const Surface& surface, const TriangleNumbers& triangles,
                                             const std::string& file) {
    const std::map<std::pair<int, int>, std::size_t> owner = edge_owners(surface, triangles, file);
    std::vector<bool> seen(surface.triangles.size());
    std::vector<TriangleNumbers> bodies;
    for (const std::size_t seed : triangles) {
        if (seen[seed]) continue;
        seen[seed] = true;
        TriangleNumbers& found = bodies.emplace_back(TriangleNumbers{seed});
        for (std::size_t k = 0; k < found.size(); ++k) {
            const auto& corners = surface.triangles[found[k]];
            for (std::size_t e = 0; e < 3; ++e) {
                const std::size_t next = owner.at({corners[(e + 1) % 3], corners[e]});
                if (seen[next]) continue;
                seen[next] = true;
                found.push_back(next);
            }
        }
    }
    return bodies;
}

/// Those of each solid, without those that it has already.
std::vector<TriangleNumbers> triangles_of_solids(const Surface& surface) {
    std::map<int, TriangleNumbers> solids;
    std::set<std::tuple<int, int, int, int>> known;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        std::array<int, 3> corners = surface.triangles[t];
        std::ranges::rotate(corners, std::ranges::min_element(corners));
        if (known.emplace(surface.solid[t], corners[0], corners[1], corners[2]).second)
            solids[surface.solid[t]].push_back(t);
    }
    std::vector<TriangleNumbers> found;
    for (auto& [number, triangles] : solids) found.push_back(std::move(triangles));
    return found;
}

Surface part_of(const Surface& surface, const TriangleNumbers& triangles) {
    Surface own;
    own.groups = surface.groups;
    std::map<int, int> numbers;
    for (const std::size_t t : triangles) {
        std::array<int, 3> corners = surface.triangles[t];
        for (int& corner : corners) {
            const auto [found, is_new] = numbers.try_emplace(corner, static_cast<int>(own.points.size()));
            if (is_new) own.points.push_back(surface.points[static_cast<std::size_t>(corner)]);
            corner = found->second;
        }
        own.triangles.push_back(corners);
        own.group.push_back(surface.group[t]);
        own.solid.push_back(surface.solid[t]);
    }
    return own;
}

/// By solids, each closed by itself, or all together, where solids are patches of bodies.
std::vector<TriangleNumbers> bodies_as_they_are(const Surface& surface, const std::string& file) {
    const std::vector<TriangleNumbers> solids = triangles_of_solids(surface);
    std::vector<TriangleNumbers> bodies;
    try {
        for (const TriangleNumbers& solid : solids)
            for (TriangleNumbers& one : joined_by_edges(surface, solid, file)) bodies.push_back(std::move(one));
        return bodies;
    } catch (const InputError&) {
        if (solids.size() == 1) throw;
    }
    TriangleNumbers all;
    for (const TriangleNumbers& solid : solids) all.insert(all.end(), solid.begin(), solid.end());
    return joined_by_edges(surface, all, file);
}

/// Outside is where the triangles look from.
std::vector<Surface> bodies_of(const Surface& surface, const std::string& file) {
    const std::vector<TriangleNumbers> numbers = bodies_as_they_are(surface, file);
    if (numbers.size() > most_bodies)
        throw InputError("{}: the file has {} bodies, more than the {} pieces of a hull; leave out what no ice meets",
                         file, numbers.size(), most_bodies);
    std::vector<Surface> bodies;
    for (const TriangleNumbers& triangles : numbers) {
        Surface& body = bodies.emplace_back(part_of(surface, triangles));
        if (volume_of(body) < 0)
            for (auto& corners : body.triangles) std::swap(corners[1], corners[2]);
    }
    return bodies;
}

/// Corners within `tolerance` of an earlier one become that one; what then has no area goes.
Surface welded(const Surface& surface, double tolerance) {
    using Cell = std::array<long long, 3>;
    const auto cell_of = [&](const Vec3& point) {
        return Cell{std::llround(point.x() / tolerance), std::llround(point.y() / tolerance),
                    std::llround(point.z() / tolerance)};
    };
    std::map<Cell, std::vector<int>> kept;
    const auto representative = [&](int number) {
        const Vec3& point = surface.points[static_cast<std::size_t>(number)];
        const Cell own = cell_of(point);
        for (int k = 0; k < 27; ++k) {
            const auto there = kept.find({own[0] + k % 3 - 1, own[1] + k / 3 % 3 - 1, own[2] + k / 9 - 1});
            if (there == kept.end()) continue;
            for (const int other : there->second)
                if ((surface.points[static_cast<std::size_t>(other)] - point).norm() <= tolerance) return other;
        }
        kept[own].push_back(number);
        return number;
    };
    std::vector<int> now(surface.points.size());
    for (std::size_t k = 0; k < now.size(); ++k) now[k] = representative(static_cast<int>(k));
    Surface found;
    found.points = surface.points;
    found.groups = surface.groups;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        std::array<int, 3> corners = surface.triangles[t];
        for (int& corner : corners) corner = now[static_cast<std::size_t>(corner)];
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
        found.triangles.push_back(corners);
        found.group.push_back(surface.group[t]);
        found.solid.push_back(surface.solid[t]);
    }
    return found;
}

std::vector<Surface> sewn_bodies(const Surface& surface, const std::string& file) {
    try {
        return bodies_of(surface, file);
    } catch (const InputError&) {
        // Programs round the corners of each triangle by itself: the last printed digit, or what sewing leaves.
        const double size = size_of(surface);
        for (const double share : welding) {
            try {
                return bodies_of(welded(surface, share * size), file);
            } catch (const InputError&) {  // by more, or not at all
            }
        }
        throw;
    }
}

// Which space lies in bodies other than once.

/// On lines along x: how much of them lies in none of the surfaces but between them, or in more than one.
struct WronglyCounted {
    double volume = 0;
    double longest = 0;      ///< stretch of a line
    Vec3 at = Vec3::Zero();  ///< its middle
};

class LinesAlongX {
  public:
    /// Through a box, in rows and columns.
    LinesAlongX(std::span<const Surface* const> bodies, const Box3& box)
        : bodies_(bodies), low_(box.min()), pitch_(box.sizes() / double{many}) {}

    WronglyCounted look() {
        for (int row = 0; row < many; ++row) {
            const double z = place(2, row);
            for (auto& one : crossings_) one.clear();
            for (const Surface* body : bodies_)
                for (std::size_t t = 0; t < body->triangles.size(); ++t) cross(*body, t, z);
            for (int column = 0; column < many; ++column) count(column, z);
        }
        return found_;
    }

  private:
    static constexpr int many = 64;
    static constexpr double beside = 0.4871;  // of a cell, so that no line goes through corners at round numbers

    double place(int axis, int cell) const { return low_[axis] + (cell + beside) * pitch_[axis]; }

    /// Twice the area of (a, b, the line) in y and z: with the other sign, to the bit, from b to a.
    static double side(const Surface& body, int a, int b, double y, double z) {
        if (a > b) return -side(body, b, a, y, z);
        const Vec3& p = body.points[static_cast<std::size_t>(a)];
        const Vec3& q = body.points[static_cast<std::size_t>(b)];
        return (p.y() - y) * (q.z() - z) - (p.z() - z) * (q.y() - y);
    }

    void cross(const Surface& body, std::size_t t, double z) {
        const auto [a, b, c] = body.triangles[t];
        double low = body.corner(t, 0).y();
        double high = low;
        bool below = false;
        bool above = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& corner = body.corner(t, k);
            low = std::min(low, corner.y());
            high = std::max(high, corner.y());
            below = below || corner.z() <= z;
            above = above || corner.z() >= z;
        }
        if (!below || !above || !(pitch_.y() > 0)) return;
        const auto cell = [&](double y) { return std::clamp((y - low_.y()) / pitch_.y() - beside, -1.0, many + 0.0); };
        for (int column = static_cast<int>(std::ceil(cell(low))); column <= static_cast<int>(cell(high)); ++column) {
            if (column < 0 || column >= many) continue;
            const double y = place(1, column);
            const double of_c = side(body, a, b, y, z);
            const double of_a = side(body, b, c, y, z);
            const double of_b = side(body, c, a, y, z);
            const auto left = [](double value, bool upwards) { return upwards ? value > 0 : value >= 0; };
            const int lefts = left(of_c, a < b) + left(of_a, b < c) + left(of_b, c < a);
            const double sum = of_a + of_b + of_c;
            if ((lefts != 0 && lefts != 3) || sum == 0) continue;
            const double x =
                (of_a * body.corner(t, 0).x() + of_b * body.corner(t, 1).x() + of_c * body.corner(t, 2).x()) / sum;
            crossings_[static_cast<std::size_t>(column)].emplace_back(x, lefts == 3 ? -1 : 1);
        }
    }

    void count(int column, double z) {
        auto& line = crossings_[static_cast<std::size_t>(column)];
        int within = 0;
        for (const auto& [x, turn] : line) within += turn;
        if (within != 0) return;  // it grazes a corner
        std::ranges::sort(line);
        double wrong = 0;
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
            within += line[k].second;
            const double stretch = line[k + 1].first - line[k].first;
            if (within == 0 || within == 1) continue;
            wrong += stretch;
            if (stretch <= found_.longest) continue;
            found_.longest = stretch;
            found_.at = {0.5 * (line[k].first + line[k + 1].first), place(1, column), z};
        }
        found_.volume += wrong * pitch_.y() * pitch_.z();
    }

    std::span<const Surface* const> bodies_;
    Vec3 low_;
    Vec3 pitch_;
    std::array<std::vector<std::pair<double, int>>, many> crossings_;  // of a row: where, and whether into a body
    WronglyCounted found_;
};

std::string body_name(const std::vector<Surface>& bodies, std::size_t k) {
    const std::string& name = bodies[k].groups[static_cast<std::size_t>(bodies[k].group.front())];
    const bool named = name.find_first_not_of(' ') != std::string::npos;
    return named ? fmt::format("body {} {:?}", k + 1, name) : fmt::format("body {}", k + 1);
}

void refuse_crossed(const std::vector<Surface>& bodies, const std::string& file) {
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const std::array one{&bodies[k]};
        const WronglyCounted found = LinesAlongX(one, box_round(bodies[k].points)).look();
        const double share = found.volume / volume_of(bodies[k]);
        if (!(share > most_crossed)) continue;
        throw InputError(
            "{}: the surface of {} crosses itself near {}, so that {:.3g} % of it would count twice or be missing; is "
            "a corner at the wrong place? Let the CAD program unite its bodies",
            file, body_name(bodies, k), place_text(found.at), 100 * share);
    }
}

void refuse_shared_space(const std::vector<Surface>& bodies, const std::string& file) {
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        for (std::size_t i = 0; i < k; ++i) {
            const double smaller = std::min(volume_of(bodies[i]), volume_of(bodies[k]));
            const double larger = std::max(volume_of(bodies[i]), volume_of(bodies[k]));
            const Box3 both = box_round(bodies[i].points).intersection(box_round(bodies[k].points));
            if (both.isEmpty() || !(both.volume() > most_crossed * smaller)) continue;
            const std::array two{&bodies[i], &bodies[k]};
            const WronglyCounted found = LinesAlongX(two, both).look();
            const double share = found.volume / smaller;
            if (!(share > most_crossed)) continue;
            const std::string which = fmt::format("{}: {} and {}", file, body_name(bodies, i), body_name(bodies, k));
            if (share < 1 - most_crossed)
                throw InputError(
                    "{} overlap near {}: {:.3g} % of the smaller would count twice; let the CAD program unite them",
                    which, place_text(found.at), 100 * share);
            if (larger - smaller < most_crossed * larger)
                throw InputError("{} are the same body, near {}, which would count twice; leave one out", which,
                                 place_text(found.at));
            throw InputError(
                "{} lie one inside the other, near {}, as a hollow does; a hull is taken as solid, so leave the inner "
                "one out",
                which, place_text(found.at));
        }
    }
}

}  // namespace

std::vector<Surface> closed_bodies(const Surface& surface, const std::string& file) {
    std::vector<Surface> bodies = sewn_bodies(surface, file);
    std::erase_if(bodies, [](const Surface& one) { return !(volume_of(one) > 0); });
    if (bodies.empty()) throw InputError("{}: its surface encloses nothing; export a solid", file);
    refuse_crossed(bodies, file);
    refuse_shared_space(bodies, file);
    return bodies;
}

double volume_of(const Surface& body) {
    const Vec3& origin = body.corner(0, 0);
    double six = 0;
    for (std::size_t t = 0; t < body.triangles.size(); ++t)
        six += (body.corner(t, 0) - origin).dot((body.corner(t, 1) - origin).cross(body.corner(t, 2) - origin));
    return six / 6;
}

// Solid angles add up to 4 π inside and to 0 outside (Van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30, 1983,
// cited from memory).
bool encloses(const Surface& body, const Vec3& point) {
    double half = 0;
    for (std::size_t t = 0; t < body.triangles.size(); ++t) {
        const Vec3 a = body.corner(t, 0) - point;
        const Vec3 b = body.corner(t, 1) - point;
        const Vec3 c = body.corner(t, 2) - point;
        const double below =
            a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() + b.dot(c) * a.norm() + c.dot(a) * b.norm();
        half += std::atan2(a.dot(b.cross(c)), below);
    }
    return half > 3;  // of 2 π
}

double size_of(const Surface& surface) {
    return box_round(surface.points).diagonal().norm();
}

}  // namespace floes
