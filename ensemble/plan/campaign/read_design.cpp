#include "campaign/read_design.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "campaign/campaign_keys.hpp"
#include "core/error.hpp"
#include "keys/edit_distance.hpp"
#include "keys/literal.hpp"
#include "keys/read.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace {

/// The entries of a [[design.axis]].
struct AxisText {
    std::optional<Entry> key;
    std::optional<Entry> values;
    std::optional<Entry> from;
    std::optional<Entry> to;
    std::optional<Entry> scale;

    explicit AxisText(const Block& block) {
        const std::vector<std::pair<std::string, std::optional<Entry>*>> known{
            {"key", &key}, {"values", &values}, {"from", &from}, {"to", &to}, {"scale", &scale}};
        for (const Entry& entry : block.entries) {
            const auto found = std::ranges::find(known, entry.path, &decltype(known)::value_type::first);
            if (found == known.end()) {
                const auto near = std::ranges::min_element(
                    known, {}, [&](const auto& one) { return edit_distance(one.first, entry.path); });
                throw InputError(fmt::format("{}: {} = {} is not a key of an axis; did you mean {}?", entry.where,
                                             entry.path, to_text(entry.value), near->first));
            }
            *found->second = entry;
        }
    }
};

class AxisReader {
  public:
    AxisReader(const Block& block, const Design& design, Spelling spelling)
        : text_(block), where_(block.where), design_(design), spelling_(spelling), keys_(describe(scratch_)) {}

    DesignAxis read() {
        const Key& key = find();
        axis_.key = key.path;
        axis_.whole = std::holds_alternative<IntegerField>(key.field);
        axis_.numeric = axis_.whole || std::holds_alternative<NumberField>(key.field);
        if (text_.scale) {
            Key scale = word_key("scale", axis_.scale, {"linear", "log"}, "", "");
            assign(scale, *text_.scale);
        }
        if (design_.has_ranges()) {
            read_range(key);
        } else {
            read_values(key);
        }
        return axis_;
    }

  private:
    InputError wrong(const std::string& where, const std::string& what) const {
        return InputError(fmt::format("{}: the axis {} {}", where, axis_.key, what));
    }

    const Key& find() {
        if (!text_.key)
            throw InputError(
                fmt::format("{}: this [[design.axis]] has no key; begin it with key = \"ice.thickness_m\"", where_));
        std::string path;
        assign(text_key("key", path, "", ""), *text_.key);
        if (spelling_ == Spelling::present) refuse_former(keys_, path, text_.key->where);
        if (const Key* key = find_key(keys_, full_path(path))) return *key;
        throw InputError(fmt::format("{}: key = {} is not a key that a case takes; did you mean {}?", text_.key->where,
                                     text_literal(path), text_literal(nearest_path(keys_, path))));
    }

    void read_range(const Key& key) {
        if (text_.values)
            throw wrong(text_.values->where, "has values, which are for a grid or a list; give it from and to");
        if (!axis_.numeric)
            throw wrong(text_.key->where, "takes no numbers, so it has no from and to; a grid or a list takes values");
        if (!text_.from || !text_.to) throw wrong(where_, "wants from and to, between which its points lie");
        axis_.from = number(key, *text_.from);
        axis_.to = number(key, *text_.to);
        if (axis_.from >= axis_.to)
            throw wrong(text_.to->where, fmt::format("goes from {} to {}; from must be below to",
                                                     to_text(text_.from->value), to_text(text_.to->value)));
        refuse_log_of(axis_.from, text_.from->where);
    }

    void read_values(const Key& key) {
        if (text_.from || text_.to)
            throw wrong((text_.from ? text_.from : text_.to)->where,
                        "has from or to, which are for latin_hypercube and sobol; give it values");
        if (!text_.values) throw wrong(where_, "has no values; give it a list, as in values = [0.02, 0.03]");
        const Entry& entry = *text_.values;
        const auto* values = std::get_if<std::vector<Value>>(&entry.value.data);
        if (values == nullptr || values->empty())
            throw wrong(entry.where,
                        fmt::format("has values = {}; allowed: a list of one value or more", to_text(entry.value)));
        if (std::ssize(*values) > most_cases)
            throw wrong(entry.where,
                        fmt::format("has {} values; no more than {} are allowed", values->size(), most_cases));
        std::set<std::pair<std::size_t, std::string>> seen;  // kind and text
        for (const Value& value : *values) {
            assign(key, {axis_.key, value, entry.where});
            if (axis_.numeric) refuse_log_of(number(key, {axis_.key, value, entry.where}), entry.where);
            const bool repeated = !seen.emplace(value.data.index(), exact_text(key)).second;
            if (repeated && design_.method == DesignMethod::grid)
                throw wrong(entry.where, fmt::format("has {} twice; keep one", to_text(value)));
            axis_.values.push_back(value);
        }
        if (!axis_.numeric && text_.scale) throw wrong(text_.scale->where, "takes no numbers, so it has no scale");
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
            throw wrong(where,
                        fmt::format("has the scale log and the value {}; a logarithm wants values above 0", value));
    }

    AxisText text_;
    std::string where_;
    const Design& design_;
    Spelling spelling_;
    Scenario scratch_;
    Keys keys_;
    DesignAxis axis_;
};

class DesignCheck {
  public:
    DesignCheck(const Design& design, const Origins& origins, const std::string& file)
        : design_(design), origins_(origins), file_(file) {}

    void check() const {
        if (design_.axes.empty())
            throw wrong("design.method",
                        fmt::format("{} wants axes; write [[design.axis]] with a key for each", method()));
        if (design_.has_ranges()) {
            if (design_.points == 0)
                throw wrong("design.method", fmt::format("{} wants design.points, how many points it has", method()));
        } else if (design_.points != 0) {
            throw wrong("design.points", fmt::format("design.points = {} is not used by {}, whose axes have values",
                                                     design_.points, method()));
        }
        if (design_.indices && design_.method != DesignMethod::sobol)
            throw wrong("design.indices", "design.indices = true wants design.method = \"sobol\"");
        const std::int64_t count = point_count(design_);
        if (count == 0) throw wrong("design.method", uneven_list());
        if (count > most_cases)
            throw wrong("design.method", fmt::format("{} makes more than {} points; take fewer", method(), most_cases));
    }

  private:
    InputError wrong(const std::string& key, const std::string& what) const {
        const auto set = origins_.find(key);
        return InputError(fmt::format("{}: {}", set == origins_.end() ? file_ : set->second, what));
    }

    std::string method() const {
        Design copy = design_;
        const Key key = method_key(copy);
        return fmt::format("{} = {}", key.path, literal(key));
    }

    std::string uneven_list() const {
        std::vector<std::string> lengths;
        for (const DesignAxis& axis : design_.axes)
            lengths.push_back(fmt::format("{} has {}", axis.key, axis.values.size()));
        return fmt::format(
            "{} takes the axes' values side by side, so all want equally many, and {}; \"grid\" combines "
            "them all",
            method(), fmt::join(lengths, ", "));
    }

    const Design& design_;
    const Origins& origins_;
    const std::string& file_;
};

}  // namespace

Origins read_axes(const std::vector<Block>& blocks, const Origins& origins, const std::string& file, Spelling spelling,
                  Design& design) {
    Origins places;
    for (const Block& block : blocks) {
        if (block.path != axis_block) continue;
        if (!design.active())
            throw InputError(
                fmt::format("{}: this [[design.axis]] has no design; write [design] with method = \"grid\", "
                            "\"list\", \"latin_hypercube\" or \"sobol\"",
                            block.where));
        design.axes.push_back(AxisReader(block, design, spelling).read());
        const std::string& key = design.axes.back().key;
        const auto [earlier, is_new] = places.emplace(key, block.where);
        if (!is_new)
            throw InputError(
                fmt::format("{}: {} has an axis already, at {}; keep one", block.where, key, earlier->second));
    }
    if (design.active()) {
        DesignCheck(design, origins, file).check();
    } else if (design.points != 0) {
        throw InputError(
            fmt::format("{}: design.points is given and no design.method; write method = \"sobol\" or another in "
                        "[design]",
                        origins.at("design.points")));
    }
    return places;
}

}  // namespace floes
