#include "simulation/lee.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace floes {

namespace {

/// Steps from one look to the next; ice of the tank moves by less than half its draught in them.
constexpr int steps_apart = 5;

/// What lets through more than this of form drag is no shelter.
constexpr double open_water = 0.99;

/// Ice that stands steeper, by the cosine of its tilt, has no lee.
constexpr double steepest = 0.1;

}  // namespace

/// From the middle of an edge, seen from above.
struct Lee::Ray {
    double x, z;              ///< where it begins
    double along_x, along_z;  ///< its direction, of length 1
    double low, high;         ///< heights between which the edge is in the water
    double fading;            ///< n H, m
    double distance;          ///< D - n H ln h of the best so far, m
    std::int32_t body = -1;   ///< which that is
};

Lee::Lee(const Scenario& scenario, const Channel& channel, const FloeSet& floes, const IceField& ice)
    : draughts_(scenario.water.shelter_draughts),
      water_density_(scenario.water.density),
      sheets_(channel.sheets),
      sheet_states_(channel.sheets.size()),
      found_(most_corners) {
    for (std::size_t i = 0; i < sheets_.size(); ++i) sheet_states_[i].position = sheets_[i].centre;
    measure(floes, ice);
}

void Lee::measure(const FloeSet& floes, const IceField& ice) {
    if (!shelters()) return;
    bodies_.clear();
    edges_.clear();
    for (const IceElement& element : ice.elements()) {
        const auto floe = static_cast<std::size_t>(element.floe);
        const double thickness = floes.shape(floe).thickness;
        add_body(ice.cut_element(element).corners, thickness,
                 thickness * floes.material(floe).ice.density / water_density_);
    }
    for (const IceSheet& sheet : sheets_)
        add_body(corners_of(sheet.half_extents.x(), sheet.half_extents.z()), 2 * sheet.half_extents.y(), 0);
    ahead_.assign(edges_.size(), {});
    const auto places = static_cast<std::size_t>(ice.places());
    circles_.resize(places);
    order_.reserve(places);
    near_.reserve(places);
    distrust();
}

void Lee::add_body(const Outline& corners, double thickness, double draught) {
    bodies_.push_back({edges_.size(), corners.size(), reach_of(corners), thickness / 2, draught});
    for (std::size_t k = 0; k < corners.size(); ++k)
        edges_.push_back({0.5 * (corners[k] + after(corners, k)), outward(corners, k)});
}

/// How far ahead of an edge ice shelters it, m.
double Lee::reach(const Body& body) const {
    return -draughts_ * body.draught * std::log(1 - open_water);
}

void Lee::follow(int step, const IceField& ice, std::span<const BodyState> states,
                 const std::vector<SheetMotion>& sheets, const SleepingFloes& sleeping) {
    if (!shelters()) return;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        sheet_states_[i].position = sheets_[i].centre + sheets[i].way * sheets_[i].inwards;
        sheet_states_[i].velocity = sheets[i].speed * sheets_[i].inwards;
    }
    if (!due_ && step % steps_apart != 0) return;
    due_ = false;
    order_.clear();
    largest_ = 0;
    for (int place = 0; place < ice.places(); ++place) {
        if (!ice.is_there(place)) continue;
        const Circle& circle = circles_[static_cast<std::size_t>(place)] = circle_of(place, ice, states);
        order_.push_back(place);
        largest_ = std::max(largest_, circle.radius);
    }
    std::ranges::sort(order_, {},
                      [&](int place) { return std::pair(circles_[static_cast<std::size_t>(place)].x, place); });
    for (const int place : order_)
        if (!sleeping.rests(place)) look_from(place, ice, states);
}

Lee::Circle Lee::circle_of(int place, const IceField& ice, std::span<const BodyState> states) const {
    const auto first = static_cast<std::size_t>(ice.first_element(place));
    const auto count = static_cast<std::size_t>(ice.elements(place));
    Circle circle;
    for (std::size_t i = first; i < first + count; ++i) {
        circle.x += states[i].position.x() / static_cast<double>(count);
        circle.z += states[i].position.z() / static_cast<double>(count);
    }
    for (std::size_t i = first; i < first + count; ++i) {
        const double x = states[i].position.x() - circle.x;
        const double z = states[i].position.z() - circle.z;
        circle.radius = std::max(circle.radius, std::sqrt(x * x + z * z) + bodies_[i].radius);
    }
    return circle;
}

/// Places of the floes that may be ahead of some edge of this one's, itself among them.
void Lee::find_near(int place, double reach) {
    const auto circle = [&](int one) -> const Circle& { return circles_[static_cast<std::size_t>(one)]; };
    const Circle& own = circle(place);
    const double farthest = own.radius + reach + largest_;
    near_.clear();
    auto other = std::ranges::lower_bound(order_, own.x - farthest, {}, [&](int one) { return circle(one).x; });
    for (; other != order_.end() && circle(*other).x <= own.x + farthest; ++other) {
        const double x = circle(*other).x - own.x;
        const double z = circle(*other).z - own.z;
        const double near = own.radius + reach + circle(*other).radius;
        if (x * x + z * z <= near * near) near_.push_back(*other);
    }
}

void Lee::look_from(int place, const IceField& ice, std::span<const BodyState> states) {
    if (!shelters() || due_) return;
    const auto first = static_cast<std::size_t>(ice.first_element(place));
    find_near(place, reach(bodies_[first]));
    for (std::size_t i = first; i < first + static_cast<std::size_t>(ice.elements(place)); ++i) {
        for (std::uint32_t left = ice.elements()[i].exposed_edges; left != 0; left &= left - 1) {
            const auto edge = static_cast<std::size_t>(std::countr_zero(left));
            ahead_[bodies_[i].first_edge + edge] = ahead_of(i, edge, ice, states);
        }
    }
}

Lee::Ahead Lee::ahead_of(std::size_t element, std::size_t edge, const IceField& ice,
                         std::span<const BodyState> states) const {
    const Body& own = bodies_[element];
    const auto& [middle, normal] = edges_[own.first_edge + edge];
    const Mat3& r = states[element].rotation;
    const Vec3 begin = states[element].position + r * Vec3(middle.x, 0, middle.z);
    const Vec3 out = r * Vec3(normal.x, 0, normal.z);
    const double level = std::sqrt(out.x() * out.x() + out.z() * out.z());
    Ray ray{.x = begin.x(),
            .z = begin.z(),
            .along_x = out.x() / level,
            .along_z = out.z() / level,
            .low = begin.y() - own.half_thickness,
            .high = std::min(begin.y() + own.half_thickness, 0.0),
            .fading = draughts_ * own.draught,
            .distance = reach(own)};
    if (!(level > steepest) || ray.low >= ray.high) return {};
    // First whatever was ahead last, which leaves most of the others out of the question.
    const auto last = static_cast<std::size_t>(ahead_[own.first_edge + edge].body);
    if (last < states.size() && ice.is_there(ice.elements()[last].floe)) meet(ray, last, states);
    for (std::size_t sheet = states.size(); sheet < bodies_.size(); ++sheet) meet(ray, sheet, states);
    for (const int place : near_) {
        const Circle& circle = circles_[static_cast<std::size_t>(place)];
        const double x = circle.x - ray.x;
        const double z = circle.z - ray.z;
        const double ahead = x * ray.along_x + z * ray.along_z;
        const double aside = x * ray.along_z - z * ray.along_x;
        if (std::abs(aside) > circle.radius || ahead - circle.radius > ray.distance || ahead + circle.radius < 0)
            continue;
        const auto first = static_cast<std::size_t>(ice.first_element(place));
        for (std::size_t i = first; i < first + static_cast<std::size_t>(ice.elements(place)); ++i)
            if (i != element) meet(ray, i, states);
    }
    if (ray.body < 0) return {};
    return {ray.body, std::sqrt(-std::expm1(-ray.distance / ray.fading))};
}

/// The ray ends at a body that shelters it better than what it has met before.
void Lee::meet(Ray& ray, std::size_t body, std::span<const BodyState> states) const {
    const Body& other = bodies_[body];
    const BodyState& state = state_of(body, states);
    const double x = state.position.x() - ray.x;
    const double z = state.position.z() - ray.z;
    const double ahead = x * ray.along_x + z * ray.along_z;
    const double aside = x * ray.along_z - z * ray.along_x;
    if (std::abs(aside) > other.radius || ahead - other.radius > ray.distance || ahead + other.radius < 0) return;
    // In the plane of the body, where its own axes have the components (a, b) of a level vector.
    const Mat3& r = state.rotation;
    const double level = r(0, 0) * r(2, 2) - r(0, 2) * r(2, 0);
    if (!(std::abs(level) > steepest)) return;
    const auto in_plane = [&](double of_x, double of_z) {
        return Corner{(r(2, 2) * of_x - r(0, 2) * of_z) / level, (r(0, 0) * of_z - r(2, 0) * of_x) / level};
    };
    const Corner middle = in_plane(x, z);
    const Corner along = in_plane(ray.along_x, ray.along_z);
    double enters = -std::numeric_limits<double>::infinity();
    double leaves = std::numeric_limits<double>::infinity();
    for (std::size_t k = other.first_edge; k < other.first_edge + other.edges; ++k) {
        const double within = dot(edges_[k].middle + middle, edges_[k].normal);
        const double outwards = dot(along, edges_[k].normal);
        if (outwards < 0)
            enters = std::max(enters, within / outwards);
        else if (outwards > 0)
            leaves = std::min(leaves, within / outwards);
        else if (within < 0)
            return;
    }
    if (!(enters < leaves) || leaves <= 0) return;
    const double common = std::min({ray.high, state.position.y() + other.half_thickness, 0.0}) -
                          std::max(ray.low, state.position.y() - other.half_thickness);
    if (!(common > 0)) return;
    const double distance = std::max(enters, 0.0) - ray.fading * std::log(common / (ray.high - ray.low));
    if (!(distance < ray.distance)) return;
    ray.distance = distance;
    ray.body = static_cast<std::int32_t>(body);
}

std::span<const EdgeShelter> Lee::of(std::size_t element, const IceField& ice, std::span<const BodyState> states) {
    if (!shelters()) return {};
    const std::size_t first = bodies_[element].first_edge;
    for (std::uint32_t left = ice.elements()[element].exposed_edges; left != 0; left &= left - 1) {
        const auto edge = static_cast<std::size_t>(std::countr_zero(left));
        const Ahead& ahead = ahead_[first + edge];
        found_[edge] = {};
        if (ahead.body < 0) continue;
        const Corner& normal = edges_[first + edge].normal;
        const Vec3 out = states[element].rotation * Vec3(normal.x, 0, normal.z);
        const Vec3& velocity = state_of(static_cast<std::size_t>(ahead.body), states).velocity;
        found_[edge] = {ahead.open, (1 - ahead.open) * velocity.dot(out)};
    }
    return found_;
}

}  // namespace floes
