#include "simulation/lee.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/state_archive.hpp"

namespace floes {

/// Steps from one look to the next; ice of the tank moves by less than its draught in them.
constexpr int steps_apart = 10;

/// What lets through more than this of form drag is no shelter.
constexpr double open_water = 0.99;

/// Ice that stands steeper, by the cosine of its tilt, has no lee.
constexpr double steepest = 0.1;

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
    seen_.resize(bodies_.size());
    const auto places = static_cast<std::size_t>(ice.places());
    bays_.clear();
    for (std::size_t i = 0; i < places; ++i) bays_.push_back(is_convex(floes.shape(i).corners()) ? 0 : 1);
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
    for (std::size_t sheet = states.size(); sheet < bodies_.size(); ++sheet)
        seen_[sheet] = seen(sheet, sheet_states_[sheet - states.size()]);
    for (int place = 0; place < ice.places(); ++place) {
        if (!ice.is_there(place)) continue;
        see(place, ice, states);
        order_.push_back(place);
        largest_ = std::max(largest_, circles_[static_cast<std::size_t>(place)].radius);
    }
    std::ranges::sort(order_, {},
                      [&](int place) { return std::pair(circles_[static_cast<std::size_t>(place)].x, place); });
    for (const int place : order_)
        if (!sleeping.rests(place)) look(place, ice, states);
}

Lee::Seen Lee::seen(std::size_t body, const BodyState& state) const {
    const Mat3& r = state.rotation;
    const double level = r(0, 0) * r(2, 2) - r(0, 2) * r(2, 0);
    return {.x = state.position.x(),
            .z = state.position.z(),
            .into = {r(2, 2) / level, -r(0, 2) / level, -r(2, 0) / level, r(0, 0) / level},
            .radius = std::abs(level) > steepest ? bodies_[body].radius : -1,
            .low = state.position.y() - bodies_[body].half_thickness,
            .high = std::min(state.position.y() + bodies_[body].half_thickness, 0.0)};
}

/// Where the elements of a floe are, and the circle round them.
void Lee::see(int place, const IceField& ice, std::span<const BodyState> states) {
    const double count = ice.elements(place);
    Circle& circle = circles_[static_cast<std::size_t>(place)] = {};
    for (const std::size_t i : ice.indices(place)) {
        seen_[i] = seen(i, states[i]);
        circle.x += seen_[i].x / count;
        circle.z += seen_[i].z / count;
    }
    for (const std::size_t i : ice.indices(place)) {
        const double x = seen_[i].x - circle.x;
        const double z = seen_[i].z - circle.z;
        circle.radius = std::max(circle.radius, std::sqrt(x * x + z * z) + bodies_[i].radius);
    }
}

/// Places of the floes that may be ahead of some edge of this one's: itself among them if it is broken or has bays.
void Lee::find_near(int place, bool itself, double reach) {
    const auto circle = [&](int one) -> const Circle& { return circles_[static_cast<std::size_t>(one)]; };
    const Circle& own = circle(place);
    const double farthest = own.radius + reach + largest_;
    near_.clear();
    auto other = std::ranges::lower_bound(order_, own.x - farthest, {}, [&](int one) { return circle(one).x; });
    for (; other != order_.end() && circle(*other).x <= own.x + farthest; ++other) {
        const double x = circle(*other).x - own.x;
        const double z = circle(*other).z - own.z;
        const double near = own.radius + reach + circle(*other).radius;
        if (x * x + z * z <= near * near && (itself || *other != place)) near_.push_back(*other);
    }
}

void Lee::look_from(int place, const IceField& ice, std::span<const BodyState> states) {
    if (!shelters() || due_) return;
    for (const std::size_t i : ice.indices(place)) seen_[i] = seen(i, states[i]);
    look(place, ice, states);
}

void Lee::look(int place, const IceField& ice, std::span<const BodyState> states) {
    const bool itself = ice.is_broken(place) || bays_[static_cast<std::size_t>(place)] != 0;
    find_near(place, itself, reach(bodies_[ice.indices(place).front()]));
    for (const std::size_t i : ice.indices(place)) {
        for (std::uint32_t left = ice.elements()[i].exposed_edges; left != 0; left &= left - 1) {
            const auto edge = static_cast<std::size_t>(std::countr_zero(left));
            ahead_[bodies_[i].first_edge + edge] = ahead_of(i, edge, ice, states[i]);
        }
    }
}

Lee::Ahead Lee::ahead_of(std::size_t element, std::size_t edge, const IceField& ice, const BodyState& state) const {
    const Body& own = bodies_[element];
    const auto& [middle, normal] = edges_[own.first_edge + edge];
    const Mat3& r = state.rotation;
    const Vec3 begin = state.position + r * Vec3(middle.x, 0, middle.z);
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
    const auto elements = ice.elements().size();
    const auto last = static_cast<std::size_t>(ahead_[own.first_edge + edge].body);
    if (last < elements && ice.is_there(ice.elements()[last].floe)) meet(ray, last);
    for (std::size_t sheet = elements; sheet < bodies_.size(); ++sheet) meet(ray, sheet);
    for (const int place : near_) {
        const Circle& circle = circles_[static_cast<std::size_t>(place)];
        const double x = circle.x - ray.x;
        const double z = circle.z - ray.z;
        const double ahead = x * ray.along_x + z * ray.along_z;
        const double aside = x * ray.along_z - z * ray.along_x;
        if (std::abs(aside) > circle.radius || ahead - circle.radius > ray.distance || ahead + circle.radius < 0)
            continue;
        for (const std::size_t i : ice.indices(place))
            if (i != element) meet(ray, i);
    }
    if (ray.body < 0) return {};
    return {ray.body, std::sqrt(-std::expm1(-ray.distance / ray.fading))};
}

/// The ray ends at a body that shelters it better than what it has met before.
void Lee::meet(Ray& ray, std::size_t body) const {
    const Seen& other = seen_[body];
    const double x = other.x - ray.x;
    const double z = other.z - ray.z;
    const double ahead = x * ray.along_x + z * ray.along_z;
    const double aside = x * ray.along_z - z * ray.along_x;
    if (std::abs(aside) > other.radius || ahead - other.radius > ray.distance || ahead + other.radius < 0) return;
    const auto in_plane = [&](double of_x, double of_z) {
        return Corner{other.into[0] * of_x + other.into[1] * of_z, other.into[2] * of_x + other.into[3] * of_z};
    };
    const Corner middle = in_plane(x, z);
    const Corner along = in_plane(ray.along_x, ray.along_z);
    double enters = -std::numeric_limits<double>::infinity();
    double leaves = std::numeric_limits<double>::infinity();
    const auto first = edges_.begin() + static_cast<std::ptrdiff_t>(bodies_[body].first_edge);
    for (const PlanEdge& edge : std::span(first, bodies_[body].edges)) {
        const double within = dot(edge.middle + middle, edge.normal);
        const double outwards = dot(along, edge.normal);
        if (outwards < 0)
            enters = std::max(enters, within / outwards);
        else if (outwards > 0)
            leaves = std::min(leaves, within / outwards);
        else if (within < 0)
            return;
    }
    if (!(enters < leaves) || leaves <= 0) return;
    const double common = std::min(ray.high, other.high) - std::max(ray.low, other.low);
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
        const auto body = static_cast<std::size_t>(ahead.body);
        const BodyState& other = body < states.size() ? states[body] : sheet_states_[body - states.size()];
        const Corner& normal = edges_[first + edge].normal;
        const Vec3 out = states[element].rotation * Vec3(normal.x, 0, normal.z);
        found_[edge] = {ahead.open, (1 - ahead.open) * other.velocity.dot(out)};
    }
    return found_;
}

void Lee::archive(StateArchive& state) {
    auto& [draughts, water_density, sheets, sheet_states, bodies, edges, ahead, seen, circles, bays, order, near,
           largest, found, due] = *this;
    state(sheet_states, ahead, seen, circles, order, largest, due);
}

}  // namespace floes
