#include "findings/energy_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/units.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

struct Share {
    std::string_view key;
    std::string_view words;
};

constexpr std::array all_shares{
    Share{"work_ice_friction", "friction, ice on ice"},
    Share{"work_ice_crushing", "crushing and stopping, ice on ice"},
    Share{"work_hull_friction", "friction on the structure"},
    Share{"work_hull_crushing", "crushing and stopping on the structure"},
    Share{"work_vertical_drag", "drag along the normals of the ice"},
    Share{"work_plane_drag", "form and skin drag"},
    Share{"work_waves", "waves"},
    Share{"work_joints", "bending and breaking"},
    Share{"work_lifting", "lifting and pushing under"},
    Share{"work_driving", "against sheets that give way and wind"},
    Share{"work_motion", "motion of ice and water"},
    Share{"work_rest", "lost by finite steps"},
};

std::vector<double> values_of(const CampaignTable& table, std::size_t of_case, std::string_view key) {
    const Quantity& quantity = *find_quantity(key);
    std::vector<double> values;
    for (const MemberRow* member : done_members(table, of_case)) {
        const double value = member->value(quantity);
        if (std::isfinite(value)) values.push_back(value);
    }
    return values;
}

}  // namespace

std::vector<EnergyRow> find_energy(const CampaignTable& table) {
    std::vector<EnergyRow> rows;
    for (std::size_t k = 0; k < table.cases.size(); ++k) {
        const std::size_t first = rows.size();
        double sum = 0;
        for (const auto& [key, words] : all_shares) {
            const std::vector<double> values = values_of(table, k, key);
            if (values.empty()) continue;
            const Interval force = mean_interval(values);
            sum += force.estimate;
            rows.push_back({k, key, words, force, 0, static_cast<double>(values.size())});
        }
        for (std::size_t i = first; i < rows.size(); ++i) rows[i].share = rows[i].force.estimate / sum;
    }
    return rows;
}

Section energy_section(Evidence& evidence) {
    const std::vector<EnergyRow> rows = find_energy(evidence.table);
    if (rows.empty()) return {.missing = "Work of the tow: unknown, because the members were computed without it.\n"};
    const std::vector<std::size_t> shown = drawn_cases(evidence.summary);
    double largest = 0;
    for (const EnergyRow& row : rows) largest = std::max(largest, std::abs(row.force.estimate));
    const int decimals = decimals_for(largest);

    Table table{{"work of the tow over its length, N"}};
    for (const std::size_t k : shown) table.front().emplace_back(evidence.summary.label_of(k), "%");
    const auto add = [&](std::string_view words, auto&& cell_of) {
        std::vector<Cell>& line = table.emplace_back();
        line.emplace_back(std::string{words});
        for (const std::size_t k : shown) line.push_back(cell_of(k));
    };
    const auto drives = [](const EnergyRow& row) { return row.key == "work_driving" && row.force.estimate != 0; };
    const bool driven = std::ranges::any_of(rows, drives);
    for (const auto& [key, words] : all_shares) {
        if (key == "work_driving" && !driven) continue;  // most campaigns have neither
        add(words, [&, key = key](std::size_t k) -> Cell {
            const auto row =
                std::ranges::find_if(rows, [&](const EnergyRow& one) { return one.case_index == k && one.key == key; });
            if (row == rows.end()) return {"–", ""};
            std::string force = fixed(row->force.estimate, decimals);
            if (std::isfinite(row->force.high)) force += " ± " + fixed(row->force.high - row->force.estimate, decimals);
            return {std::move(force), fixed(row->share / unit::percent, 0)};
        });
    }
    add("together", [&](std::size_t k) -> Cell {
        double sum = 0;
        for (const EnergyRow& row : rows)
            if (row.case_index == k) sum += row.force.estimate;
        return {fixed(sum, decimals), "100"};
    });
    return {
        .table = std::move(table),
        .after =
            "\nWhere the work of the tow goes, divided by the distance towed: together it is the mean load, but for "
            "what the steps that were looked at (every fifth) differ from all. ±: 95 % interval over arrangements. "
            "Stopping: floes that meet lose speed without friction. Bending and breaking contains what joints still "
            "store." +
            undrawn_text(evidence.summary) + "\n",
        .records = {make_rows<EnergyRow>(
            "energy", rows,
            {{"case", [&](const EnergyRow& row) { return Datum(evidence.summary.name_of(row.case_index)); }},
             {"quantity", [](const EnergyRow& row) { return Datum(std::string{row.key}); }},
             {"mean_N", [](const EnergyRow& row) { return Datum(row.force.estimate); }},
             {"low_N", [](const EnergyRow& row) { return Datum(row.force.low); }},
             {"high_N", [](const EnergyRow& row) { return Datum(row.force.high); }},
             {"share", [](const EnergyRow& row) { return Datum(row.share); }},
             {"members", [](const EnergyRow& row) { return Datum(row.members); }}})}};
}

}  // namespace floes
