#include "findings/piece_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.hpp"
#include "findings/report_sections.hpp"
#include "scenario/floes.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

constexpr double finest = 1e-9;  // m²

double side_of(long long area) {
    return std::sqrt(finest * static_cast<double>(area));
}

std::vector<double> areas_of(const FloeSet& floes) {
    std::vector<double> areas;
    for (std::size_t i = 0; i < floes.size(); ++i) areas.push_back(floes.shape(i).area());
    return areas;
}

/// Of each member; drawn again where outlines differ from one arrangement to the next.
FloeAreas floe_areas(const Campaign& campaign) {
    std::vector<std::vector<double>> of_cases;
    for (const Case& one : campaign.cases) of_cases.push_back(areas_of(floes_of(one.scenario)));
    return [&campaign, of_cases](int member) {
        const MemberKey key = member_key(campaign, member);
        const auto of_case = static_cast<std::size_t>(key.case_index);
        const Scenario& scenario = campaign.cases[of_case].scenario;
        if (!scenario.shapes.any()) return of_cases[of_case];
        return areas_of(floes_of(
            scenario, {arrangement_seed(campaign, key.case_index), static_cast<std::uint32_t>(key.arrangement)}));
    };
}

/// Moves the ice of one floe, whose pieces these are, from whole to pieces. `floes`: areas of all, one of them its own.
void break_up(SizesOfCase& sizes, std::span<const PieceRow> pieces, std::span<const double> floes) {
    double together = 0;
    for (const PieceRow& piece : pieces) {
        together += piece.area;
        sizes.after.add(piece.area);
    }
    const double whole = *std::ranges::min_element(floes, {}, [&](double area) { return std::abs(area - together); });
    sizes.after.add(whole, -1);
    sizes.in_pieces += whole;
    ++sizes.split;
    sizes.pieces += static_cast<double>(pieces.size());
}

Figure sizes_figure(const Summary& summary, const std::vector<SizesOfCase>& cases) {
    std::vector<double> sides;
    for (const SizesOfCase& one : cases)
        for (const auto& [side, share] : one.before.steps()) sides.push_back(side);
    Figure figure{.description = "Share of the ice in floes and pieces of at most a size",
                  .x = axis_around("size D, side of the square with the same area, m", sides, true),
                  .y = {"share of the area", 0, 1},
                  .size = {720, 320},
                  .legend = case_legend(summary),
                  .caption = "Sizes of the ice at the end of the run; dashed: of the floes at its start."};
    for (const SizesOfCase& one : cases) {
        for (const auto& [sizes, style] : {std::pair(&one.before, " dashed"), std::pair(&one.after, "")}) {
            Figure::Points points{{figure.x.low, 0}};
            for (const auto& [side, share] : sizes->steps()) {
                points.emplace_back(side, points.back().second);
                points.emplace_back(side, share);
            }
            points.emplace_back(figure.x.high, points.back().second);
            figure.line(std::move(points), colour(one.case_index) + style);
        }
    }
    return figure;
}

}  // namespace

void IceSizes::add(double area, double share) {
    const auto key = std::llround(area / finest);
    Sum& sum = by_area_[key];
    sum.count += share;
    sum.area += share * finest * static_cast<double>(key);
    if (!(sum.count > 0)) by_area_.erase(key);
}

double IceSizes::area() const {
    double sum = 0;
    for (const auto& [key, of] : by_area_) sum += of.area;
    return sum;
}

double IceSizes::count() const {
    double sum = 0;
    for (const auto& [key, of] : by_area_) sum += of.count;
    return sum;
}

double IceSizes::quantile(double share) const {
    const double wanted = share * area();
    double below = 0;
    for (const auto& [key, of] : by_area_) {
        below += of.area;
        if (below >= wanted) return side_of(key);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::pair<double, double>> IceSizes::steps() const {
    const double all = area();
    double below = 0;
    std::vector<std::pair<double, double>> found;
    for (const auto& [key, of] : by_area_) {
        below += of.area;
        found.emplace_back(side_of(key), below / all);
    }
    return found;
}

std::vector<SizesOfCase> find_piece_sizes(const CampaignTable& table, std::span<const PieceRow> pieces,
                                          const FloeAreas& floes) {
    std::vector<SizesOfCase> cases(table.cases.size());
    for (std::size_t k = 0; k < cases.size(); ++k) cases[k].case_index = k;
    for (int number = 0; number < static_cast<int>(table.members.size()); ++number) {
        const MemberRow& member = table.members[static_cast<std::size_t>(number)];
        if (!member.done()) continue;
        SizesOfCase& sizes = cases[static_cast<std::size_t>(member.case_index)];
        ++sizes.runs;
        const std::vector<double> areas = floes(number);
        // Every part of a field without end has floes of the same sizes. Files before 1.13 do not count them.
        const double parts = member.floes_entered > 0 ? member.floes_entered / static_cast<double>(areas.size()) : 1.0;
        for (const double area : areas) {
            sizes.before.add(area, parts);
            sizes.after.add(area, parts);
        }
        const auto own = std::ranges::equal_range(pieces, number, {}, &PieceRow::member);
        for (auto first = own.begin(); first != own.end();) {
            const auto end = std::ranges::upper_bound(first, own.end(), first->floe, {}, &PieceRow::floe);
            break_up(sizes, {first, end}, areas);
            first = end;
        }
    }
    std::erase_if(cases, [](const SizesOfCase& one) { return one.runs == 0; });
    for (SizesOfCase& one : cases) {
        one.pieces = one.split > 0 ? one.pieces / one.split : std::numeric_limits<double>::quiet_NaN();
        one.split /= one.runs;
        one.in_pieces /= one.before.area();
    }
    return cases;
}

Section piece_sizes_section(Evidence& evidence) {
    const std::vector<PieceRow>& pieces = pieces_of(evidence);
    if (pieces.empty())
        return {.missing = "Sizes of the ice: as at the start, or not kept; no floe is known to be in pieces.\n"};
    const std::vector<SizesOfCase> cases = find_piece_sizes(evidence.table, pieces, floe_areas(evidence.campaign));
    using Row = const SizesOfCase&;
    DataRows records = make_rows<SizesOfCase>(
        "ice_sizes", cases,
        {{"case", [&](Row row) { return evidence.summary.name_of(row.case_index); }},
         {"runs", &SizesOfCase::runs},
         {Names{"floes_cracked_through", "floes_cracked_through"}, &SizesOfCase::split},
         {Names{"pieces_of_one", "pieces_of_one"}, &SizesOfCase::pieces},
         {Names{"area_in_pieces", "area_in_pieces"}, &SizesOfCase::in_pieces},
         {Names{"before_d10_m", "before_m/d10"}, [](Row row) { return row.before.quantile(0.1); }},
         {Names{"before_d50_m", "before_m/d50"}, [](Row row) { return row.before.quantile(0.5); }},
         {Names{"before_d90_m", "before_m/d90"}, [](Row row) { return row.before.quantile(0.9); }},
         {Names{"after_d10_m", "after_m/d10"}, [](Row row) { return row.after.quantile(0.1); }},
         {Names{"after_d50_m", "after_m/d50"}, [](Row row) { return row.after.quantile(0.5); }},
         {Names{"after_d90_m", "after_m/d90"}, [](Row row) { return row.after.quantile(0.9); }}});
    Table table{{"case", "runs", "cracked through", "pieces each", "area, %", "D at start, m", "D at end, m"}};
    const auto three = [](const IceSizes& of) {
        return fmt::format("{}, {}, {}", fixed(of.quantile(0.1), 2), fixed(of.quantile(0.5), 2),
                           fixed(of.quantile(0.9), 2));
    };
    for (Row row : cases)
        table.push_back({evidence.summary.label_of(row.case_index), fmt::format("{}", row.runs), fixed(row.split, 1),
                         fixed(row.pieces, 1), fixed(row.in_pieces / unit::percent, 1), three(row.before),
                         three(row.after)});
    return {.title = "Sizes of the ice",
            .table = std::move(table),
            .after =
                "\nCracked through: floes in more than one piece, and the share of the area in their pieces. D: side "
                "of the square with the same area; three values, below which a tenth, half and nine tenths "
                "of the area are: of the floes as they came, and of floes and pieces at the end. Mean over members.\n",
            .records = {std::move(records)},
            .figures = {sizes_figure(evidence.summary, cases)}};
}

}  // namespace floes
