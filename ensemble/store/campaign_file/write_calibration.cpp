#include "campaign_file/campaign_content.hpp"

namespace floes {
namespace {

struct Row {
    std::int32_t case_index;
    const CurvePoint* point;
};

std::vector<Row> calibration_rows(const CampaignContent& content, std::span<const CalibrationRecord> calibrations) {
    std::vector<Row> rows;
    const std::vector<const Calibration*> of_case = match_calibrations(content.campaign, calibrations);
    for (std::size_t k = 0; k < of_case.size(); ++k) {
        if (of_case[k] == nullptr) continue;
        for (const CurvePoint& point : of_case[k]->curve) rows.push_back({static_cast<std::int32_t>(k), &point});
    }
    return rows;
}

}  // namespace

void write_calibration(hid_t file, const CampaignContent& content, std::span<const CalibrationRecord> calibrations) {
    const std::vector<Row> rows = calibration_rows(content, calibrations);
    if (rows.empty()) return;
    const hdf5::Scale scale =
        hdf5::write_index_scale(file, "calibration_point", "plate test, a row of /calibration", rows.size());
    const hdf5::Handle group = hdf5::create_group(file, "calibration");
    const auto integers = [&](const char* name, const char* long_name, auto function) {
        std::vector<std::int32_t> values;
        for (const Row& row : rows) values.push_back(function(row));
        hdf5::write_values(group.id(), {name, "1", long_name}, {scale}, values);
    };
    const auto reals = [&](const char* name, const char* unit, const char* long_name, double CurvePoint::*field) {
        std::vector<double> values;
        for (const Row& row : rows) values.push_back(row.point->*field);
        hdf5::write_values(group.id(), {name, unit, long_name}, {scale}, values);
    };
    integers("case", "case that the test calibrated", [](const Row& row) { return row.case_index; });
    reals("sheet", "m", "side of the square sheet", &CurvePoint::sheet);
    reals("element", "m", "side of its elements", &CurvePoint::element);
    reals("thickness", "m", "thickness of the sheet", &CurvePoint::thickness);
    reals("time_step", "s", "time step", &CurvePoint::time_step);
    reals("erp", "1", "error reduction parameter of the joints (Gamma)", &CurvePoint::erp);
    integers("iterations", "iterations of the solver a step", [](const Row& row) { return row.point->iterations; });
    reals("cfm", "1", "constraint force mixing of the joints (Sigma)", &CurvePoint::cfm);
    reals("slope", "N m-1", "load over deflection at the centre", &CurvePoint::slope);
    reals("elastic_modulus", "Pa", "elastic modulus shown, load on a patch", &CurvePoint::elastic_modulus);
    reals("elastic_modulus_point", "Pa", "elastic modulus shown, as if the load were a point",
          &CurvePoint::elastic_modulus_point);
}

}  // namespace floes
