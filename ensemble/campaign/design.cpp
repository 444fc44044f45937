#include "campaign/design.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <boost/random/sobol.hpp>

#include "campaign/campaign_keys.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "keys/key.hpp"
#include "keys/meant.hpp"
#include "scenario/keys.hpp"

namespace floes {

namespace {

constexpr std::size_t longest_plain_name = 24;

/// Points in the unit cube, one row a point.
using UnitPoints = std::vector<std::vector<double>>;

UnitPoints latin_hypercube(std::size_t points, std::size_t axes, std::uint64_t seed) {
    UnitPoints all(points, std::vector<double>(axes));
    for (std::size_t axis = 0; axis < axes; ++axis) {
        RandomStream random(seed, static_cast<std::uint32_t>(axis), StreamId::latin_hypercube, points);
        std::vector<std::size_t> part(points);
        std::iota(part.begin(), part.end(), std::size_t{0});
        for (std::size_t left = points; left > 1; --left)
            std::swap(part[left - 1], part[random.below(static_cast<std::uint32_t>(left))]);
        for (std::size_t p = 0; p < points; ++p)
            all[p][axis] = (static_cast<double>(part[p]) + random.uniform()) / static_cast<double>(points);
    }
    return all;
}

UnitPoints sobol(std::size_t points, std::size_t dimensions, std::uint64_t seed) {
    constexpr int unused_bits = 64 - 53;
    std::vector<std::uint64_t> shift(dimensions);
    for (std::size_t d = 0; d < dimensions; ++d) {
        RandomStream random(seed, static_cast<std::uint32_t>(d), StreamId::sobol_shift, 0);
        shift[d] = static_cast<std::uint64_t>(random.uniform() * 0x1p53);
    }
    boost::random::sobol sequence(dimensions);
    UnitPoints all(points, std::vector<double>(dimensions));
    for (std::size_t p = 0; p < points; ++p) {
        for (std::size_t d = 0; d < dimensions; ++d) {
            const std::uint64_t bits = p == 0 ? 0 : sequence() >> unused_bits;  // Boost skips the first point, 0
            all[p][d] = static_cast<double>(bits ^ shift[d]) * 0x1p-53;
        }
    }
    return all;
}

/// A, B and A with one axis from B, for each base point in turn.
UnitPoints saltelli(std::size_t base_points, std::size_t axes, std::uint64_t seed) {
    UnitPoints all;
    for (const std::vector<double>& both : sobol(base_points, 2 * axes, seed)) {
        const auto middle = both.begin() + static_cast<std::ptrdiff_t>(axes);
        const std::vector<double> a(both.begin(), middle);
        all.push_back(a);
        all.emplace_back(middle, both.end());
        for (std::size_t axis = 0; axis < axes; ++axis) {
            all.push_back(a);
            all.back()[axis] = both[axes + axis];
        }
    }
    return all;
}

Value on_axis(const DesignAxis& axis, double unit) {
    // Half a number beyond either end: then each whole number is met equally often.
    const double beyond = axis.whole ? 0.5 : 0;
    const double low = axis.from - beyond;
    const double high = axis.to + beyond;
    const double value =
        axis.scale == AxisScale::log ? low * std::exp(unit * std::log(high / low)) : low + unit * (high - low);
    const double inside = std::clamp(axis.whole ? std::floor(value + 0.5) : to_digits(value, 10), axis.from, axis.to);
    return axis.whole ? Value{static_cast<std::int64_t>(inside)} : Value{inside};
}

/// "0.03_open"; empty where the values are no short name.
std::string named_by_values(const std::vector<Value>& values) {
    std::vector<std::string> words;
    for (const Value& value : values) {
        const auto* word = std::get_if<std::string>(&value.data);
        words.push_back(word != nullptr ? *word : to_text(value));
    }
    const std::string name = fmt::format("{}", fmt::join(words, "_"));
    const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-' || c == '+' || c == '.'; };
    return name.size() <= longest_plain_name && std::ranges::all_of(name, plain) ? name : "";
}

void name_points(std::vector<DesignPoint>& points, bool by_values) {
    std::set<std::string> names;
    for (DesignPoint& point : points) {
        if (by_values) point.name = named_by_values(point.values);
        by_values = by_values && !point.name.empty() && names.insert(point.name).second;
        if (!by_values) break;
    }
    if (by_values) return;
    for (std::size_t p = 0; p < points.size(); ++p)
        points[p].name = fmt::format("p{:03}", p);  // the same in a design that has grown
}

std::vector<DesignPoint> given_points(const Design& design) {
    std::vector<DesignPoint> points(static_cast<std::size_t>(point_count(design)));
    for (std::size_t p = 0; p < points.size(); ++p) {
        std::size_t rest = p;
        points[p].values.resize(design.axes.size());
        for (std::size_t i = design.axes.size(); i-- > 0;) {
            const std::vector<Value>& values = design.axes[i].values;
            points[p].values[i] = values[design.method == DesignMethod::list ? p : rest % values.size()];
            rest /= values.size();
        }
    }
    return points;
}

UnitPoints unit_points(const Design& design, std::uint64_t seed) {
    const auto points = static_cast<std::size_t>(design.points);
    if (design.method == DesignMethod::latin_hypercube) return latin_hypercube(points, design.axes.size(), seed);
    if (design.indices) return saltelli(points, design.axes.size(), seed);
    return sobol(points, design.axes.size(), seed);
}

}  // namespace

std::int64_t point_count(const Design& design) {
    if (design.has_ranges()) {
        const std::int64_t each = design.indices ? static_cast<std::int64_t>(design.axes.size()) + 2 : 1;
        return std::min(each * design.points, most_cases + 1);
    }
    if (design.axes.empty()) return 0;
    std::int64_t count = 1;
    const auto length = static_cast<std::int64_t>(design.axes.front().values.size());
    for (const DesignAxis& axis : design.axes) {
        const auto own = static_cast<std::int64_t>(axis.values.size());
        if (design.method == DesignMethod::list && own != length) return 0;
        count = std::min(count * own, most_cases + 1);
    }
    return design.method == DesignMethod::list ? length : count;
}

std::vector<DesignPoint> design_points(const Design& design, std::uint64_t seed) {
    if (!design.has_ranges()) {
        std::vector<DesignPoint> points = given_points(design);
        name_points(points, true);
        return points;
    }
    std::vector<DesignPoint> points;
    for (const std::vector<double>& unit : unit_points(design, seed)) {
        DesignPoint& point = points.emplace_back();
        for (std::size_t i = 0; i < unit.size(); ++i) point.values.push_back(on_axis(design.axes[i], unit[i]));
    }
    name_points(points, false);
    return points;
}

namespace {

/// Throws InputError for an entry that no [[design.axis]] has.
void refuse_strangers(const Block& block) {
    constexpr std::array<std::string_view, 5> known{"key", "values", "from", "to", "scale"};
    for (const Entry& entry : block.entries) {
        if (std::ranges::find(known, entry.path) != known.end()) continue;
        const auto distance = [&](std::string_view one) { return edit_distance(one, entry.path); };
        throw InputError("{}: {} = {} is not a key of an axis; did you mean {}?", entry.where, entry.path,
                         to_text(entry.value), *std::ranges::min_element(known, {}, distance));
    }
}

class AxisReader {
  public:
    AxisReader(const Block& block, const Design& design)
        : key_(block.find("key")),
          values_(block.find("values")),
          from_(block.find("from")),
          to_(block.find("to")),
          scale_(block.find("scale")),
          where_(block.where),
          design_(design),
          keys_(describe(scratch_)) {}

    DesignAxis read() {
        const Key& key = find();
        axis_.key = key.path;
        axis_.whole = std::holds_alternative<IntegerField>(key.field);
        axis_.numeric = axis_.whole || std::holds_alternative<NumberField>(key.field);
        if (scale_ != nullptr) assign(word_key("scale", axis_.scale, {"linear", "log"}, "", ""), *scale_);
        if (design_.has_ranges())
            read_range(key);
        else
            read_values(key);
        return axis_;
    }

  private:
    template <class... Values>
    InputError wrong(const std::string& where, fmt::format_string<Values...> what, Values&&... values) const {
        return InputError("{}: the axis {} {}", where, axis_.key, fmt::format(what, std::forward<Values>(values)...));
    }

    const Key& find() {
        if (key_ == nullptr)
            throw InputError("{}: this [[design.axis]] has no key; begin it with key = \"ice.thickness_m\"", where_);
        std::string path;
        assign(text_key("key", path, "", ""), *key_);
        refuse_former(keys_, path, key_->where);
        if (const Key* key = find_key(keys_, full_path(path))) return *key;
        throw InputError("{}: key = {} is not a key that a case takes; did you mean {}?", key_->where,
                         text_literal(path), text_literal(nearest_path(keys_, path)));
    }

    void read_range(const Key& key) {
        if (values_ != nullptr)
            throw wrong(values_->where, "has values, which are for a grid or a list; give it from and to");
        if (!axis_.numeric)
            throw wrong(key_->where, "takes no numbers, so it has no from and to; a grid or a list takes values");
        if (from_ == nullptr || to_ == nullptr) throw wrong(where_, "wants from and to, between which its points lie");
        axis_.from = number(key, *from_);
        axis_.to = number(key, *to_);
        if (axis_.from >= axis_.to)
            throw wrong(to_->where, "goes from {} to {}; from must be below to", to_text(from_->value),
                        to_text(to_->value));
        refuse_log_of(axis_.from, from_->where);
    }

    void read_values(const Key& key) {
        if (from_ != nullptr || to_ != nullptr)
            throw wrong((from_ != nullptr ? from_ : to_)->where,
                        "has from or to, which are for latin_hypercube and sobol; give it values");
        if (values_ == nullptr) throw wrong(where_, "has no values; give it a list, as in values = [0.02, 0.03]");
        const Entry& entry = *values_;
        const auto* values = std::get_if<std::vector<Value>>(&entry.value.data);
        if (values == nullptr || values->empty())
            throw wrong(entry.where, "has values = {}; allowed: a list of one value or more", to_text(entry.value));
        if (std::ssize(*values) > most_cases)
            throw wrong(entry.where, "has {} values; no more than {} are allowed", values->size(), most_cases);
        std::set<std::pair<std::size_t, std::string>> seen;  // kind and text
        for (const Value& value : *values) {
            assign(key, {axis_.key, value, entry.where});
            if (axis_.numeric) refuse_log_of(number(key, {axis_.key, value, entry.where}), entry.where);
            const bool repeated = !seen.emplace(value.data.index(), exact_text(key)).second;
            if (repeated && design_.method == DesignMethod::grid)
                throw wrong(entry.where, "has {} twice; keep one", to_text(value));
            axis_.values.push_back(value);
        }
        if (!axis_.numeric && scale_ != nullptr) throw wrong(scale_->where, "takes no numbers, so it has no scale");
    }

    /// The number in the key's unit. Throws InputError if the key does not accept it.
    double number(const Key& key, const Entry& entry) const {
        assign(key, {axis_.key, entry.value, entry.where});
        if (const auto* whole = std::get_if<std::int64_t>(&entry.value.data)) return static_cast<double>(*whole);
        const double value = std::get<double>(entry.value.data);
        if (std::isinf(value)) throw wrong(entry.where, "has the value inf; the values of an axis are finite");
        return value;
    }

    void refuse_log_of(double value, const std::string& where) const {
        if (axis_.scale == AxisScale::log && value <= 0)
            throw wrong(where, "has the scale log and the value {}; a logarithm wants values above 0", value);
    }

    const Entry *key_, *values_, *from_, *to_, *scale_;  ///< of the block; null: it has none
    std::string where_;
    const Design& design_;
    Scenario scratch_;
    Keys keys_;
    DesignAxis axis_;
};

/// Throws InputError for what the design says as a whole.
void check_design(const Design& design, const Origins& origins, const std::string& file) {
    Design copy = design;
    const Key key = method_key(copy);
    const std::string method = fmt::format("{} = {}", key.path, literal(key));
    const auto wrong = [&]<class... Values>(const std::string& path, fmt::format_string<Values...> what,
                                            Values&&... values) {
        const auto set = origins.find(path);
        return InputError("{}: {}", set == origins.end() ? file : set->second,
                          fmt::format(what, std::forward<Values>(values)...));
    };
    if (design.axes.empty())
        throw wrong("design.method", "{} wants axes; write [[design.axis]] with a key for each", method);
    if (design.has_ranges() && design.points == 0)
        throw wrong("design.method", "{} wants design.points, how many points it has", method);
    if (!design.has_ranges() && design.points != 0)
        throw wrong("design.points", "design.points = {} is not used by {}, whose axes have values", design.points,
                    method);
    const std::int64_t count = point_count(design);
    if (count == 0) {
        std::vector<std::string> lengths;
        for (const DesignAxis& axis : design.axes)
            lengths.push_back(fmt::format("{} has {}", axis.key, axis.values.size()));
        throw wrong(
            "design.method",
            "{} takes the axes' values side by side, so all want equally many, and {}; \"grid\" combines them all",
            method, fmt::join(lengths, ", "));
    }
    if (count > most_cases)
        throw wrong("design.method", "{} makes more than {} points; take fewer", method, most_cases);
}

}  // namespace

Origins read_axes(const std::vector<Block>& blocks, const Origins& origins, const std::string& file, Design& design) {
    Origins places;
    for (const Block& block : blocks) {
        if (block.path != axis_block) continue;
        if (!design.active())
            throw InputError(
                "{}: this [[design.axis]] has no design; write [design] with method = \"grid\", \"list\", "
                "\"latin_hypercube\" or \"sobol\"",
                block.where);
        refuse_strangers(block);
        design.axes.push_back(AxisReader(block, design).read());
        const std::string& key = design.axes.back().key;
        const auto [earlier, is_new] = places.emplace(key, block.where);
        if (!is_new) throw InputError("{}: {} has an axis already, at {}; keep one", block.where, key, earlier->second);
    }
    if (design.active()) {
        check_design(design, origins, file);
    } else if (design.points != 0) {
        throw InputError(
            "{}: design.points is given and no design.method; write method = \"sobol\" or another in [design]",
            origins.at("design.points"));
    }
    return places;
}

}  // namespace floes
