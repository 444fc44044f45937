#include "findings/json.hpp"

#include "core/units.hpp"
#include "findings/conditions.hpp"
#include "findings/formats.hpp"

namespace floes {

namespace {

Json interval_json(const Estimate& interval) {
    return {{"estimate", json_number(interval.estimate)},
            {"low", json_number(interval.low)},
            {"high", json_number(interval.high)},
            {"bca_low", json_number(interval.bca.low)},
            {"bca_high", json_number(interval.bca.high)},
            {"prediction_low", json_number(interval.prediction_low)},
            {"prediction_high", json_number(interval.prediction_high)}};
}

Json failures_json(const std::optional<FailureCounts>& failures) {
    if (!failures) return {{"bending", nullptr}, {"shear", nullptr}, {"compression", nullptr}};
    return {{"bending", failures->bending}, {"shear", failures->shear}, {"compression", failures->compression}};
}

Json conditions_json(const CaseRow& about) {
    return {
        {"structure_profile_m", about.shape.rows()},      {"far_end", far_end_key(about.far_end)},
        {"contact_erp", json_number(about.contact_erp)},  {"steady_start_s", json_number(about.analysis.steady_start)},
        {"window_s", json_number(about.analysis.window)}, {"segments", about.analysis.segments}};
}

Json case_json(const Summary& summary, std::size_t index, Reference reference) {
    const CaseSummary& row = summary.cases[index];
    Json json{{"name", row.about.name},
              {"cfm", json_number(row.about.cfm)},
              {"elastic_modulus_MPa", json_number(row.about.elastic_modulus / unit::megapascal)},
              {"members", row.members},
              {"failed_members", row.failed_members},
              {"missing_members", row.missing_members},
              {"not_steady", row.not_steady}};
    for (const Quantity& quantity : quantities) {
        json[std::string{quantity.key}] = interval_json(row.*quantity.interval);
    }
    json["failures"] = failures_json(row.failures);
    json["conditions"] = conditions_json(row.about);
    if (reference) {
        Json& differences = json["difference_percent"] = Json::object();
        for (const Quantity& quantity : quantities) {
            differences[std::string{quantity.key}] =
                json_number(difference_percent(summary, index, *reference, quantity));
        }
    }
    return json;
}

}  // namespace

Json summary_as_json(const Summary& summary, Reference reference) {
    Json json{{"campaign", summary.title}, {"complete", summary.complete()}};
    if (reference) json["reference"] = summary.cases.at(*reference).about.name;
    json["cases"] = Json::array();
    for (std::size_t index = 0; index < summary.cases.size(); ++index) {
        json["cases"].push_back(case_json(summary, index, reference));
    }
    return json;
}

std::string summary_json(const Summary& summary, Reference reference) {
    return summary_as_json(summary, reference).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace floes
