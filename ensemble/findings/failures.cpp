// How ice fails: joints by mode over time and along the floes, and how large the ice is before and after.

#include "findings/sections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "core/units.hpp"
#include "ice/failure_mode.hpp"
#include "scenario/floes.hpp"

namespace floes {

namespace {

struct Stroke {
    const char* style;
    const char* words;
};

/// For each mode, the same in every report.
constexpr std::array<Stroke, failure_mode_names.size()> strokes{{{"", "solid line"},
                                                                 {" dashed", "dashed"},
                                                                 {" dotted", "dotted"},
                                                                 {" thin", "thin"},
                                                                 {" thin dashed", "thin dashed"},
                                                                 {" thin dotted", "thin dotted"}}};

/// A value that is 0 from `begin` on and that of each step from there on, up to `end`.
Figure::Points stairs(double begin, const Figure::Points& steps, double end) {
    Figure::Points points{{begin, 0}};
    for (const auto& [x, value] : steps) {
        points.emplace_back(x, points.back().second);
        points.emplace_back(x, value);
    }
    points.emplace_back(end, points.back().second);
    return points;
}

/// Failures so far over time; `runs` of them are averaged.
Figure::Points failures_so_far(std::vector<double> times, int runs) {
    std::ranges::sort(times);
    Figure::Points steps;
    for (const double time : times) steps.emplace_back(time, static_cast<double>(steps.size() + 1) / runs);
    return steps;
}

/// "bending", "in-plane bending"; `mode` as in BreakRow.
std::string mode_name(int mode) {
    return mode == static_cast<int>(FailureMode::in_plane_bending)
               ? "in-plane bending"
               : failure_mode_names.at(static_cast<std::size_t>(mode));
}

/// How often joints failed in one floe of one member of a case, 0 to 1, by where they are: in fields of half an
/// element, row after row.
struct CaseFailures {
    std::string name;
    FloeShape floe;
    int floes;
    int columns, rows;
    std::vector<double> joints;       ///< in each field, of all floes
    std::vector<double> failed;       ///< of them, in a member
    std::map<int, double> of_mode{};  ///< sum over the joints of a floe
    double total = 0;

    std::size_t field_of(const Corner& at) const {
        const auto place = [](double share, int count) {
            return std::clamp(static_cast<int>(share * count), 0, count - 1);
        };
        return static_cast<std::size_t>(place(0.5 + at.x / floe.length, columns) +
                                        columns * place(0.5 + at.z / floe.breadth, rows));
    }
    double share(std::size_t field) const { return joints[field] > 0 ? failed[field] / joints[field] : 0; }
};

/// None where floes differ in more than their elements, from each other or from one arrangement to the next: their
/// places are not the same. Nor in a field without end if they differ in these: floes are numbered as they enter it,
/// and not as they are drawn. Nor in level ice without end, which is not one floe.
std::optional<CaseFailures> failures_of(Evidence& evidence, std::size_t of_case) {
    const Scenario& scenario = evidence.campaign.cases[of_case].scenario;
    const FloeSet floes = floes_of(scenario);
    if (!floes.alike() || (scenario.shapes.any() && !scenario.shapes.from_file())) return std::nullopt;
    if (scenario.field.endless() && (floes.shapes.size() > 1 || scenario.arrangement.level())) return std::nullopt;
    const CaseSummary& row = evidence.summary.cases[of_case];
    const FloeShape& floe = floes.shapes.front();
    const auto count = [&](double extent) {
        return std::max(1, static_cast<int>(std::lround(2 * extent / floe.element)));
    };
    const int columns = count(floe.length);
    const int rows = count(floe.breadth);
    const std::vector<double> none(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0.0);
    CaseFailures found{
        evidence.summary.label_of(of_case), floe, static_cast<int>(floes.size()), columns, rows, none, none};
    std::vector<std::vector<std::size_t>> fields;  // of the joints of each shape
    for (const FloeShape& shape : floes.shapes) {
        std::vector<std::size_t>& of_joint = fields.emplace_back();
        for (const CutJoint& one : shape.cut().joints) of_joint.push_back(found.field_of(one.pivot));
    }
    for (const Floe& one : floes.floes)
        for (const std::size_t field : fields[one.shape]) found.joints[field] += 1;
    double entered = 0;  // of a field without end more than it was laid with at once
    for (const std::size_t member : evidence.sample.done(of_case))
        entered += evidence.sample.value(member, quantity("floes_entered")) / row.done;
    if (entered > 0)
        for (double& joints : found.joints) joints *= entered / found.floes;
    const double share = 1.0 / row.done / found.floes;
    for (const BreakRow& one : breaks_of(evidence)) {
        if (evidence.case_of(one.member) != of_case) continue;
        const std::size_t shape = floes.floes[static_cast<std::size_t>(one.floe) % floes.size()].shape;
        found.failed[fields[shape].at(static_cast<std::size_t>(one.joint))] += 1.0 / row.done;
        found.of_mode[one.mode] += share;
        found.total += share;
    }
    return found;
}

/// "soft: 5.2 joints failed in a member: bending 97 %, shear 3 %.", the most frequent mode first.
std::string sentence(const CaseFailures& found) {
    std::vector<std::pair<double, int>> sorted;
    for (const auto& [mode, share] : found.of_mode) sorted.emplace_back(share, mode);
    std::ranges::sort(sorted, std::ranges::greater{});
    std::string words;
    for (const auto& [share, mode] : sorted)
        words += fmt::format("{}{} {:.0f} %", words.empty() ? "" : ", ", mode_name(mode),
                             share / found.total / unit::percent);
    return fmt::format("{}: {:.1f} joints failed in a member: {}.", found.name, found.total * found.floes, words);
}

/// The floe with each field in the shade of how often its joints failed; `largest` is the darkest.
Figure panel(const CaseFailures& found, double largest) {
    constexpr std::size_t most_numbers = 40;  // more have no room
    constexpr double widest = 188;            // three panels stand side by side
    const FloeShape& floe = found.floe;
    const double half_length = 0.55 * floe.length;
    const double half_breadth = 0.55 * floe.breadth;
    const double scale = widest / 2 / std::max(half_length, half_breadth);
    Figure figure{
        .description = fmt::format("Case {}: how often the joints of a floe failed", found.name),
        .x = {fmt::format("{}: along the floe, m", found.name), -half_length, half_length, false, {}, floe.length / 2},
        .y = {"across, m", -half_breadth, half_breadth, false, {}, floe.breadth / 2},
        .size = {std::max(268.0, 80 + 2 * scale * half_length), 74 + 2 * scale * half_breadth},
        .heat_scale = fmt::format("up to {:.1f} %", largest / unit::percent)};
    Figure::Points rim;
    for (const Corner& corner : floe.corners()) rim.emplace_back(corner.x, corner.z);
    figure.area(std::move(rim), "ice");
    const double wide = floe.length / found.columns;
    const double high = floe.breadth / found.rows;
    for (std::size_t field = 0; field < found.joints.size(); ++field) {
        if (found.joints[field] == 0) continue;
        const double x = -floe.length / 2 + wide * static_cast<double>(field % static_cast<std::size_t>(found.columns));
        const double z =
            -floe.breadth / 2 + high * static_cast<double>(field / static_cast<std::size_t>(found.columns));
        figure.cell(x + 0.04 * wide, z + 0.04 * high, 0.92 * wide, 0.92 * high, found.share(field) / largest, "heat");
        if (found.joints.size() <= most_numbers)
            figure.text(x + wide / 2, z + 0.44 * high, fmt::format("{:.1f}", found.share(field) / unit::percent),
                        "middle", "key");
    }
    return figure;
}

}  // namespace

Section failures_section(Evidence& evidence) {
    const auto& cases = evidence.summary.cases;
    std::map<int, std::map<std::size_t, std::vector<double>>> times;  // by mode and case
    for (const BreakRow& row : breaks_of(evidence)) times[row.mode][evidence.case_of(row.member)].push_back(row.time);
    if (times.empty()) return {.before = "No joint failed in any member.\n"};
    Figure figure{.description = "Failed joints over time by mode, mean over arrangements",
                  .x = {"time since the tow began, s", 0, 1},
                  .legend = case_legend(evidence.summary),
                  .caption = "Failed joints so far, mean over arrangements"};
    for (const CaseSummary& row : cases)
        figure.x.high = std::max(figure.x.high, row.about.analysis.steady_start + row.about.analysis.window);
    std::vector<double> counts{1};
    for (auto& [mode, of_cases] : times) {
        const Stroke& stroke = strokes.at(static_cast<std::size_t>(mode));
        for (auto& [of_case, failed] : of_cases) {
            counts.push_back(static_cast<double>(failed.size()) / cases[of_case].done);
            figure.line(stairs(0, failures_so_far(std::move(failed), cases[of_case].done), figure.x.high),
                        colour(of_case) + stroke.style);
        }
        figure.caption += times.size() == 1 ? fmt::format("; all failed in {}", mode_name(mode))
                                            : fmt::format("{} {} {}", mode == times.begin()->first ? ":" : ",",
                                                          stroke.words, mode_name(mode));
    }
    figure.caption += ".";
    figure.y = axis_around("failed joints per run", counts, true);
    return {.figures = {std::move(figure)}};
}

Section joint_failures_section(Evidence& evidence) {
    std::vector<CaseFailures> cases;
    double largest = 0;
    for (const std::size_t k : drawn_cases(evidence.summary)) {
        std::optional<CaseFailures> found = failures_of(evidence, k);
        if (!found) continue;
        cases.push_back(std::move(*found));
        for (std::size_t field = 0; field < cases.back().joints.size(); ++field)
            largest = std::max(largest, cases.back().share(field));
    }
    Section section;
    if (largest == 0) return section;
    for (const CaseFailures& found : cases) {
        section.figures.push_back(panel(found, largest));
        if (found.total > 0) section.notes.push_back(sentence(found));
    }
    section.figures.back().caption =
        "How often joints failed by where they are in the floe, % of the joints there of all floes of all members; "
        "floes lie at every angle to the tow. All cases have the same colours." +
        undrawn_text(evidence.summary);
    return section;
}

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

/// For each member; drawn again where outlines differ from one arrangement to the next.
FloeAreas floe_areas(const Campaign& campaign) {
    std::vector<std::vector<double>> of_cases;
    for (const Case& one : campaign.cases) of_cases.push_back(areas_of(floes_of(one.scenario)));
    return [&campaign, of_cases](int member) {
        const MemberKey key = member_key(campaign, member);
        const auto of_case = static_cast<std::size_t>(key.case_index);
        const Scenario& scenario = campaign.cases[of_case].scenario;
        if (scenario.arrangement.level() && scenario.field.endless()) return std::vector<double>{};
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
    for (const SizesOfCase& one : cases)
        for (const auto& [sizes, style] : {std::pair(&one.before, " dashed"), std::pair(&one.after, "")})
            figure.line(stairs(figure.x.low, sizes->steps(), figure.x.high), colour(one.case_index) + style);
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

std::vector<SizesOfCase> find_piece_sizes(const Sample& sample, std::span<const PieceRow> pieces,
                                          const FloeAreas& floes) {
    std::vector<SizesOfCase> cases(sample.cases.size());
    for (std::size_t k = 0; k < cases.size(); ++k) cases[k].case_index = k;
    for (int number = 0; number < static_cast<int>(sample.members()); ++number) {
        const auto member = static_cast<std::size_t>(number);
        if (sample.status(member) != RowStatus::done) continue;
        SizesOfCase& sizes = cases[sample.case_of(member)];
        const std::vector<double> areas = floes(number);
        if (areas.empty()) continue;
        ++sizes.runs;
        // Every part of a field without end has floes of the same sizes. Files before 1.13 do not count them.
        const double entered = sample.value(member, quantity("floes_entered"));
        const double parts = entered > 0 ? entered / static_cast<double>(areas.size()) : 1.0;
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
    const Section nothing{.missing =
                              "Sizes of the ice: as at the start, or not kept; no floe is known to be in pieces.\n"};
    if (pieces.empty()) return nothing;
    const std::vector<SizesOfCase> cases = find_piece_sizes(evidence.sample, pieces, floe_areas(evidence.campaign));
    if (cases.empty()) return nothing;
    Results results{.place = "ice_sizes",
                    .columns = {{"case", "case"},
                                {"runs", "runs"},
                                {.key = "floes_cracked_through", .words = "cracked through", .decimals = 1},
                                {.key = "pieces_of_one", .words = "pieces each", .decimals = 1},
                                {.key = "area_in_pieces", .words = "area", .unit = "share", .decimals = 1}}};
    constexpr std::array<std::pair<const char*, double>, 3> quantiles{{{"d10", 0.1}, {"d50", 0.5}, {"d90", 0.9}}};
    for (const char* when : {"before", "after"})
        for (const auto& [name, share] : quantiles)
            results.columns.push_back({.key = fmt::format("{}_{}", when, name),
                                       .words = fmt::format("D{:.0f} {}", 100 * share, when),
                                       .unit = "m",
                                       .decimals = 2});
    for (const SizesOfCase& sizes : cases) {
        std::vector<Datum> row{evidence.summary.named(sizes.case_index), sizes.runs, sizes.split, sizes.pieces,
                               sizes.in_pieces};
        for (const IceSizes* ice : {&sizes.before, &sizes.after})
            for (const auto& [name, share] : quantiles) row.emplace_back(ice->quantile(share));
        results.add(std::move(row));
    }
    return {.title = "Sizes of the ice",
            .results = {std::move(results)},
            .after =
                "\nCracked through: floes in more than one piece, and the share of the area in their pieces. D: side "
                "of the square with the same area; D10, D50 and D90: below which a tenth, half and nine tenths of the "
                "area are, of the floes as they came and of floes and pieces at the end. Mean over members.\n",
            .figures = {sizes_figure(evidence.summary, cases)}};
}

}  // namespace floes
