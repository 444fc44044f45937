#include "campaign/case_blocks.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>
#include <variant>

#include "campaign/campaign_keys.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "keys/key.hpp"
#include "keys/meant.hpp"
#include "keys/read.hpp"

namespace floes {

namespace {

constexpr const char* case_block = "case";
constexpr std::size_t longest_name = 200;
constexpr std::size_t most_axis_values = 2'000'000;  // over all cases; each takes some 150 bytes

/// The memory that a value needs, in numbers; a text counts by its length.
std::size_t size_of(const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value.data)) return 1 + text->size() / 16;
    std::size_t size = 1;
    if (const auto* list = std::get_if<std::vector<Value>>(&value.data))
        for (const Value& item : *list) size += size_of(item);
    return size;
}

/// The same for the values of all axes in one case, at most.
std::size_t values_of_a_case(const Design& design) {
    std::size_t size = 0;
    for (const DesignAxis& axis : design.axes) {
        std::size_t largest = 1;
        for (const Value& value : axis.values) largest = std::max(largest, size_of(value));
        size += largest;
    }
    return size;
}

void refuse_stranger(const Block& block) {
    if (block.path == case_block || block.path == axis_block) return;
    const bool axis = edit_distance(block.path, axis_block) < edit_distance(block.path, case_block);
    throw InputError("{}: [[{}]] is not a table of a configuration; did you mean [[{}]]?", block.where, block.path,
                     axis ? axis_block : case_block);
}

/// The block's name, checked: present, plain, and none of those `taken`.
std::string case_name(const Block& block, std::set<std::string>& taken) {
    const Entry* entry = block.find("name");
    if (entry == nullptr) {
        throw InputError("{}: this [[case]] has no name; begin it with name = \"E60\"", block.where);
    }
    std::string name;
    assign(text_key("name", name, "", "Name of the case."), *entry);
    const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-' || c == '+' || c == '.'; };
    if (name.size() > longest_name)
        throw InputError("{}: name = {} is longer than the {} characters that the name of a case may have",
                         entry->where, to_text(entry->value), longest_name);
    if (name.empty() || !std::ranges::all_of(name, plain)) {
        throw InputError("{}: name = {} cannot name a case; allowed: letters, digits and any of _ - + .", entry->where,
                         text_literal(name));
    }
    if (!taken.insert(name).second) {
        throw InputError("{}: name = {} names an earlier case too; give each case its own name", entry->where,
                         text_literal(name));
    }
    return name;
}

/// Whether the cases are the points of a design, written out: then they have a design.point.
bool written_out(const std::vector<CaseBlock>& cases) {
    return std::ranges::any_of(cases, [](const CaseBlock& one) { return one.block.find("design.point") != nullptr; });
}

}  // namespace

std::vector<CaseBlock> given_cases(const Document& document, const std::string& fallback, const std::string& file,
                                   const Design& design) {
    std::vector<CaseBlock> cases;
    std::set<std::string> taken;
    for (const Block& block : document.blocks) {
        refuse_stranger(block);
        if (block.path == case_block) cases.push_back({block, case_name(block, taken), cases.size()});
    }
    if (cases.empty()) cases.push_back({{case_block, file, {}}, design.active() ? "" : fallback});
    return cases;
}

void refuse_axis(const Entry& entry, const Origins& axes) {
    const auto axis = axes.find(full_path(entry.path));
    if (axis == axes.end()) return;
    throw InputError("{}: {} = {} is hidden by the axis of the design at {}; keep one of them", entry.where, entry.path,
                     to_text(entry.value), axis->second);
}

std::vector<CaseBlock> at_points(std::vector<CaseBlock> given, const Design& design, const Origins& axes,
                                 std::uint64_t seed, const std::string& file) {
    if (!design.active() || written_out(given)) return given;
    const auto all = static_cast<std::int64_t>(given.size()) * point_count(design);
    if (all > most_cases)
        throw InputError("{}: {} at {} are {}; no more than {} are allowed", file, counted(std::ssize(given), "case"),
                         counted(point_count(design), "point"), counted(all, "case"), most_cases);
    const std::size_t values = static_cast<std::size_t>(all) * values_of_a_case(design);
    if (values > most_axis_values)
        throw InputError(
            "{}: {} of the design have {} values of its axes, more than the {} that can be held; take fewer points or "
            "fewer axes",
            file, counted(all, "case"), values, most_axis_values);
    const std::vector<DesignPoint> points = design_points(design, seed);
    std::vector<CaseBlock> cases;
    for (const CaseBlock& one : given) {
        for (const Entry& entry : one.block.entries) refuse_axis(entry, axes);
        for (std::size_t p = 0; p < points.size(); ++p) {
            CaseBlock& at_point = cases.emplace_back(one);
            at_point.name = one.name.empty() ? points[p].name : one.name + "+" + points[p].name;
            if (at_point.name.size() > longest_name)
                throw InputError(
                    "{}: the name of the point {} is longer than {} characters; give the [[case]] a shorter one", file,
                    at_point.name, longest_name);
            at_point.base = one.name;
            at_point.point = static_cast<int>(p);
            for (std::size_t axis = 0; axis < design.axes.size(); ++axis) {
                const std::string& key = design.axes[axis].key;
                at_point.block.entries.push_back({key, points[p].values[axis], axes.at(key)});
            }
        }
    }
    return cases;
}

void refuse_members(std::size_t cases, int arrangements, const std::string& file) {
    const auto members = static_cast<std::int64_t>(cases) * arrangements;
    if (members > most_members)
        throw InputError(
            "{}: {} with {} make {} members, more than the {} that a campaign can hold; take fewer of either, or run "
            "several campaigns",
            file, counted(static_cast<std::int64_t>(cases), "case"), counted(arrangements, "arrangement"), members,
            most_members);
}

void check_points(const Campaign& campaign, const std::string& file) {
    std::set<std::string> names;
    std::set<std::string> bases;
    std::set<std::pair<std::string, int>> points;
    const std::int64_t count = point_count(campaign.design);
    for (const Case& one : campaign.cases) {
        if (!campaign.design.active()) {
            if (one.point < 0 && one.base.empty()) continue;
            throw InputError(
                "{}: the case {} is a point of a design, and there is no [design]; take its design.point away", file,
                one.name);
        }
        const char* what = !names.insert(one.name).second ? "has the name of another point; rename a [[case]]"
                           : one.point < 0                ? "has no design.point, and others have"
                           : one.point >= count           ? "has a design.point beyond the design's last"
                           : !points.emplace(one.base, one.point).second ? "has the design.point of an earlier case"
                                                                         : nullptr;
        if (what != nullptr) throw InputError("{}: the case {} {}", file, one.name, what);
        bases.insert(one.base);
    }
    const std::size_t wanted = bases.size() * static_cast<std::size_t>(count);
    if (points.size() < wanted)
        throw InputError(
            "{}: {} of the {} points of the design have no case; take design.point away from the others too, and the "
            "design gives them all",
            file, wanted - points.size(), wanted);
}

}  // namespace floes
