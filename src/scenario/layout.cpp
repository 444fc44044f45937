#include "scenario/layout.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "core/text.hpp"
#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"
#include "shapes/hydrostatics.hpp"

namespace floes {

namespace {

// The rules of docs/field.md in numbers.
constexpr double floes_before = 0.5;    // between the bow and the field's edge
constexpr double floes_of_entry = 2;    // behind the stern before it is steady
constexpr double periods_of_entry = 5;  // likewise
constexpr double folds_of_entry = 3;    // of e, by which damping has taken the swing before
constexpr double periods_of_window = 10;
constexpr double breadths_of_segment = 2;
constexpr double floes_of_segment = 5;
constexpr double breadths_beside = 1;
constexpr double floes_beside = 2;
constexpr double breadths_ahead = 2;
constexpr double floes_ahead = 3;
constexpr int usual_segments = 3;

// As far as the ranges of the keys reach.
constexpr double longest_time = 1e5;   // s
constexpr double widest = 1e4;         // m
constexpr double farthest_edge = 1e5;  // m

/// Upwards to two figures.
double rounded_up(double value) {
    if (!(value > 0)) return 0;
    const double digit = std::pow(10, std::floor(std::log10(value)) - 1);
    return to_digits(digit * std::ceil(value / digit - 1e-9), 2);
}

/// The words of the larger of two numbers.
std::string larger_of(double one, const std::string& one_words, double other, const std::string& other_words) {
    return one >= other ? one_words : other_words;
}

/// How far the hull reaches from its axis, m.
struct HullReach {
    double ahead = 0;
    double astern = 0;
    double aside = 0;
    double around = 0;       ///< in any direction
    double first_ahead = 0;  ///< along the tow, turned as it begins

    double breadth() const { return 2 * aside; }
    double length() const { return ahead + astern; }
};

/// `yaw`: with which it begins.
HullReach reach_of_hull(const Shape& shape, double yaw) {
    const double around = shape.largest_radius();
    if (shape.is_of_revolution()) return {around, around, around, around, around};
    HullReach reach{.around = around};
    for (const ConvexSolid& solid : shape.solids()) {
        for (const Vec3& corner : solid.corners(round_sides)) {
            reach.first_ahead = std::max(reach.first_ahead, std::cos(yaw) * corner.x() + std::sin(yaw) * corner.z());
            reach.ahead = std::max(reach.ahead, corner.x());
            reach.astern = std::max(reach.astern, -corner.x());
            reach.aside = std::max(reach.aside, std::abs(corner.z()));
        }
    }
    return reach;
}

struct FloeMeasures {
    double side = 0;      ///< the largest of any, m
    double diagonal = 0;  ///< likewise, m
    double mean = 0;      ///< side of the square of their mean area, m
    double area = 0;      ///< mean, m²
};

FloeMeasures measures_of_floes(const Scenario& scenario) {
    FloeMeasures floes;
    const std::vector<FloeShape> shapes = floe_sizes(scenario);
    for (const FloeShape& shape : shapes) {
        floes.side = std::max({floes.side, shape.length, shape.breadth});
        floes.diagonal = std::max(floes.diagonal, std::hypot(shape.length, shape.breadth));
        floes.area += shape.length * shape.breadth / static_cast<double>(shapes.size());
    }
    floes.mean = std::sqrt(floes.area);
    if (scenario.arrangement.level()) floes.side = floes.mean = scenario.characteristic_length();  // of what breaks off
    return floes;
}

/// The slowest swing of a moored hull that moorings end, not the load.
struct SlowestSwing {
    double period = 0;  ///< s; 0: it does not swing
    std::string_view motion;

    std::string words() const { return fmt::format("natural periods of {:.3g} s in {}", period, motion); }
};

SlowestSwing slowest_swing(const Scenario& scenario) {
    if (!scenario.moorings.give_way()) return {};
    Scenario alone = scenario;  // its moorings are to be without fault; what they meet is looked at later
    alone.sizes = {};
    alone.shapes = {};
    alone.spread = {};
    alone.brine = {};
    alone.arrangement = {};
    alone.floe.length = alone.floe.breadth = alone.floe.element;
    Contradictions found;
    check_moorings(alone, found);
    if (!found.empty()) return {};
    const std::optional<NaturalMode> longest = longest_mode(scenario.moorings, scenario.water_stiffness());
    return longest ? SlowestSwing{longest->period, motion_names.at(at(longest->motion))} : SlowestSwing{};
}

/// A length of a field, which all cases share, and why.
struct Wish {
    double value = 0;
    std::string reason;
};

/// Of the keys that it is for; of field.floes, the length of the field.
using Wishes = std::map<LaidKey, Wish>;

/// Lays one case.
class Layout {
  public:
    explicit Layout(Unlaid& one)
        : one_(one),
          scenario_(*one.scenario),
          hull_(reach_of_hull(scenario_.structure.shape, scenario_.first_yaw())),
          floes_(measures_of_floes(scenario_)),
          swing_(slowest_swing(scenario_)) {
        const Analysis& analysis = scenario_.analysis;
        stride_ = analysis.keep_history ? analysis.history_stride : 1;
        if (scenario_.arrangement.given()) one_.open.reset(index(LaidKey::half_width)).reset(index(LaidKey::begin));
        follow_path();
    }

    /// Whether its path can be followed at all.
    bool possible() const { return std::isfinite(aside_) && std::isfinite(back_) && std::isfinite(path_time_); }

    void lay_places() {
        const double before = rounded_up(hull_.first_ahead + floes_before * floes_.side);
        const std::string gap =
            fmt::format("the bow, {:.4g} m ahead of the axis, is half a floe of {:.4g} m before the ice",
                        hull_.first_ahead, floes_.side);
        Field& field = scenario_.field;
        Structure& structure = scenario_.structure;
        const bool start_is_open = is_open(LaidKey::start);
        if (is_open(LaidKey::begin)) {
            field.begin = start_is_open ? 0.0 : structure.start + before;
            tell(LaidKey::begin, start_is_open ? "x = 0 is where the ice begins" : gap);
        }
        if (!start_is_open) return;
        structure.start = field.begin - before;
        tell(LaidKey::start, gap);
    }

    void lay_times() {
        Analysis& analysis = scenario_.analysis;
        lay_steady_start();
        lay_window();
        if (path_time_ > 0)
            end_after(path_time_, fmt::format("until the path ends after {:.6g} s", path_time_));
        else if (analysis.steady_start + analysis.window > longest_time)
            end_after(longest_time, "as long as a window may be");
    }

    /// Lengths that it needs by itself. Its path is no longer known in detail then.
    const Wishes& wish() {
        own_ = wishes();
        places_ = {};
        return own_;
    }

    /// `shared`: of all cases.
    void lay_field(const Wishes& shared) {
        Field& field = scenario_.field;
        take(LaidKey::sheet_width, field.sheet_width, shared);
        take(LaidKey::half_width, field.half_width, shared);
        if (field.endless() && !scenario_.arrangement.level()) {
            take(LaidKey::ahead, field.ahead, shared);
            take(LaidKey::behind, field.behind, shared);
        }
        lay_floes(shared.at(LaidKey::floes));
        lay_lattice();
        if (!field.endless() && (!is_open(LaidKey::floes) || scenario_.arrangement.given())) end_with_field();
        lay_segments();
    }

  private:
    static constexpr std::size_t index(LaidKey key) { return static_cast<std::size_t>(key); }
    bool is_open(LaidKey key) const { return one_.open.test(index(key)); }

    void tell(LaidKey key, std::string reason) { one_.laid[key] = std::move(reason); }

    void take(LaidKey key, double& field, const Wishes& shared) {
        if (!is_open(key)) return;
        const auto& [value, reason] = shared.at(key);
        field = value;
        tell(key, reason + (own_.at(key).value < value ? ", in the case that needs most" : ""));
    }

    Wishes wishes() const {
        const bool swings_round =
            scenario_.path.any() || (scenario_.moorings.give_way() && scenario_.moorings.turret.any() &&
                                     scenario_.moorings.is_free(Motion::yaw));
        const double side = swings_round ? hull_.around : hull_.aside;
        const double beside = std::max(breadths_beside * hull_.breadth(), floes_beside * floes_.side);
        const double room = room_ahead();
        const double way = way_into_field();
        const auto within = [](double length, double most) { return std::min(rounded_up(length), most); };
        Wishes wishes;
        wishes[LaidKey::sheet_width] = {within(floes_.diagonal, widest),
                                        fmt::format("the diagonal of the largest floe, {:.4g} m", floes_.diagonal)};
        wishes[LaidKey::half_width] = {
            within(aside_ + side + beside, widest),
            fmt::format(
                "{}the hull reaches {:.4g} m aside, and beside it {}",
                aside_ > 0 ? fmt::format("the path goes {:.4g} m aside, ", aside_) : "", side,
                larger_of(breadths_beside * hull_.breadth(), fmt::format("is its breadth of {:.4g} m", hull_.breadth()),
                          floes_beside * floes_.side, fmt::format("are two floes of {:.4g} m", floes_.side)))};
        wishes[LaidKey::ahead] = {within(hull_.around + room, farthest_edge),
                                  fmt::format("the hull reaches {:.4g} m, and {}", hull_.around, room_words())};
        wishes[LaidKey::behind] = {
            within(window_least(scenario_) + floes_.side + back_, farthest_edge),
            fmt::format("the hull and the floes about it reach {:.4g} m, and a floe more{}", window_least(scenario_),
                        back_ > 0 ? fmt::format(", and the path comes back by {:.4g} m", back_) : "")};
        wishes[LaidKey::floes] = {
            rounded_up(way + hull_.around + room - scenario_.field.begin + scenario_.structure.start),
            fmt::format("a way of {:.4g} m, the hull, and {}", way, room_words())};
        return wishes;
    }

    /// What the path does until the run ends, where that is stated, or else until its own end.
    void follow_path() {
        if (!scenario_.path.any()) return;
        const bool stated = !is_open(LaidKey::steady_start) && !is_open(LaidKey::window);
        path_time_ = duration_of(scenario_.path);
        constexpr double most_steps = 2e7;
        const double time = stated ? scenario_.analysis.steady_start + scenario_.analysis.window : path_time_;
        if (!(time / scenario_.general.time_step < most_steps)) {
            path_time_ = std::numeric_limits<double>::infinity();
            return;
        }
        const int steps = static_cast<int>(std::ceil(time / scenario_.general.time_step));
        places_ = places_of(scenario_.path, scenario_.general.time_step, steps);
        for (const PathPlace& place : places_) {
            farthest_ = std::max(farthest_, place.pose.x);
            aside_ = std::max(aside_, std::abs(place.pose.z));
            back_ = std::max(back_, farthest_ - place.pose.x);
        }
    }

    /// s, until the structure has gone so far; at most until its path ends.
    double time_of(double way) const {
        if (!scenario_.path.any()) return way / scenario_.structure.speed;
        const double step = scenario_.general.time_step;
        double gone = 0;
        std::size_t k = 1;  // the first place is the start
        for (; k < places_.size() && gone < way * (1 - 1e-9); ++k) gone += step * places_[k].velocity.norm();
        return step * static_cast<double>(k - 1);
    }

    /// m/s, mean.
    double speed() const {
        if (places_.size() < 2) return scenario_.structure.speed;
        const double step = scenario_.general.time_step;
        return way_of(places_, step) / (step * static_cast<double>(places_.size() - 1));
    }

    /// A time of whole steps, and of whole parts of so many; `up`: at least `time`, to two figures.
    double whole(double time, std::int64_t parts, bool up) const {
        const double step = scenario_.general.time_step;
        constexpr double rounding = 1e-9;
        const double count = (up ? rounded_up(time) : time) / step / static_cast<double>(parts);
        const double whole = up ? std::ceil(count * (1 - rounding)) : std::floor(count * (1 + rounding));
        return to_digits(step * static_cast<double>(parts) * whole, 10);
    }

    /// Likewise of whole segments, which are to two figures.
    double whole_window(double time, bool up) const {
        const std::int64_t segments = scenario_.analysis.segments;
        const std::int64_t parts = stride_ / std::gcd(std::int64_t{stride_}, segments);
        const auto count = static_cast<double>(segments);
        return to_digits(count * whole(time / count, parts, up), 10);
    }

    void lay_steady_start() {
        if (!is_open(LaidKey::steady_start)) return;
        const double before = std::max(0.0, scenario_.field.begin - scenario_.structure.start - hull_.first_ahead);
        const double way = before + hull_.length() + floes_of_entry * floes_.side;
        const double by_way = time_of(way);
        std::string reason =
            fmt::format("ice lies along the hull of {:.4g} m and two floes of {:.4g} m more, {:.4g} m on",
                        hull_.length(), floes_.side, way);
        double swing = periods_of_entry * swing_.period;
        std::string words = fmt::format("{:g} {}", periods_of_entry, swing_.words());
        const double damping = scenario_.moorings.damping;
        if (const double damped = folds_of_entry / (2 * std::numbers::pi * damping); damped < periods_of_entry) {
            swing = damped * swing_.period;
            words = fmt::format("{:.2g} {}, in which damping ends 95 % of a swing", damped, swing_.words());
        }
        const double by_swing = swing_.period > 0 ? time_of(before) + swing : 0;
        if (by_swing > by_way) reason = "the bow meets the ice, and then " + words;
        scenario_.analysis.steady_start = std::min(longest_time, whole(std::max(by_way, by_swing), stride_, true));
        tell(LaidKey::steady_start, reason);
    }

    void lay_window() {
        if (!is_open(LaidKey::window)) return;
        Analysis& analysis = scenario_.analysis;
        const int segments = analysis.segments;
        const double way = std::max(breadths_of_segment * hull_.breadth(), floes_of_segment * floes_.mean);
        const double moving = speed();
        const int parts = std::max(segments, usual_segments);
        const double by_way = moving > 0 ? parts * way / moving : 0;
        const double by_swing = periods_of_window * swing_.period;
        const double by_average = segments * longest_average();
        std::string reason = fmt::format(
            "{} times {}, at {:.3g} m/s", parts == usual_segments ? "three" : std::to_string(parts),
            larger_of(breadths_of_segment * hull_.breadth(), fmt::format("two breadths of the hull, {:.4g} m", way),
                      floes_of_segment * floes_.mean, fmt::format("five floes, {:.4g} m", way)),
            moving);
        if (by_swing > by_way) reason = fmt::format("{:g} {}", periods_of_window, swing_.words());
        if (by_average > std::max(by_way, by_swing))
            reason = fmt::format("each segment as long as the longest of analysis.averaging_s, {:g} s",
                                 analysis.averaging.back());
        const double least = 2.0 * segments * scenario_.general.time_step;
        analysis.window = std::min(whole_window(longest_time, false),
                                   whole_window(std::max({by_way, by_swing, by_average, least}), true));
        tell(LaidKey::window, reason);
    }

    /// s; 0: only the default ones, of which those that are too long are left out.
    double longest_average() const {
        const std::vector<double>& times = scenario_.analysis.averaging;
        return times == Analysis{}.averaging || times.empty() ? 0 : times.back();
    }

    /// Lets the run end then, as far as its times are open. If both are, neither is to leave the other none.
    void end_after(double time, const std::string& reason) {
        Analysis& analysis = scenario_.analysis;
        const bool both = is_open(LaidKey::steady_start) && is_open(LaidKey::window);
        const bool shorter = analysis.steady_start + analysis.window > time;
        const double least =
            analysis.segments * std::max(2.0 * stride_ * scenario_.general.time_step, longest_average());
        if (is_open(LaidKey::steady_start) && shorter) {
            const double most = both ? time / 2 : time - analysis.window;
            if (most >= 0 && most < analysis.steady_start) {
                analysis.steady_start = whole(most, stride_, false);
                tell(LaidKey::steady_start, both ? "half of the time " + reason : "the rest of the time " + reason);
            }
        }
        if (!is_open(LaidKey::window) || time - analysis.steady_start < least) return;
        analysis.window = whole_window(time - analysis.steady_start, false);
        tell(LaidKey::window, reason);
    }

    double room_ahead() const { return std::max(breadths_ahead * hull_.breadth(), floes_ahead * floes_.side); }

    std::string room_words() const {
        return larger_of(breadths_ahead * hull_.breadth(),
                         fmt::format("two breadths of it, {:.4g} m, ahead", breadths_ahead * hull_.breadth()),
                         floes_ahead * floes_.side, fmt::format("three floes of {:.4g} m ahead", floes_.side));
    }

    /// m/s, past ice that nothing holds.
    double speed_through_ice() const {
        const double drift = scenario_.field.far_end == FarEnd::open ? scenario_.water.current_velocity().x() : 0;
        return scenario_.structure.speed - drift;
    }

    /// m, until the run ends.
    double way_into_field() const {
        if (scenario_.path.any()) return farthest_;
        return std::max(0.0, speed_through_ice()) * (scenario_.analysis.steady_start + scenario_.analysis.window);
    }

    /// So many that the field is that long, m.
    int floes_for(double length) const {
        const Field& field = scenario_.field;
        const double wanted = std::ceil(length * field.concentration * 2 * field.half_width / floes_.area);
        return static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(most_floes)));
    }

    void lay_floes(const Wish& length) {
        if (!is_open(LaidKey::floes)) return;
        Field& field = scenario_.field;
        if (scenario_.arrangement.given()) {
            const bool traced = scenario_.arrangement.method == ArrangementMethod::traced;
            const std::size_t given =
                traced ? scenario_.shapes.traced.outlines.size() : scenario_.arrangement.poses.size();
            field.floes = static_cast<int>(std::clamp<std::size_t>(given, 1, most_floes));
            if (scenario_.arrangement.level()) return tell(LaidKey::floes, "one sheet");
            return tell(LaidKey::floes, traced ? "one for each outline" : "one for each pose");
        }
        needed_ = field.endless() ? scenario_.window_ahead() + scenario_.window_behind() : length.value;
        field.floes = std::max(floes_for(needed_), fewest_of_list());
        while (scenario_.field_length() < needed_ && field.floes < most_floes)
            field.floes = std::min(most_floes, field.floes + 1 + field.floes / 50);
        tell(LaidKey::floes, field.endless() ? fmt::format("a part as long as the {:.4g} m that are computed", needed_)
                                             : fmt::format("{:.4g} m of field: {}", needed_, length.reason));
    }

    /// So many that a floe has the rarest of listed sizes.
    int fewest_of_list() const {
        const Sizes& sizes = scenario_.sizes;
        if (sizes.law != SizeLaw::list || sizes.by != SharesOf::number) return 1;
        double rarest = 1;
        for (const ListedSize& one : sizes.list)
            if (one.share > 0) rarest = std::min(rarest, one.share);
        return static_cast<int>(std::min(std::ceil(1 / rarest), static_cast<double>(most_floes)));
    }

    bool lies_on_lattice() const {
        Contradictions found;
        check_lattice(scenario_, found);
        return found.empty();
    }

    /// Floes of one size have to fit in whole rows: a wider field, or more floes, until they do.
    void lay_lattice() {
        constexpr int most_rows = 200;
        constexpr double rounding = 1e-6;
        if (lies_on_lattice()) return;
        Field& field = scenario_.field;
        const Field before = field;
        const double row = scenario_.floe.breadth + scenario_.arrangement.clearance;
        const double inside = 2 * field.half_width - scenario_.arrangement.clearance;
        const double rows_inside = std::min(inside / row, static_cast<double>(most_floes));
        const int first =
            static_cast<int>(is_open(LaidKey::half_width) ? std::ceil(rows_inside) : std::floor(rows_inside));
        for (int rows = std::max(1, first); rows < first + most_rows; ++rows) {
            if (is_open(LaidKey::half_width))
                field.half_width = to_digits((1 + rounding) * (rows * row + scenario_.arrangement.clearance) / 2, 6);
            if (is_open(LaidKey::floes)) {
                const int wanted = std::max(floes_for(needed_), fewest_of_list());
                field.floes = std::min(most_floes, (wanted + rows - 1) / rows * rows);
            }
            if (lies_on_lattice()) {
                if (is_open(LaidKey::half_width))
                    tell(LaidKey::half_width,
                         fmt::format("{} rows of floes, as {}", rows, one_.laid.at(LaidKey::half_width)));
                return;
            }
            if (!is_open(LaidKey::half_width)) break;
        }
        field = before;
    }

    /// Where the floes are stated, the run ends before they do.
    void end_with_field() {
        if (scenario_.path.any() || !(speed_through_ice() > 0)) return;
        const double room = scenario_.field_end() - scenario_.structure.start - hull_.around;
        const double time = room / speed_through_ice();
        const Analysis& analysis = scenario_.analysis;
        if (!(time > 0) || analysis.steady_start + analysis.window <= time) return;
        end_after(time, fmt::format("until the ice of {} floes ends, {:.4g} m on", scenario_.field.floes, room));
    }

    void lay_segments() {
        Analysis& analysis = scenario_.analysis;
        if (!is_open(LaidKey::segments)) return;
        const auto steps = std::llround(analysis.window / scenario_.general.time_step);
        int segments = usual_segments;
        while (segments > 1 && (steps % segments != 0 || steps / segments < 2)) --segments;
        if (segments == analysis.segments) return;
        analysis.segments = segments;
        tell(LaidKey::segments, fmt::format("{} cut the window of {:g} s into whole steps, and {} do not", segments,
                                            analysis.window, usual_segments));
    }

    Unlaid& one_;
    Scenario& scenario_;
    HullReach hull_;
    FloeMeasures floes_;
    SlowestSwing swing_;
    Wishes own_;
    int stride_ = 1;
    std::vector<PathPlace> places_;  ///< of a path
    double path_time_ = 0;           ///< s, until it ends; 0: there is none
    double farthest_ = 0;            ///< m, along x
    double aside_ = 0;               ///< m, to either side
    double back_ = 0;                ///< m, behind the farthest
    double needed_ = 0;              ///< m, length of the field or of its parts
};

/// Whether its own checks leave a hull and floes to lay a field for.
bool can_be_laid(const Scenario& scenario) {
    Contradictions found;
    check_traced(scenario, found);
    if (found.empty()) check_sizes(scenario, found);
    if (found.empty()) check_shape(scenario, found);
    return found.empty();
}

}  // namespace

bool lays_itself(const Scenario& scenario) {
    constexpr double much = 0.01;
    const Shape& shape = scenario.structure.shape;
    if (shape.fault()) return false;
    static const double of_paper = Shape().waterline_radius();
    return std::abs(shape.waterline_radius() / of_paper - 1) > much;
}

void lay(std::span<Unlaid> cases) {
    std::vector<Layout> layouts;
    layouts.reserve(cases.size());
    Wishes shared;
    for (Unlaid& one : cases) {
        if (one.open.none() || !lays_itself(*one.scenario) || !can_be_laid(*one.scenario)) continue;
        Layout& layout = layouts.emplace_back(one);
        if (!layout.possible()) {
            layouts.pop_back();
            continue;
        }
        layout.lay_places();
        layout.lay_times();
        for (const auto& [key, wish] : layout.wish())
            if (wish.value > shared[key].value) shared[key] = wish;
    }
    for (Layout& layout : layouts) layout.lay_field(shared);
}

}  // namespace floes
