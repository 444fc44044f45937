#include "campaign_file/campaign_content.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "campaign_file/followed_cfm.hpp"

namespace floes {
namespace {

using hdf5::Handle;

template <class Value, class Function>
std::vector<Value> of_cases(const CampaignContent& content, Function function) {
    std::vector<Value> values;
    for (const Case& one : content.campaign.cases) values.push_back(function(one.scenario));
    return values;
}

/// A column each of the rows of the cases' shapes, filled up with NaN.
void write_shapes(hid_t group, const CampaignContent& content, const CampaignScales& scales) {
    const std::size_t points = scales.profile_point.size();
    for (std::size_t column = 0; column < Shape::columns.size(); ++column) {
        const auto& [name, unit, text, low, high] = Shape::columns[column];
        std::vector<double> values(scales.case_.size() * points, nan);
        for (std::size_t k = 0; k < content.table().cases.size(); ++k) {
            const std::vector<std::vector<double>> rows = content.table().cases[k].shape.profile();
            for (std::size_t p = 0; p < rows.size(); ++p) values[k * points + p] = rows[p][column];
        }
        hdf5::write_values(group, {fmt::format("profile_{}", name), std::string(unit), std::string(text)},
                           {scales.case_, scales.profile_point}, values);
    }
}

}  // namespace

void write_cases(hid_t file, const CampaignContent& content, const CampaignScales& scales) {
    const Handle group = hdf5::create_group(file, "cases");
    const hid_t id = group.id();
    const hdf5::Dimensions one{scales.case_};
    std::vector<std::string> names;
    for (const CaseRow& row : content.table().cases) names.push_back(row.name);
    hdf5::write_values(id, {"name", "1", "name of the case"}, one, names);
    hdf5::write_values(id, {"hull", "1", "shape of the structure, in words"}, one,
                       of_cases<std::string>(content, [](const Scenario& s) { return s.structure.shape.words(); }));
    hdf5::write_values(id, {"parts", "1", "parts of the structure in the order of /parts, divided by commas"}, one,
                       of_cases<std::string>(content, [](const Scenario& s) {
                           return fmt::format("{}", fmt::join(s.structure.shape.parts(), ","));
                       }));
    const auto real = [&](const char* name, const char* unit, const char* long_name, auto function) {
        hdf5::write_values(id, {name, unit, long_name}, one, of_cases<double>(content, function));
    };
    real("cfm", "1", "constraint force mixing of the joints (Sigma); NaN for beam joints",
         [](const Scenario& s) { return followed_cfm(s.joint); });
    real("elastic_modulus", "Pa", "elastic modulus that the case stands for",
         [](const Scenario& s) { return s.ice.elastic_modulus; });
    real("contact_erp", "1", "error reduction parameter of contacts (Gamma)",
         [](const Scenario& s) { return s.contact.erp; });
    real("crushing_pressure", "Pa", "pressure at which edges crush, where they do",
         [](const Scenario& s) { return s.contact_law().crushing_pressure; });
    const auto choice = [&](const char* name, const char* long_name, const std::string& words, auto function) {
        const auto number = [&](const Scenario& s) { return static_cast<std::int8_t>(function(s)); };
        std::vector<std::int8_t> values(1 + static_cast<std::size_t>(std::ranges::count(words, ' ')));
        std::iota(values.begin(), values.end(), std::int8_t{0});
        hdf5::write_values(id, {name, "1", long_name}, one, of_cases<std::int8_t>(content, number),
                           hdf5::Flags{values, words});
    };
    choice("friction", "where friction points", fmt::format("{}", fmt::join(friction_words, " ")),
           [](const Scenario& s) { return s.contact.friction; });
    choice("contact_law", "what bounds the force along the normal", fmt::format("{}", fmt::join(normal_law_words, " ")),
           [](const Scenario& s) { return s.contact.normal; });
    choice("internal_edges", "whether edges inside a body act", "do_not_act act",
           [](const Scenario& s) { return s.contact.internal_edges; });
    real("time_step", "s", "time step", [](const Scenario& s) { return s.general.time_step; });
    real("steady_start", "s", "begin of the analysis window",
         [](const Scenario& s) { return s.analysis.steady_start; });
    real("window", "s", "length of the analysis window", [](const Scenario& s) { return s.analysis.window; });
    real("peak_separation", "s", "time between peaks of the averaged load that count as two",
         [](const Scenario& s) { return s.analysis.peak_separation; });
    hdf5::write_values(id, {"segments", "1", "equal parts of the analysis window"}, one,
                       of_cases<std::int32_t>(content, [](const Scenario& s) { return s.analysis.segments; }));
    hdf5::write_values(id, {"history_stride", "1", "successive steps whose mean is one value of /history"}, one,
                       of_cases<std::int32_t>(content, [](const Scenario& s) { return s.analysis.history_stride; }));
    choice("far_end", "what stands behind the ice field", "ice_sheet open never",
           [](const Scenario& s) { return s.field.far_end; });
    write_shapes(id, content, scales);
}

}  // namespace floes
