#include "findings/report_sections.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/units.hpp"
#include "findings/paper_table3.hpp"
#include "theory/hybrid_curve.hpp"

namespace floes {
namespace {

constexpr double drawn_moduli[]{3, 5, 7, 10, 14, 20, 30, 45, 60, 90, 130, 200, 300, 450, 700, 1000};  // MPa
constexpr double crossing_of_the_paper = 10 * unit::megapascal;                                       // Fig. 8

std::optional<HybridCurve> hybrid_of(const Scenario& scenario) {
    std::vector<double> moduli;
    for (const double modulus : drawn_moduli) moduli.push_back(modulus * unit::megapascal);
    try {
        return hybrid_curve(scenario, hybrid_model(scenario).crossing_at(crossing_of_the_paper), moduli);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

Figure hybrid_figure(const HybridCurve& curve, const Summary& summary, bool papers) {
    Figure::Points stress;
    Figure::Points momentum;
    Figure::Points lower;
    std::vector<double> loads;
    for (const HybridPoint& point : curve.points) {
        const double modulus = point.elastic_modulus / unit::megapascal;
        stress.emplace_back(modulus, point.limit_stress.total());
        momentum.emplace_back(modulus, point.limit_momentum);
        lower.emplace_back(modulus, point.load);
        loads.push_back(point.load);
    }
    for (const CaseSummary& row : summary.cases) loads.push_back(row.of(quantity("mean_load")).high);
    if (papers)
        for (const PaperRow& row : paper_table3) loads.push_back(row.mean);
    Figure figure{.description = fmt::format("Mean load over the elastic modulus: hybrid model, this campaign{}",
                                             papers ? ", the paper" : ""),
                  .x = {"elastic modulus E, MPa", lower.front().first, lower.back().first, true},
                  .y = axis_around("mean load, N", loads, true),
                  .size = {720, 360},
                  .legend = {{"c0", "Lindqvist × IC"}, {"c1", "KPR"}, {"ink", "hybrid"}, {"c2", "this campaign"}},
                  .caption =
                      "The hybrid model of Eqs. (6)-(7) (the paper's Fig. 8). KPR's coefficient k1 is chosen so "
                      "that both limits cross at 10 MPa as in the paper: its line is a calibration, not a "
                      "prediction."};
    figure.y.high *= 1.3;
    for (Figure::Points* points : {&stress, &momentum})
        std::erase_if(*points, [&](const auto& point) { return point.second > figure.y.high; });
    figure.line(std::move(stress), "c0 dashed");
    figure.line(std::move(momentum), "c1 dashed");
    figure.line(std::move(lower), "ink thick");
    for (const CaseSummary& row : summary.cases) {
        const double modulus = row.about.elastic_modulus / unit::megapascal;
        const Estimate& mean = row.of(quantity("mean_load"));
        figure.line({{modulus, mean.low}, {modulus, mean.high}}, "c2 thick");
        figure.dot(modulus, mean.estimate, "c2", 4.5);
    }
    if (!papers) return figure;
    for (const PaperRow& row : paper_table3) figure.cross(row.elastic_modulus_mpa, row.mean, "c3", 5);
    figure.dot(Experiment{}.elastic_modulus_mpa, Experiment{}.mean, "c4", 4.5);
    figure.legend.insert(figure.legend.end(), {{"c3", "the paper ×"}, {"c4", "experiment"}});
    return figure;
}

Figure modulus_figure(const std::vector<CurvePoint>& plate_tests, bool papers) {
    constexpr double least_cfm = 1e-4;  // start of the axis; smaller values are drawn at its edge
    std::vector<double> moduli{200};
    Figure::Points points;
    double largest_cfm = 0.1;
    for (const CurvePoint& point : plate_tests) {
        points.emplace_back(std::max(point.cfm, least_cfm), point.elastic_modulus / unit::megapascal);
        moduli.push_back(points.back().second);
        largest_cfm = std::max(largest_cfm, point.cfm);
    }
    Figure figure{.description = "Elastic modulus over constraint force mixing",
                  .x = {"constraint force mixing Σ (1e-10 at the left edge)", least_cfm, largest_cfm, true},
                  .y = axis_around("elastic modulus E, MPa", moduli, true),
                  .legend = {{"c0", "plate tests of this ice"}},
                  .caption =
                      "Elastic modulus of this ice in a plate test over Σ (the paper's Fig. 2), on a sheet of "
                      "13 x 13 elements."};
    figure.line(points, "c0");
    for (const auto& [cfm, modulus] : points) figure.dot(cfm, modulus, "c0");
    if (!papers) return figure;
    for (const PaperRow& row : paper_table3)
        figure.cross(std::max(row.cfm, least_cfm), row.elastic_modulus_mpa, "c1", 5);
    figure.legend.emplace_back("c1", "the paper's pairs ×");
    return figure;
}

}  // namespace

Section closed_formulas_section(Evidence& evidence) {
    const Scenario& first = evidence.campaign.cases.front().scenario;
    const bool papers = is_the_papers(first);
    Section section;
    if (evidence.campaign.cases.size() > 1)
        section.before = fmt::format(
            "The formulas and the plate tests are of the ice and the structure of {}; the other cases stand beside "
            "them with their own.\n",
            evidence.summary.label_of(0));
    if (const std::optional<HybridCurve> curve = hybrid_of(first))
        section.figures.push_back(hybrid_figure(*curve, evidence.summary, papers));
    if (!evidence.plate_tests.empty()) section.figures.push_back(modulus_figure(evidence.plate_tests, papers));
    return section;
}

}  // namespace floes
