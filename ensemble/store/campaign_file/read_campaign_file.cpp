#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "campaign/read.hpp"
#include "campaign_file/read_campaign_file.hpp"
#include "hdf5/columns.hpp"

namespace floes {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::int32_t most_segments = 1'000'000;
constexpr std::int32_t most_stride = 1'000'000'000;

/// A case has at most as many segments as a row is wide.
void check_segments(hid_t file, int segments, std::size_t width) {
    if (static_cast<std::size_t>(segments) > width)
        hdf5::refuse_damaged(file, fmt::format("cases/segments has {} where {} are stored", segments, width));
}

std::vector<Shape> read_shapes(hid_t file, std::size_t cases) {
    std::vector<std::vector<double>> columns;
    std::size_t points = 0;
    for (const ShapeColumn& column : Shape::columns) {
        const std::string name = fmt::format("cases/profile_{}", column.name);
        columns.push_back(hdf5::read_table<double>(file, name, cases, points));
        hdf5::check_count(file, name, columns.back().size(), columns.front().size());
    }
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
    const std::string text = hdf5::read_text(file, "provenance/configuration");
    std::vector<ContactLaw> laws;
    for (const Case& one : read_campaign({text, "its configuration", {}}, nullptr).cases) {
        laws.push_back(one.scenario.contact_law());
    }
    return laws;
}

std::vector<ContactLaw> read_contacts(hid_t file, std::size_t count) {
    if (!hdf5::exists(file, "cases/contact_law")) return configured_contacts(file);
    std::vector<ContactLaw> laws;
    for (const double erp : hdf5::read_column<double>(file, "cases/contact_erp", count)) laws.push_back({.erp = erp});
    const auto friction = hdf5::read_numbers<std::int8_t>(file, "cases/friction", count, 0, 1);
    const auto normal = hdf5::read_numbers<std::int8_t>(file, "cases/contact_law", count, 0, 1);
    const auto pressure = hdf5::read_column<double>(file, "cases/crushing_pressure", count);
    const auto internal_edges = hdf5::read_numbers<std::int8_t>(file, "cases/internal_edges", count, 0, 1);
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
    const std::size_t count = names.size();
    const auto cfm = hdf5::read_column<double>(file, "cases/cfm", count);
    const auto modulus = hdf5::read_column<double>(file, "cases/elastic_modulus", count);
    const auto far_end = hdf5::read_numbers<std::int8_t>(file, "cases/far_end", count, 0, 1);
    const std::vector<ContactLaw> contacts = read_contacts(file, count);
    const std::vector<Shape> shapes = read_shapes(file, names.size());
    const auto steady_start = hdf5::read_column<double>(file, "cases/steady_start", count);
    const auto window = hdf5::read_column<double>(file, "cases/window", count);
    const auto segments = hdf5::read_numbers<std::int32_t>(file, "cases/segments", count, 1, most_segments);
    const auto time_step = hdf5::read_column<double>(file, "cases/time_step", count);
    std::vector<std::int32_t> stride(names.size(), 1);  // of files before layout 1.3
    if (hdf5::exists(file, "cases/history_stride"))
        stride = hdf5::read_numbers<std::int32_t>(file, "cases/history_stride", count, 1, most_stride);
    std::vector<double> separation(names.size(), Analysis{}.peak_separation);  // of files before layout 1.6
    if (hdf5::exists(file, "cases/peak_separation"))
        separation = hdf5::read_column<double>(file, "cases/peak_separation", count);
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
    const auto reason = hdf5::read_texts(file, "members/reason");
    const std::size_t count = reason.size();
    const auto last_case = static_cast<std::int32_t>(cases.size()) - 1;
    const auto last_row = static_cast<std::int32_t>(count) - 1;  // of /arrangements: each is some member's
    const auto case_index = hdf5::read_numbers<std::int32_t>(file, "members/case", count, 0, last_case);
    const auto arrangement = hdf5::read_numbers<std::int32_t>(file, "members/arrangement", count, 0, last_row);
    const auto status = hdf5::read_numbers<std::int8_t>(file, "members/status", count, -1, 1);
    const auto steady = hdf5::read_numbers<std::int8_t>(file, "members/steady", count, -1, 1);
    std::size_t width = 0;
    const auto maxima = hdf5::read_table<double>(file, "members/segment_maximum", count, width);
    std::vector<MemberRow> members(count);
    for (std::size_t k = 0; k < members.size(); ++k) {
        MemberRow& row = members[k];
        row.case_index = case_index[k];
        row.arrangement = arrangement.at(k);
        row.status = static_cast<RowStatus>(status.at(k));
        row.load.steady = steady.at(k) == 1;
        row.reason = reason.at(k);
        // Rows are as wide as the case with most segments needs.
        const int segments = cases.at(static_cast<std::size_t>(row.case_index)).analysis.segments;
        check_segments(file, segments, width);
        const auto first = maxima.begin() + static_cast<std::ptrdiff_t>(k * width);
        row.load.segment_maximum.assign(first, first + segments);
    }
    for (const Quantity& one : quantities) {
        const std::string name = fmt::format("members/{}", one.key);
        std::vector<double> values(members.size(), nan);
        if (one.since == 0 || hdf5::exists(file, name)) values = hdf5::read_column<double>(file, name, count);
        for (std::size_t k = 0; k < members.size(); ++k) {
            if (!one.place.holds(values.at(k)))
                hdf5::refuse_damaged(file, fmt::format("{} has {} in place of a count", name, values[k]));
            one.place.set(members[k], values[k]);
        }
    }
    return members;
}

}  // namespace

void read_levels(hid_t file, CampaignTable& table) {
    if (!hdf5::exists(file, "exceedance")) return;
    table.levels = hdf5::read_values<double>(file, "level");
    const auto width = static_cast<std::ptrdiff_t>(table.levels.size());
    const auto counts = [&](const char* name, std::vector<double> MemberRow::*field) {
        const auto values = hdf5::read_column<double>(file, name, table.members.size() * table.levels.size());
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
    const std::size_t times = table.averaging_times.size();
    std::size_t width = 0;
    const auto values = hdf5::read_table<double>(file, "averaged/peaks", table.members.size() * times, width);
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
    const std::size_t count = table.members.size() * times;
    std::size_t width = 0;
    const auto maxima = hdf5::read_table<double>(file, "averaged/segment_maximum", count, width);
    for (std::size_t k = 0; k < table.members.size(); ++k) {
        MemberRow& row = table.members[k];
        const auto segments = table.cases.at(static_cast<std::size_t>(row.case_index)).analysis.segments;
        check_segments(file, segments, width);
        for (std::size_t i = 0; i < times; ++i) {
            const auto first = maxima.begin() + static_cast<std::ptrdiff_t>((k * times + i) * width);
            row.averaged.push_back(
                {.time = table.averaging_times[i], .segment_maximum = {first, first + segments}, .peaks = {}});
        }
    }
    for (const Quantity& one : quantities) {
        if (one.averaged == nullptr) continue;
        const auto values = hdf5::read_column<double>(file, fmt::format("averaged/{}", one.key), count);
        for (std::size_t k = 0; k < table.members.size(); ++k)
            for (std::size_t i = 0; i < times; ++i)
                table.members[k].averaged[i].*one.averaged = values.at(k * times + i);
    }
    read_peaks(file, table);
    // A time that a member did not take is not in its row.
    for (MemberRow& row : table.members)
        std::erase_if(row.averaged, [](const AveragedLoad& one) { return std::isnan(one.mean_maximum); });
}

CampaignTable read_campaign_file(const CampaignFile& file) {
    const hdf5::QuietErrors quiet;
    CampaignTable table;
    table.title = hdf5::read_text_attribute(file.id(), "title");
    table.cases = read_cases(file.id());
    table.members = read_members(file.id(), table.cases);
    read_levels(file.id(), table);
    read_averaged(file.id(), table);
    return table;
}

}  // namespace floes
