#include "findings/hybrid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/units.hpp"
#include "tables/number_text.hpp"

namespace floes {

namespace {

/// Three digits or, of a larger number, its whole part.
std::string three_digits(double value) {
    return fixed(value, value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : 3);
}

std::string crossing_text(const HybridCurve& curve) {
    return curve.crossing ? fmt::format("floes break above {:.4g} MPa and are pushed aside below it\n",
                                        *curve.crossing / unit::megapascal)
                          : "floes are pushed aside at any modulus\n";
}

std::vector<DataRows> records_of(const HybridCurve& curve) {
    using Row = const HybridPoint&;
    const std::array coefficients{curve.coefficients.static_part, curve.coefficients.dissipative,
                                  curve.coefficients.impact};
    std::vector<DataColumn<HybridCurve>> about{
        {Names{"", "crossing_MPa"},
         [](const HybridCurve& one) { return one.crossing ? Datum(*one.crossing / unit::megapascal) : Undefined{}; }},
        {Names{"", "wall_deg"}, [](const HybridCurve& one) { return one.hull.stem_angle / unit::degree; }}};
    for (std::size_t k = 0; k < coefficients.size(); ++k)
        about.push_back(
            {Names{"", fmt::format("kpr_coefficients/{}", k)}, [=](const HybridCurve&) { return coefficients[k]; }});
    return {
        make_rows<HybridPoint>("rows", curve.points,
                               {{"elastic_modulus_MPa", [](Row row) { return row.elastic_modulus / unit::megapascal; }},
                                {"limit_stress_N", [](Row row) { return row.limit_stress.total(); }},
                                {"limit_momentum_N", &HybridPoint::limit_momentum},
                                {"hybrid_N", &HybridPoint::load},
                                {"crushing_N", [](Row row) { return row.limit_stress.crushing; }},
                                {"bending_N", [](Row row) { return row.limit_stress.bending; }},
                                {"submergence_N", [](Row row) { return row.limit_stress.submergence; }},
                                {"characteristic_length_m", &HybridPoint::characteristic_length}}),
        make_object("", curve, about)};
}

}  // namespace

Section hybrid_section(const HybridCurve& curve) {
    double largest = 0;
    for (const HybridPoint& p : curve.points) largest = std::max(largest, p.load);
    const LoadUnit unit = load_unit(largest);
    const auto in_unit = [&](const char* name) { return fmt::format("{}, {}", name, unit.name); };
    Table table{{"E, MPa", "l_c, m", in_unit("R_LS"), "= crushing", "+ bending", "+ submergence", in_unit("R_LM"),
                 in_unit("R_F")}};
    for (const HybridPoint& p : curve.points) {
        const auto newtons = [&](double force) { return three_digits(unit.factor * force); };
        table.push_back({fmt::format("{:.4g}", p.elastic_modulus / unit::megapascal),
                         fmt::format("{:.3f}", p.characteristic_length), newtons(p.limit_stress.total()),
                         newtons(p.limit_stress.crushing), newtons(p.limit_stress.bending),
                         newtons(p.limit_stress.submergence), newtons(p.limit_momentum), newtons(p.load)});
    }
    return {
        .table = std::move(table),
        .after = "\n" + crossing_text(curve) +
                 fmt::format("KPR coefficients k1 = {:.4g}, k2 = {:g}, k3 = {:g}: chosen, no source gives them\n",
                             curve.coefficients.static_part, curve.coefficients.dissipative, curve.coefficients.impact),
        .records = records_of(curve)};
}

}  // namespace floes
