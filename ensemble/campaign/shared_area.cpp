#include "campaign/shared_area.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"

namespace floes {

namespace {

/// Whoever encloses area: a floe with its holes, or a hole.
struct Enclosed {
    std::vector<Outline> rings;
    std::string label;
    Box2 box;
    double area = 0;

    Enclosed(std::vector<Outline> of, std::string called)
        : rings(std::move(of)), label(std::move(called)), box(box_round(rings.front())) {
        for (const Outline& ring : rings) area += (area == 0 ? 1 : -1) * std::abs(area_of(ring));
    }

    std::size_t corners() const {
        std::size_t sum = 0;
        for (const Outline& ring : rings) sum += ring.size();
        return sum;
    }
};

/// Where a line along x enters or leaves: bit 0 of it, of `of`; bit 1 of `other`.
void cross(std::vector<std::pair<double, unsigned>>& crossings, std::span<const Outline> rings, double z,
           unsigned bit) {
    for (const Outline& ring : rings) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Corner& a = ring[k];
            const Corner& b = after(ring, k);
            if ((a.z <= z) == (b.z <= z)) continue;
            crossings.emplace_back(a.x + (b.x - a.x) * ((z - a.z) / (b.z - a.z)), bit);
        }
    }
}

class SharedArea {
  public:
    explicit SharedArea(std::string file) : file_(std::move(file)) {}

    /// Of the smaller one; 0 without a look where their boxes share less than `least` of it.
    double share(const Enclosed& a, const Enclosed& b, double least) {
        const Vec2 common = a.box.intersection(b.box).sizes();
        const bool first = a.area < b.area;
        const Enclosed& smaller = first ? a : b;
        const Enclosed& larger = first ? b : a;
        if (!(common.x() > 0 && common.y() > 0 && common.x() * common.y() > least * smaller.area)) return 0;
        return within(smaller, larger);
    }

    double within(const Enclosed& of, const Enclosed& other) {
        constexpr std::size_t most_looked_at = 10'000'000;
        looked_at_ += of.corners() + other.corners();
        if (looked_at_ > most_looked_at)
            throw InputError(
                "{}: so many of its outlines or holes lie one over the other that they are no floes beside each other; "
                "take a part of it, or simplify it",
                file_);
        return share_within(of.rings, other.rings);
    }

  private:
    std::string file_;
    std::size_t looked_at_ = 0;  // corners
};

/// Of all pairs whose boxes meet along x that which shares more of the smaller than `most`, found first.
template <typename Refuse>
void look_at_pairs(const std::vector<Enclosed>& all, SharedArea& areas, double most, const Refuse& refuse) {
    std::vector<std::size_t> order(all.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return all[k].box.min().x(); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const double end = all[order[i]].box.max().x();
        for (std::size_t k = i + 1; k < order.size() && all[order[k]].box.min().x() < end; ++k) {
            const auto [first, second] = std::minmax(order[i], order[k]);
            const double share = areas.share(all[first], all[second], most);
            if (share > most) refuse(all[first], all[second], share);
        }
    }
}

void refuse_holes(const TracedFloe& floe, SharedArea& areas) {
    const Enclosed outside({floe.ring}, floe.where);
    std::vector<Enclosed> holes;
    for (const Outline& hole : floe.holes) {
        holes.emplace_back(std::vector<Outline>{hole}, fmt::format("{}, hole {}", floe.where, holes.size() + 1));
        const double beside = 1 - areas.within(holes.back(), outside);
        if (beside > most_beside)
            throw InputError(
                "{}: {:.3g} % of it lies outside of the floe, so it is no hole; move it inside, or make it a polygon "
                "of its own",
                holes.back().label, 100 * beside);
    }
    look_at_pairs(holes, areas, most_beside, [](const Enclosed& first, const Enclosed& second, double share) {
        throw InputError(
            "{}: it and another hole ({}) share {:.3g} % of the smaller, which would be taken off the floe twice; make "
            "one hole of the two",
            second.label, first.label, 100 * share);
    });
}

}  // namespace

double share_within(std::span<const Outline> of, std::span<const Outline> other) {
    constexpr int lines = 64;
    const auto [first, last] = std::ranges::minmax(of.front(), {}, &Corner::z);
    double own = 0;
    double shared = 0;
    std::vector<std::pair<double, unsigned>> crossings;
    for (int line = 0; line < lines; ++line) {
        const double z = first.z + (last.z - first.z) * (line + 0.5) / lines;
        crossings.clear();
        cross(crossings, of, z, 1);
        cross(crossings, other, z, 2);
        std::ranges::sort(crossings);
        unsigned in = 0;
        for (std::size_t k = 0; k + 1 < crossings.size(); ++k) {
            in ^= crossings[k].second;
            const double stretch = crossings[k + 1].first - crossings[k].first;
            if ((in & 1U) != 0) own += stretch;
            if (in == 3U) shared += stretch;
        }
    }
    return own > 0 ? shared / own : 0;
}

void refuse_shared_area(std::span<const TracedFloe> floes, const std::string& file) {
    SharedArea areas(file);
    std::vector<Enclosed> all;
    for (const TracedFloe& one : floes) {
        refuse_holes(one, areas);
        std::vector<Outline> rings{one.ring};
        rings.insert(rings.end(), one.holes.begin(), one.holes.end());
        all.emplace_back(std::move(rings), one.name.empty() ? one.where : fmt::format("{}: {}", one.where, one.name));
    }
    look_at_pairs(all, areas, most_shared, [](const Enclosed& first, const Enclosed& second, double share) {
        throw InputError(
            "{}: this floe and another one ({}) share {:.3g} % of the smaller one's area, so that the same ice would "
            "count twice; leave one of them out, or move it aside",
            second.label, first.label, 100 * share);
    });
}

}  // namespace floes
