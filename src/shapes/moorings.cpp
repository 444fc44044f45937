#include "shapes/moorings.hpp"

#include <Eigen/Eigenvalues>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/contract.hpp"
#include "core/error.hpp"

namespace floes {

namespace {

/// Where a function that rises is 0, above `low`; `guess` > 0 is the first width of the search.
template <class Rising>
double root_above(const Rising& f, double low, double guess) {
    double at_low = f(low);
    if (at_low >= 0) return low;
    double high = low + guess;
    double at_high = f(high);
    while (at_high < 0) {
        low = high;
        at_low = at_high;
        guess *= 4;
        high += guess;
        at_high = f(high);
    }
    if (at_high == 0) return high;
    std::uintmax_t most = 200;
    const auto enough = [](double a, double b) {
        return std::abs(b - a) <= 1e-13 * std::max(std::abs(a), std::abs(b));
    };
    const auto [from, to] = boost::math::tools::toms748_solve(f, low, high, at_low, at_high, enough, most);
    return 0.5 * (from + to);
}

double down_lying(const Cable& cable, double along, double z) {
    const double strain = cable.stiffness;
    const double tension =
        strain * (std::sqrt(1 + 2 * (along + cable.weight * z + along * along / (2 * strain)) / strain) - 1);
    return std::sqrt(std::max(0.0, (tension - along) * (tension + along)));
}

double down_hanging(const Cable& cable, double along, double z) {
    const double all = cable.weight * cable.length;
    const auto rise = [&](double down) {
        const double above = std::hypot(along, down);
        const double below = std::hypot(along, down - all);
        return (above - below) / cable.weight + cable.length / cable.stiffness * (down - 0.5 * all) - z;
    };
    return root_above(rise, 0.5 * all, all);  // at half of the weight both ends are level
}

double down(const Cable& cable, double along, double z) {
    const double lying = down_lying(cable, along, z);
    return lying <= cable.weight * cable.length ? lying : down_hanging(cable, along, z);
}

double reach(const Cable& cable, double along, double down) {
    const auto [length, weight, stiffness, friction] = cable;
    const double bow = along / weight;
    const double stretched = along * length / stiffness;
    const double resting = length - down / weight;
    if (resting < 0) return bow * (std::asinh(down / along) - std::asinh((down - weight * length) / along)) + stretched;
    double held = 0;
    if (friction > 0) {
        const double loose = resting - bow / friction;
        held = friction * weight / (2 * stiffness) * (loose * std::max(loose, 0.0) - resting * resting);
    }
    return resting + bow * std::asinh(down / along) + stretched + held;
}

}  // namespace

CablePull hang(const Cable& cable, double x, double z) {
    FLOES_EXPECTS(x >= 0 && z > 0 && cable.length > 0 && cable.weight > 0 && cable.stiffness > 0);
    const double all = cable.weight * cable.length;
    const double straight_down = down_lying(cable, 0, z);
    if (straight_down <= all && x <= cable.length - straight_down / cable.weight)
        return {0, straight_down, cable.length - straight_down / cable.weight, 0};
    const double least = 1e-9 * all;
    const double along =
        root_above([&](double pull) { return reach(cable, pull, down(cable, pull, z)) - x; }, least, all);
    const double found = down(cable, along, z);
    const double resting = std::max(0.0, cable.length - found / cable.weight);
    const double anchor =
        resting > 0 ? std::max(0.0, along - cable.friction * cable.weight * resting) : std::hypot(along, found - all);
    return {along, found, resting, anchor};
}

std::vector<Vec2> course(const Cable& cable, double x, double z, int parts) {
    const CablePull pull = hang(cable, x, z);
    const double hanging = cable.length - pull.resting;
    const double lowest = pull.down - cable.weight * hanging;  // V where it leaves the bottom, or at the anchor
    /// From there to the point `length` farther up.
    const auto from_below = [&](double length) {
        const double down = lowest + cable.weight * length;
        const double rise = (std::hypot(pull.along, down) - std::hypot(pull.along, lowest)) / cable.weight +
                            (down + lowest) / 2 * length / cable.stiffness;
        if (pull.along == 0) return Vec2(0, rise);
        return Vec2(pull.along / cable.weight * (std::asinh(down / pull.along) - std::asinh(lowest / pull.along)) +
                        pull.along * length / cable.stiffness,
                    rise);
    };
    const double leaves = x - from_below(hanging).x();
    std::vector<Vec2> points;
    for (int k = 0; k <= parts; ++k) {
        const double length = cable.length * (parts - k) / parts;
        if (length < pull.resting)
            points.emplace_back(leaves * length / pull.resting, 0);
        else
            points.emplace_back(Vec2(leaves, 0) + from_below(length - pull.resting));
    }
    return points;
}

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// On the curve. Before its first row a line is slack where that has no tension; past the rows nobody has said what is
/// pulled. Only a curve that `ends_at_break` goes straight on, for the step in which its line breaks.
double on_curve(const std::vector<TensionPoint>& curve, double extension, const char* key, bool ends_at_break = false) {
    if (extension <= curve.front().extension && curve.front().tension == 0) return 0;
    if (extension < curve.front().extension || (extension > curve.back().extension && !ends_at_break))
        throw MemberFailure("{} has rows from {:g} to {:g} m, and the structure came to {:g} m.", key,
                            curve.front().extension, curve.back().extension, extension);
    std::size_t next = 1;
    while (next + 1 < curve.size() && curve[next].extension < extension) ++next;
    const TensionPoint& a = curve[next - 1];
    const TensionPoint& b = curve[next];
    const double slope = (b.tension - a.tension) / (b.extension - a.extension);
    return std::max(0.0, a.tension + slope * (extension - a.extension));
}

/// Where the curve has the tension, m.
double extension_at(const std::vector<TensionPoint>& curve, double tension) {
    std::size_t next = 1;
    while (next + 1 < curve.size() && curve[next].tension < tension) ++next;
    const TensionPoint& a = curve[next - 1];
    const TensionPoint& b = curve[next];
    return a.extension + (tension - a.tension) * (b.extension - a.extension) / (b.tension - a.tension);
}

}  // namespace

std::vector<int> Moorings::directions() const {
    std::vector<int> found;
    for (std::size_t k = 0; k < free.size(); ++k)
        if (free.at(k)) found.push_back(static_cast<int>(k));
    return found;
}

Mat6 from_hydrodynamic_axes(const std::vector<std::vector<double>>& rows) {
    if (rows.empty()) return Mat6::Zero();
    struct Place {
        int row;
        double sign;
    };
    constexpr std::array<Place, 6> places{{{0, 1}, {1, -1}, {5, 1}, {2, 1}, {4, -1}, {3, 1}}};  // by Motion
    Mat6 found;
    for (int a = 0; a < 6; ++a) {
        for (int b = 0; b < 6; ++b) {
            const Place& of_a = places.at(static_cast<std::size_t>(a));
            const Place& of_b = places.at(static_cast<std::size_t>(b));
            found(a, b) =
                of_a.sign * of_b.sign * rows[static_cast<std::size_t>(of_a.row)][static_cast<std::size_t>(of_b.row)];
        }
    }
    return found;
}

Mat6 Moorings::inertia() const {
    const double raised = mass * height * height;
    Mat6 found = Mat6::Zero();
    found.diagonal() << mass, mass, mass * gyration * gyration, mass, mass * pitch_gyration * pitch_gyration + raised,
        mass * roll_gyration * roll_gyration + raised;
    // Of the centre's velocity: a pitch moves it by -height along x, a roll by height along z.
    found(at(Motion::surge), at(Motion::pitch)) = found(at(Motion::pitch), at(Motion::surge)) = -mass * height;
    found(at(Motion::sway), at(Motion::roll)) = found(at(Motion::roll), at(Motion::sway)) = mass * height;
    for (int k = 0; k < 6; ++k) found(k, k) += added.at(static_cast<std::size_t>(k));
    return added_mass.empty() ? found : Mat6(found + from_hydrodynamic_axes(added_mass));
}

Mat6 Moorings::radiation() const {
    return from_hydrodynamic_axes(radiation_damping);
}

namespace {

/// What a line at rest pulls less for an offset of each motion alone: far above rounding, far below what its direction
/// changes by.
Vec6 pulls_less(const auto& pull_at, double distance, int motion) {
    Vec6 aside = Vec6::Zero();
    aside[motion] = 1e-5 * (motion == 2 || motion > 3 ? 1.0 : distance);
    return -(pull_at(aside) - pull_at(-aside)) / (2 * aside[motion]);
}

/// A stiffness of what is moored to a turret, which holds the heading by the turret's arm alone: it goes aside as the
/// bow turns.
Mat6 by_turret(Mat6 stiffness, double ahead) {
    stiffness.col(at(Motion::yaw)) = -ahead * stiffness.col(at(Motion::sway));
    stiffness.row(at(Motion::yaw)) = -ahead * stiffness.row(at(Motion::sway));
    return stiffness;
}

}  // namespace

Mat6 Moorings::stiffness() const {
    Mat6 found = Mat6::Zero();
    found.diagonal().head<3>() << surge, sway, yaw;
    Mat6 by_lines = Mat6::Zero();
    for (const MooringLine& line : lines)
        for (int k = 0; k < 3; ++k)
            by_lines(k, k) +=
                pulls_less([&](const Vec6& offset) { return pull(*this, line, offset).force; }, line.distance, k)[k];
    for (const HangingLine& line : hanging)
        for (int k = 0; k < 6; ++k)
            by_lines.col(k) +=
                pulls_less([&](const Vec6& offset) { return pull(line, offset, turret).force; }, line.distance, k);
    found += turret.lines ? by_turret(by_lines, turret.ahead) : by_lines;
    if (!turret.curve.empty()) {
        const double slope = turret.curve.at(1).tension / turret.curve.at(1).extension;
        Mat6 plane = Mat6::Zero();
        plane.diagonal().head<2>().setConstant(slope);
        found += by_turret(plane, turret.ahead);
    }
    return found;
}

Mat6 Moorings::held(const Mat6& water) const {
    Mat6 found = water + stiffness();
    found.diagonal().head<3>() += thrusters.gain;
    return found;
}

double Moorings::period(Motion motion) const {
    const auto k = static_cast<int>(motion);
    const double stiff = held(Mat6::Zero())(k, k);
    return stiff > 0 ? 2 * std::numbers::pi * std::sqrt(inertia()(k, k) / stiff) : infinite;
}

std::vector<NaturalMode> natural_modes(const Moorings& moorings, const Mat6& water) {
    const std::vector<int> directions = moorings.directions();
    const auto even = [&](const Mat6& matrix) -> Eigen::MatrixXd {
        return Mat6(0.5 * (matrix + matrix.transpose()))(directions, directions);
    };
    const Eigen::MatrixXd stiffness = even(moorings.held(water));
    const Eigen::MatrixXd inertia = even(moorings.inertia());
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, inertia);
    std::vector<NaturalMode> modes;
    for (Eigen::Index mode = 0; mode < solver.eigenvalues().size(); ++mode) {
        const Eigen::VectorXd swing = solver.eigenvectors().col(mode);
        Eigen::Index most = 0;
        swing.cwiseProduct(inertia * swing).maxCoeff(&most);
        const double square = solver.eigenvalues()[mode];
        // What rounding leaves of nothing holds nothing.
        const bool nothing = std::abs(square) <= 1e-12 * solver.eigenvalues().cwiseAbs().maxCoeff();
        const bool turns = nothing && moorings.turret.any() && moorings.is_free(Motion::yaw);
        modes.push_back({nothing ? infinite : 2 * std::numbers::pi / std::sqrt(square),
                         turns ? Motion::yaw : static_cast<Motion>(directions[static_cast<std::size_t>(most)])});
    }
    std::ranges::stable_sort(modes, {}, &NaturalMode::motion);
    return modes;
}

std::optional<NaturalMode> longest_mode(const Moorings& moorings, const Mat6& water) {
    std::optional<NaturalMode> longest;
    for (const NaturalMode& mode : natural_modes(moorings, water))
        if (std::isfinite(mode.period) && (!longest || mode.period > longest->period)) longest = mode;
    return longest;
}

bool weathervanes(const Moorings& moorings, const NaturalMode& mode) {
    return std::isinf(mode.period) && mode.motion == Motion::yaw && moorings.turret.any() && moorings.turret.ahead > 0;
}

double tension(const Moorings& moorings, const MooringLine& line, double longer) {
    if (moorings.curve.empty()) return std::max(0.0, line.pretension + line.stiffness * longer);
    return on_curve(moorings.curve, extension_at(moorings.curve, line.pretension) + longer, "moorings.line_curve",
                    line.break_load > 0 && line.break_load <= moorings.curve.back().tension);
}

Vec2 turned(const Vec2& point, double yaw) {
    const double c = std::cos(yaw);
    const double s = std::sin(yaw);
    return {c * point.x() + s * point.y(), c * point.y() - s * point.x()};
}

double horizontal_offset(const Moorings& moorings, double surge, double sway, double yaw) {
    const Vec2 arm = turned({moorings.turret.ahead, 0}, yaw);
    return std::hypot(-surge + arm.x() - moorings.turret.ahead, sway + arm.y());
}

namespace {

/// A force in the plane of the water at an arm from the axis.
Vec6 at_the_water(const Vec2& force, const Vec2& arm) {
    return in_plane({force.x(), force.y(), arm.y() * force.x() - arm.x() * force.y()});
}

}  // namespace

Vec6 in_plane(const Vec3& of) {
    Vec6 found = Vec6::Zero();
    found.head<3>() = of;
    return found;
}

LinePull pull(const HangingLine& line, const Vec6& offset, const Turret& turret) {
    const StructurePose pose{
        .position = Vec3(offset[at(Motion::surge)], offset[at(Motion::heave)], offset[at(Motion::sway)]),
        .yaw = offset[at(Motion::yaw)],
        .pitch = offset[at(Motion::pitch)],
        .roll = offset[at(Motion::roll)]};
    const Vec3 axis(turret.lines ? turret.ahead : 0, 0, 0);
    const Vec3 at_axis = pose.orientation() * axis;
    // A turret heels and trims with the structure and keeps its heading.
    const Quat table =
        turret.lines ? pose.orientation() * turned_about_y(pose.yaw).conjugate() : Quat(pose.orientation());
    const Vec3 arm = at_axis + table * line.fairlead;
    const Vec3 lead(std::cos(line.azimuth), 0, std::sin(line.azimuth));
    LinePull found;
    found.fairlead = pose.position + arm;
    found.anchor = axis + line.fairlead + line.distance * lead;
    found.anchor.y() = -line.depth;
    const Vec2 way(found.anchor.x() - found.fairlead.x(), found.anchor.z() - found.fairlead.z());
    const double distance = way.norm();
    const double drop = found.fairlead.y() + line.depth;
    if (!(drop > 0)) throw MemberFailure("The fairlead of a mooring line has come down to the depth of its anchor.");
    const CablePull hangs = hang(line.cable, distance, drop);
    found.tension = hangs.tension();
    const Vec2 along = distance > 0 ? Vec2(hangs.along / distance * way) : Vec2(Vec2::Zero());
    const Vec3 force(along.x(), -hangs.down, along.y());
    Vec3 moment = arm.cross(force);
    if (turret.lines) moment.y() = at_axis.cross(force).y();  // its bearing passes no moment about its axis on
    const Vec3 own = turned_about_y(pose.yaw).conjugate() * moment;
    found.force << force.x(), force.z(), moment.y(), force.y(), own.z(), own.x();
    return found;
}

LinePull pull(const Moorings& moorings, std::size_t number, const Vec6& offset) {
    return number < moorings.lines.size()
               ? pull(moorings, moorings.lines[number], offset)
               : pull(moorings.hanging[number - moorings.lines.size()], offset, moorings.turret);
}

double break_load(const Moorings& moorings, std::size_t number) {
    const std::size_t weightless = moorings.lines.size();
    return number < weightless ? moorings.lines[number].break_load
                               : moorings.hanging.at(number - weightless).break_load;
}

bool has_lines_that_break(const Moorings& moorings) {
    for (std::size_t line = 0; line < moorings.line_count(); ++line)
        if (break_load(moorings, line) > 0) return true;
    return false;
}

std::vector<Vec3> course(const Moorings& moorings, std::size_t number, const Vec3& fairlead, const Vec3& anchor) {
    const Vec3 way = anchor - fairlead;
    const Vec3 level(way.x(), 0, way.z());
    if (number < moorings.lines.size() || !(way.y() < 0)) return {fairlead, anchor};
    const double distance = level.norm();
    constexpr int parts = 64;
    std::vector<Vec3> points;
    for (const Vec2& point :
         course(moorings.hanging[number - moorings.lines.size()].cable, distance, -way.y(), parts)) {
        const double share = distance > 0 ? 1 - point.x() / distance : 1;
        points.emplace_back(fairlead + share * level + Vec3(0, way.y() + point.y(), 0));
    }
    return points;
}

Vec6 turret_pull(const Moorings& moorings, const Vec6& offset) {
    if (moorings.turret.curve.empty()) return Vec6::Zero();
    const Vec2 arm = turned({moorings.turret.ahead, 0}, offset[2]);
    const Vec2 aside = Vec2(offset[0] - moorings.turret.ahead, offset[1]) + arm;
    const double distance = aside.norm();
    if (distance == 0) return Vec6::Zero();
    return at_the_water(-on_curve(moorings.turret.curve, distance, "moorings.turret_curve") / distance * aside, arm);
}

LinePull pull(const Moorings& moorings, const MooringLine& line, const Vec6& offset) {
    const Turret& turret = moorings.turret;
    const Vec2 axis(turret.ahead, 0);
    const Vec2 on_it(line.x, line.z);
    const Vec2 arm = turned(turret.lines ? axis : on_it, offset[2]);  // where the structure is pulled
    const Vec2 fairlead = Vec2(offset[0], offset[1]) + (turret.lines ? arm + on_it : arm);
    const Vec2 anchor =
        (turret.lines ? axis + on_it : on_it) + line.distance * Vec2(std::cos(line.azimuth), std::sin(line.azimuth));
    LinePull found;
    found.anchor = {anchor.x(), 0, anchor.y()};
    found.fairlead = {fairlead.x(), 0, fairlead.y()};
    const Vec2 way = anchor - fairlead;
    const double distance = way.norm();
    found.tension = tension(moorings, line, distance - line.distance);
    if (distance > 0) found.force = at_the_water(found.tension / distance * way, arm);
    return found;
}

ThrustLaw thrust_law(const Thrusters& thrusters, int direction, double inertia) {
    const double gain = thrusters.gain[direction];
    const double limit = thrusters.limit[direction];
    return {gain, 2 * thrusters.damping * std::sqrt(gain * inertia),
            limit > 0 ? limit : std::numeric_limits<double>::infinity()};
}

double thrust(const ThrustLaw& law, double offset, double velocity) {
    return -std::clamp(law.gain * offset + law.damping * velocity, -law.limit, law.limit);
}

double velocity_under_thrust(const ThrustLaw& law, double offset, double velocity, double inertia, double time) {
    if (law.damping == 0) return velocity + thrust(law, offset, velocity) / inertia * time;
    const double rate = law.damping / inertia;
    const double wanted = law.gain * offset + law.damping * velocity;
    const double above = std::max(0.0, std::abs(wanted) - law.limit);
    const double time_above = above > 0 ? std::min(time, above / (rate * law.limit)) : 0.0;
    const double linear = above > 0 ? std::abs(wanted) - rate * law.limit * time_above : std::abs(wanted);
    const double left = std::copysign(linear * std::exp(-rate * (time - time_above)), wanted);
    return velocity + (left - wanted) / law.damping;
}

}  // namespace floes
