#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "campaign/read.hpp"
#include "campaign_file/campaign_kind.hpp"
#include "campaign_file/read_campaign_file.hpp"
#include "core/error.hpp"
#include "hdf5/read.hpp"

namespace floes {
namespace {

using hdf5::Handle;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<Shape> read_shapes(hid_t file, std::size_t cases) {
    std::vector<std::vector<double>> columns;
    for (const ShapeColumn& column : Shape::columns)
        columns.push_back(hdf5::read_values<double>(file, fmt::format("cases/profile_{}", column.name).c_str()));
    const std::size_t points = cases == 0 ? 0 : columns.front().size() / cases;
    std::vector<Shape> shapes;
    for (std::size_t k = 0; k < cases; ++k) {
        std::vector<std::vector<double>> rows;
        for (std::size_t p = k * points; p < (k + 1) * points; ++p) {
            if (std::isnan(columns.front().at(p))) continue;  // of a case with fewer rows than others
            std::vector<double>& row = rows.emplace_back();
            for (const std::vector<double>& column : columns) row.push_back(column.at(p));
        }
        shapes.push_back(Shape::of_rows(rows));
    }
    return shapes;
}

/// Files before layout 1.5 say the laws in their configuration only.
std::vector<ContactLaw> configured_contacts(hid_t file) {
    const std::string text = hdf5::read_texts(file, "provenance/configuration").at(0);
    std::vector<ContactLaw> laws;
    for (const Case& one : read_campaign({text, "its configuration", {}}, nullptr).cases) {
        laws.push_back(one.scenario.contact_law());
    }
    return laws;
}

std::vector<ContactLaw> read_contacts(hid_t file) {
    if (!hdf5::exists(file, "cases/contact_law")) return configured_contacts(file);
    std::vector<ContactLaw> laws;
    for (const double erp : hdf5::read_values<double>(file, "cases/contact_erp")) laws.push_back({.erp = erp});
    const auto friction = hdf5::read_values<std::int8_t>(file, "cases/friction");
    const auto normal = hdf5::read_values<std::int8_t>(file, "cases/contact_law");
    const auto pressure = hdf5::read_values<double>(file, "cases/crushing_pressure");
    const auto internal_edges = hdf5::read_values<std::int8_t>(file, "cases/internal_edges");
    for (std::size_t k = 0; k < laws.size(); ++k) {
        laws[k].friction = static_cast<Friction>(friction.at(k));
        laws[k].normal = static_cast<NormalLaw>(normal.at(k));
        laws[k].crushing_pressure = pressure.at(k);
        laws[k].internal_edges = internal_edges.at(k) != 0;
    }
    return laws;
}

std::vector<CaseRow> read_cases(hid_t file) {
    const auto names = hdf5::read_texts(file, "cases/name");
    const auto cfm = hdf5::read_values<double>(file, "cases/cfm");
    const auto modulus = hdf5::read_values<double>(file, "cases/elastic_modulus");
    const auto far_end = hdf5::read_values<std::int8_t>(file, "cases/far_end");
    const std::vector<ContactLaw> contacts = read_contacts(file);
    const std::vector<Shape> shapes = read_shapes(file, names.size());
    const auto steady_start = hdf5::read_values<double>(file, "cases/steady_start");
    const auto window = hdf5::read_values<double>(file, "cases/window");
    const auto segments = hdf5::read_values<std::int32_t>(file, "cases/segments");
    const auto time_step = hdf5::read_values<double>(file, "cases/time_step");
    std::vector<std::int32_t> stride(names.size(), 1);  // of files before layout 1.3
    if (hdf5::exists(file, "cases/history_stride"))
        stride = hdf5::read_values<std::int32_t>(file, "cases/history_stride");
    std::vector<double> separation(names.size(), Analysis{}.peak_separation);  // of files before layout 1.6
    if (hdf5::exists(file, "cases/peak_separation"))
        separation = hdf5::read_values<double>(file, "cases/peak_separation");
    std::vector<CaseRow> cases;
    for (std::size_t k = 0; k < names.size(); ++k) {
        CaseRow& row = cases.emplace_back();
        row.name = names[k];
        row.cfm = cfm.at(k);
        row.elastic_modulus = modulus.at(k);
        row.far_end = static_cast<FarEnd>(far_end.at(k));
        row.contact = contacts.at(k);
        row.analysis = {.steady_start = steady_start.at(k),
                        .window = window.at(k),
                        .segments = segments.at(k),
                        .history_stride = stride.at(k),
                        .peak_separation = separation.at(k)};
        row.time_step = time_step.at(k);
        row.shape = shapes[k];
    }
    return cases;
}

std::vector<MemberRow> read_members(hid_t file, const std::vector<CaseRow>& cases) {
    const auto case_index = hdf5::read_values<std::int32_t>(file, "members/case");
    const auto arrangement = hdf5::read_values<std::int32_t>(file, "members/arrangement");
    const auto status = hdf5::read_values<std::int8_t>(file, "members/status");
    const auto steady = hdf5::read_values<std::int8_t>(file, "members/steady");
    const auto reason = hdf5::read_texts(file, "members/reason");
    const auto maxima = hdf5::read_values<double>(file, "members/segment_maximum");
    std::vector<MemberRow> members(case_index.size());
    const std::size_t width = members.empty() ? 0 : maxima.size() / members.size();
    for (std::size_t k = 0; k < members.size(); ++k) {
        MemberRow& row = members[k];
        row.case_index = case_index[k];
        row.arrangement = arrangement.at(k);
        row.status = static_cast<RowStatus>(status.at(k));
        row.load.steady = steady.at(k) == 1;
        row.reason = reason.at(k);
        // Rows are as wide as the case with most segments needs.
        const int segments = cases.at(static_cast<std::size_t>(row.case_index)).analysis.segments;
        const auto first = maxima.begin() + static_cast<std::ptrdiff_t>(k * width);
        row.load.segment_maximum.assign(first, first + segments);
    }
    for (const Quantity& one : quantities) {
        const std::string name = fmt::format("members/{}", one.key);
        std::vector<double> values(members.size(), nan);
        if (one.since == 0 || hdf5::exists(file, name)) values = hdf5::read_values<double>(file, name);
        for (std::size_t k = 0; k < members.size(); ++k) one.place.set(members[k], values.at(k));
    }
    return members;
}

}  // namespace

void read_levels(hid_t file, CampaignTable& table) {
    if (!hdf5::exists(file, "exceedance")) return;
    table.levels = hdf5::read_values<double>(file, "level");
    const auto width = static_cast<std::ptrdiff_t>(table.levels.size());
    const auto counts = [&](const char* name, std::vector<double> MemberRow::*field) {
        const auto values = hdf5::read_values<double>(file, name);
        if (values.size() != table.members.size() * table.levels.size())
            throw RunError(fmt::format("{} does not have a value for each member and level", name));
        auto first = values.begin();
        for (MemberRow& row : table.members) {
            (row.*field).assign(first, first + width);
            first += width;
        }
    };
    counts("exceedance/steps_above", &MemberRow::steps_above);
    counts("exceedance/upcrossings", &MemberRow::upcrossings);
}

/// Before read_averaged() leaves times out.
void read_peaks(hid_t file, CampaignTable& table) {
    if (!hdf5::exists(file, "averaged/peaks")) return;  // before layout 1.6
    const auto values = hdf5::read_values<double>(file, "averaged/peaks");
    const std::size_t times = table.averaging_times.size();
    const std::size_t width = values.size() / (table.members.size() * times);
    for (std::size_t k = 0; k < table.members.size(); ++k) {
        for (std::size_t i = 0; i < times; ++i) {
            const auto first = values.begin() + static_cast<std::ptrdiff_t>((k * times + i) * width);
            const auto last = std::find_if(first, first + static_cast<std::ptrdiff_t>(width),
                                           [](double value) { return std::isnan(value); });
            table.members[k].averaged[i].peaks.assign(first, last);
        }
    }
}

void read_averaged(hid_t file, CampaignTable& table) {
    if (!hdf5::exists(file, "averaged")) return;  // before layout 1.4
    table.averaging_times = hdf5::read_values<double>(file, "averaging_time");
    const std::size_t times = table.averaging_times.size();
    const auto maxima = hdf5::read_values<double>(file, "averaged/segment_maximum");
    const std::size_t width = table.members.empty() ? 0 : maxima.size() / (table.members.size() * times);
    for (std::size_t k = 0; k < table.members.size(); ++k) {
        MemberRow& row = table.members[k];
        const auto segments = table.cases.at(static_cast<std::size_t>(row.case_index)).analysis.segments;
        for (std::size_t i = 0; i < times; ++i) {
            const auto first = maxima.begin() + static_cast<std::ptrdiff_t>((k * times + i) * width);
            row.averaged.push_back(
                {.time = table.averaging_times[i], .segment_maximum = {first, first + segments}, .peaks = {}});
        }
    }
    for (const Quantity& one : quantities) {
        if (one.averaged == nullptr) continue;
        const auto values = hdf5::read_values<double>(file, fmt::format("averaged/{}", one.key));
        for (std::size_t k = 0; k < table.members.size(); ++k)
            for (std::size_t i = 0; i < times; ++i)
                table.members[k].averaged[i].*one.averaged = values.at(k * times + i);
    }
    read_peaks(file, table);
    // A time that a member did not take is not in its row.
    for (MemberRow& row : table.members)
        std::erase_if(row.averaged, [](const AveragedLoad& one) { return std::isnan(one.mean_maximum); });
}

CampaignTable read_campaign_file(const std::filesystem::path& path) {
    const hdf5::QuietErrors quiet;
    const Handle file = hdf5::open_for_reading(path);
    hdf5::check_kind(file.id(), campaign_kind, path);
    CampaignTable table;
    table.title = hdf5::read_text_attribute(file.id(), "title");
    table.cases = read_cases(file.id());
    table.members = read_members(file.id(), table.cases);
    read_levels(file.id(), table);
    read_averaged(file.id(), table);
    return table;
}

}  // namespace floes
