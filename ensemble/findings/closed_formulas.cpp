#include "findings/closed_formulas.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/units.hpp"
#include "findings/cases.hpp"
#include "findings/sections.hpp"

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

ResultColumn modulus_column() {
    return {.key = "elastic_modulus_MPa", .words = "E, MPa", .digits = 4};
}

/// A load of which each value is shown with three digits: they differ by orders of magnitude.
ResultColumn load_column(std::string key, std::string words) {
    return {.key = std::move(key), .words = std::move(words), .unit = "N", .digits = 3};
}

std::string rubble_words(const Rubble& rubble) {
    return fmt::format(
        "rubble {:.3g} m high, porosity {:g}, angle {:.3g}°, friction angle {:.3g}°, cohesion {:g} kPa; ice on ice "
        "{:g}",
        rubble.height, rubble.porosity, rubble.angle / unit::degree, rubble.friction_angle / unit::degree,
        rubble.cohesion / unit::kilopascal, rubble.ice_friction);
}

/// What was put into ISO's formulas, and the load of crushing, for programs.
std::vector<Results> inputs_of(const Rubble& rubble, double strength, double crushing) {
    return {object("sloping/rubble", {{"height", rubble.height},
                                      {"porosity", rubble.porosity},
                                      {"angle_deg", rubble.angle / unit::degree},
                                      {"friction_angle_deg", rubble.friction_angle / unit::degree},
                                      {"cohesion_kPa", rubble.cohesion / unit::kilopascal},
                                      {"ice_friction", rubble.ice_friction}}),
            object("crushing", {{"strength_MPa", strength / unit::megapascal}, {"load", crushing}})};
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
                  .y = axis_around("mean load", loads, true, "N"),
                  .size = {720, 360},
                  .legend = {{"c0", "Lindqvist × IC"}, {"c1", "KPR"}, {"ink", "hybrid"}, {"c2", "this campaign"}},
                  .caption =
                      "The hybrid model. KPR's coefficient k1 is chosen so that "
                      "both limits cross at 10 MPa: its line is a calibration, not a prediction."};
    figure.y.high *= 1.3;
    for (Figure::Points* points : {&stress, &momentum})
        std::erase_if(*points, [&](const auto& point) { return point.second > figure.y.high; });
    figure.line(std::move(stress), "c0 dashed");
    figure.line(std::move(momentum), "c1 dashed");
    figure.line(std::move(lower), "ink thick");
    for (const CaseSummary& row : summary.cases) {
        const double modulus = row.about.elastic_modulus / unit::megapascal;
        const CaseEstimate& mean = row.of(quantity("mean_load"));
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
                  .caption = "Elastic modulus of this ice in a plate test over Σ, on a sheet of 13 x 13 elements."};
    figure.line(points, "c0");
    for (const auto& [cfm, modulus] : points) figure.dot(cfm, modulus, "c0");
    if (!papers) return figure;
    for (const PaperRow& row : paper_table3)
        figure.cross(std::max(row.cfm, least_cfm), row.elastic_modulus_mpa, "c1", 5);
    figure.legend.emplace_back("c1", "the paper's pairs ×");
    return figure;
}

}  // namespace

Section hybrid_section(const HybridCurve& curve) {
    Results rows{.place = "rows",
                 .columns = {modulus_column(),
                             {.key = "characteristic_length", .words = "l_c", .unit = "m", .decimals = 3},
                             load_column("limit_stress", "R_LS"),
                             load_column("crushing", "= crushing"),
                             load_column("bending", "+ bending"),
                             load_column("submergence", "+ submergence"),
                             load_column("limit_momentum", "R_LM"),
                             load_column("hybrid", "R_F")}};
    for (const HybridPoint& p : curve.points)
        rows.add({p.elastic_modulus / unit::megapascal, p.characteristic_length, p.limit_stress.total(),
                  p.limit_stress.crushing, p.limit_stress.bending, p.limit_stress.submergence, p.limit_momentum,
                  p.load});
    const KprCoefficients& kpr = curve.coefficients;
    Results about =
        object("", {{"crossing_MPa", curve.crossing ? Datum(*curve.crossing / unit::megapascal) : Datum(Undefined{})},
                    {"wall_deg", curve.hull.stem_angle / unit::degree},
                    {"kpr_coefficients/0", kpr.static_part},
                    {"kpr_coefficients/1", kpr.dissipative},
                    {"kpr_coefficients/2", kpr.impact}});
    const std::string crossing = curve.crossing
                                     ? fmt::format("floes break above {:.4g} MPa and are pushed aside below it",
                                                   *curve.crossing / unit::megapascal)
                                     : "floes are pushed aside at any modulus";
    return {
        .results = {std::move(rows), std::move(about)},
        .after = fmt::format("\n{}\nKPR coefficients k1 = {:.4g}, k2 = {:g}, k3 = {:g}: chosen, no source gives them\n",
                             crossing, kpr.static_part, kpr.dissipative, kpr.impact)};
}

Rubble rubble_on(const Scenario& scenario) {
    Rubble rubble;
    rubble.height = 3 * scenario.floe.thickness;
    rubble.angle = std::min(rubble.angle, hull_of(scenario).stem_angle);
    rubble.ice_friction = scenario.contact.ice_ice_friction;
    return rubble;
}

Section sloping_section(const Scenario& scenario, std::span<const double> moduli, const SlopingRequest& request,
                        const Units& units) {
    const IceHull hull = hull_of(scenario);
    check_rubble(request.rubble, hull.stem_angle);
    LevelIce ice = level_ice_of(scenario);
    const double crushing = crushing_load(hull.breadth, ice.thickness, request.crushing_strength);
    Results rows{.place = "sloping/rows",
                 .columns = {modulus_column(),
                             load_column("load", "sloping"),
                             load_column("breaking", "H_B"),
                             load_column("pushing", "H_P"),
                             load_column("lifting", "H_L"),
                             load_column("ride_up", "H_R"),
                             load_column("turning", "H_T"),
                             {.key = "thrust", .words = "thrust", .decimals = 3}},
                 .in_csv = false};
    std::string refusal;
    try {
        for (const double modulus : moduli) {
            ice.elastic_modulus = modulus;
            const SlopingLoad load = sloping_load(hull, ice, request.rubble);
            rows.add({modulus / unit::megapascal, load.total(), load.breaking, load.pushing, load.lifting, load.ride_up,
                      load.turning, load.thrust});
        }
    } catch (const InputError& none) {
        refusal = fmt::format("{}\n", none.what());
    }
    Section section{
        .title = "Level ice without an end, by ISO 19906",
        .before = refusal,
        .results = inputs_of(request.rubble, request.crushing_strength, crushing),
        .after = fmt::format("\nSloping wall, (H_B + H_P + H_L + H_R + H_T) x thrust: breaking the sheet, pushing it "
                             "through the rubble, lifting rubble, blocks up the wall, turning them at its top; {}. "
                             "Crushing on a vertical wall of the same breadth with C_R {:g} MPa: {}.\nFor a sheet that "
                             "is wide and goes on coming; not for floes (no concentration), round hulls or tanks.\n",
                             rubble_words(request.rubble), request.crushing_strength / unit::megapascal,
                             units.text(crushing, "N"))};
    section.results.insert(section.results.begin(), std::move(rows));
    return section;
}

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
