#include "match/targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "core/units.hpp"
#include "keys/edit_distance.hpp"
#include "keys/literal.hpp"
#include "keys/read.hpp"

namespace floes {
namespace {

constexpr const char* target_block = "target";

const Entry* find_entry(const Block& block, const std::string& path) {
    const auto found = std::ranges::find(block.entries, path, &Entry::path);
    return found == block.entries.end() ? nullptr : &*found;
}

/// The time that a key ends in, s: 0.5 of "mean_maximum_0.5s"; none where it ends in something else.
std::vector<double> time_in(std::string_view key) {
    double time = 0;
    const char* const end = key.data() + key.size();
    const auto [stop, fault] = std::from_chars(key.data() + (key.rfind('_') + 1), end, time);
    const bool whole = fault == std::errc{} && std::string_view(stop, end) == "s";
    return whole && time > 0 ? std::vector{time} : std::vector<double>{};
}

std::string nearest_quantity(std::string_view key) {
    const std::vector<Quantity> known = quantities_with(time_in(key));
    return std::string{std::ranges::min_element(known, {}, [&](const Quantity& one) {
                           return edit_distance(one.key, key);
                       })->key.view()};
}

/// The values that the quantity can have, in the unit in which it is shown.
Range range_of(const Quantity& quantity) {
    if (quantity.positive) return above(0);
    return at_least(quantity.least * quantity.factor()).at_most(quantity.most * quantity.factor());
}

class TargetReader {
  public:
    explicit TargetReader(const Block& block) : block_(block) {}

    Target read() {
        target_.quantity = find_quantity();
        const double unit = target_.quantity.percent ? unit::percent : unit::one;
        double percent_of_value = 0;
        std::string quantity;
        const Keys keys{
            text_key("quantity", quantity, "", ""),
            text_key("case", target_.case_name, "", ""),
            number_key("value", target_.value, unit, range_of(target_.quantity), "", ""),
            number_key("uncertainty", target_.uncertainty, unit, at_least(0), "", ""),
            integer_key("runs", target_.runs, 1, 1'000'000, "", ""),
            number_key("discrepancy", target_.discrepancy, unit, at_least(0), "", ""),
            number_key("discrepancy_percent", percent_of_value, unit::percent, at_least(0), "", ""),
            switch_key("held_out", target_.held_out, "", ""),
        };
        for (const Entry& entry : block_.entries) assign_known(keys, entry);
        if (find_entry(block_, "value") == nullptr)
            throw InputError(fmt::format("{}: the target {} has no value; give the measured one, {}", block_.where,
                                         target_.name(), unit_words()));
        const Entry* relative = find_entry(block_, "discrepancy_percent");
        if (relative != nullptr && find_entry(block_, "discrepancy") != nullptr)
            throw InputError(fmt::format("{}: discrepancy_percent = {} and discrepancy are both given; keep one",
                                         relative->where, to_text(relative->value)));
        if (relative != nullptr) target_.discrepancy = percent_of_value * std::abs(target_.value);
        return target_;
    }

  private:
    Quantity find_quantity() const {
        const Entry* entry = find_entry(block_, "quantity");
        if (entry == nullptr)
            throw InputError(fmt::format("{}: this [[target]] has no quantity; begin it with quantity = \"mean_load\"",
                                         block_.where));
        std::string key;
        assign(text_key("quantity", key, "", ""), *entry);
        if (const auto found = any_quantity(key)) return *found;
        throw InputError(fmt::format("{}: quantity = {} is not a quantity of a member; did you mean {}?", entry->where,
                                     text_literal(key), text_literal(nearest_quantity(key))));
    }

    std::string unit_words() const {
        if (target_.quantity.percent) return "in percent";
        return target_.quantity.unit == "1" ? "which has no unit" : fmt::format("in {}", target_.quantity.unit);
    }

    const Block& block_;
    Target target_;
};

[[noreturn]] void refuse_stranger(const Entry& entry) {
    throw InputError(
        fmt::format("{}: {} = {} is not in a target; begin each target with [[target]], in double brackets",
                    entry.where, entry.path, to_text(entry.value)));
}

}  // namespace

std::string Target::name() const {
    return case_name.empty() ? std::string{quantity.key.view()} : fmt::format("{} {}", case_name, quantity.key);
}

std::string Target::shown(double stored, int digits) const {
    const std::string_view unit = quantity.percent ? "%" : quantity.unit == "1" ? "" : quantity.unit;
    return fmt::format("{:.{}g}{}{}", stored * quantity.factor(), digits, unit.empty() ? "" : " ", unit);
}

std::vector<Target> read_targets(std::string_view text, const std::string& file) {
    const Document document = parse_document(text, file);
    if (!document.entries.empty()) refuse_stranger(document.entries.front());
    std::vector<Target> targets;
    std::map<std::string, std::string> places;
    for (const Block& block : document.blocks) {
        if (block.path != target_block)
            throw InputError(
                fmt::format("{}: [[{}]] is not a table of targets; did you mean [[target]]?", block.where, block.path));
        const Target& target = targets.emplace_back(TargetReader(block).read());
        const auto [earlier, is_new] = places.emplace(target.name(), block.where);
        if (!is_new)
            throw InputError(fmt::format("{}: {} is a target already, at {}; keep one", block.where, target.name(),
                                         earlier->second));
    }
    if (targets.empty())
        throw InputError(
            fmt::format("{}: there are no targets; write [[target]] with quantity and value for each "
                        "measured figure",
                        file));
    return targets;
}

}  // namespace floes
