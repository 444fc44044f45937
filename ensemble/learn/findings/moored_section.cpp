#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/units.hpp"
#include "findings/moored_cases.hpp"
#include "findings/printable.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

/// A line, at full scale.
struct Line {
    const MooredCase* of;
    Interval mean_offset;
    Interval sd_offset;
    Interval force;
    Interval load;
    Interval amplification;
};

Interval over(const MooredCase& one, double factor, const std::function<double(const MooredRun&)>& value) {
    std::vector<double> values;
    for (const MooredRun& run : one.runs) values.push_back(factor * value(run));
    return mean_interval(values);
}

std::vector<Line> lines_of(const std::vector<MooredCase>& found, const MooredRequest& request) {
    std::vector<Line> lines;
    for (const MooredCase& one : found) {
        if (!one.refused.empty()) continue;
        const double force = request.force_factor();
        lines.push_back({&one, over(one, request.scale, [](const MooredRun& run) { return run.mean_offset; }),
                         over(one, request.scale, [](const MooredRun& run) { return run.sd_offset; }),
                         over(one, force, [](const MooredRun& run) { return run.force.mean_maximum; }),
                         over(one, force, [](const MooredRun& run) { return run.load.mean_maximum; }),
                         over(one, 1, [](const MooredRun& run) { return run.amplification(); })});
    }
    return lines;
}

std::vector<Cell> with_range(const Interval& found, double factor, int decimals, std::size_t runs) {
    const bool said = says_something(found.estimate, {found.low, found.high}, static_cast<int>(runs));
    return {fixed(factor * found.estimate, decimals),
            said ? bracket(factor * found.low, factor * found.high, decimals) : "–"};
}

Table table_of(const Summary& summary, const std::vector<Line>& lines, const MooredRequest& request) {
    double largest = 0;
    for (const Line& one : lines) largest = std::max({largest, one.force.estimate, one.load.estimate});
    const LoadUnit unit = load_unit(largest);
    const int decimals = decimals_for(unit.factor * largest);
    Table table{{"moored", "runs"}};
    const auto head = [&](const std::string& words) { table.front().emplace_back(words, "95 %"); };
    head("mean offset, m");
    head("SD of offset, m");
    head(fmt::format("largest k x of a segment, {}", unit.name));
    head(fmt::format("largest load over {:.3g} s, {}", request.time_factor() * lines.front().of->runs.front().load.time,
                     unit.name));
    head("amplification");
    table.front().emplace_back("rms velocity / drift");
    for (const Line& one : lines) {
        std::vector<Cell>& line = table.emplace_back();
        const std::size_t runs = one.of->runs.size();
        const auto add = [&](const Interval& value, double factor, int digits) {
            const std::vector<Cell> cells = with_range(value, factor, digits, runs);
            line.emplace_back(cells[0].value, cells[1].value);
        };
        line.emplace_back(summary.label_of(one.of->case_index));
        line.emplace_back(fmt::format("{}", runs));
        add(one.mean_offset, 1, decimals_for(one.mean_offset.estimate));
        add(one.sd_offset, 1, decimals_for(one.mean_offset.estimate));
        add(one.force, unit.factor, decimals);
        add(one.load, unit.factor, decimals);
        add(one.amplification, 1, 2);
        line.emplace_back(fixed(one.of->velocity_ratio(), 3));
    }
    return table;
}

DataRows records_of(const Summary& summary, const std::vector<Line>& lines, const MooredRequest& request) {
    std::vector<DataColumn<Line>> columns{
        {"case", [&](const Line& one) { return summary.name_of(one.of->case_index); }},
        {"runs", [](const Line& one) { return one.of->runs.size(); }},
        {"stiffness_N_m", [&](const Line&) { return request.hull.stiffness; }},
        {"mass_kg", [&](const Line&) { return request.hull.mass; }},
        {"damping_ratio", [&](const Line&) { return request.hull.damping_ratio; }},
        {"scale", [&](const Line&) { return request.scale; }},
        {"period_s", [&](const Line&) { return request.hull.period(); }},
        {"averaging_s", [&](const Line& one) { return request.time_factor() * one.of->runs.front().load.time; }},
        {"peak_separation_s", [&](const Line& one) { return request.time_factor() * one.of->separation; }}};
    const auto add = [&](const std::string& name, const std::string& unit_name, Interval Line::*value) {
        columns.push_back({name + unit_name, [=](const Line& one) { return (one.*value).estimate; }});
        columns.push_back({name + "_low", [=](const Line& one) { return (one.*value).low; }});
        columns.push_back({name + "_high", [=](const Line& one) { return (one.*value).high; }});
    };
    add("mean_offset", "_m", &Line::mean_offset);
    add("sd_offset", "_m", &Line::sd_offset);
    add("largest_force", "_N", &Line::force);
    add("largest_load", "_N", &Line::load);
    add("amplification", "", &Line::amplification);
    columns.push_back({"velocity_ratio", [](const Line& one) { return one.of->velocity_ratio(); }});
    return make_rows<Line>("moored/cases", lines, columns);
}

}  // namespace

Section moored_section(const Summary& summary, const std::vector<MooredCase>& found, const MooredRequest& request) {
    const std::vector<Line> lines = lines_of(found, request);
    const Oscillator& hull = request.hull;
    std::string doubts;
    std::vector<std::string> notes;
    for (const MooredCase& one : found) {
        const std::string& name = summary.label_of(one.case_index);
        const double ratio = one.velocity_ratio();
        if (!one.refused.empty())
            notes.push_back(fmt::format("{}: not answered: {}.", name, one.refused));
        else if (std::isfinite(ratio) && ratio > much_motion)
            doubts += fmt::format(
                "! {}: the hull moves with {:.0f} % of the drift speed (rms). The load of a fixed hull is then not the "
                "load that it gets, and these figures are no more than an indication.\n",
                name, ratio / unit::percent);
    }
    return {
        .title = fmt::format("Moored hull: {:.6g} kN/m, {:.6g} t, {:g} % of the critical damping; natural period "
                             "{:.3g} s",
                             hull.stiffness / 1e3, hull.mass / 1e3, hull.damping_ratio / unit::percent, hull.period()),
        .before = std::move(doubts),
        .table = table_of(summary, lines, request),
        .after =
            "\nm x'' + c x' + k x = F(t) in surge, F the stored load of the fixed hull, exact between its values. "
            "Largest of a segment: mean over segments and arrangements; brackets: 95 % (t). Amplification: largest "
            "k x over largest load. Rms velocity / drift: the load of a fixed hull serves while it is small, below "
            "some 0.2. docs/moored.md\n",
        .notes = std::move(notes),
        .records = {records_of(summary, lines, request)}};
}

}  // namespace floes
