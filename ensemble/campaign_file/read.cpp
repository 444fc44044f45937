#include "campaign_file/read.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "campaign/read.hpp"
#include "campaign_file/array_reader.hpp"
#include "campaign_file/kinds.hpp"
#include "core/error.hpp"
#include "hdf5/columns.hpp"
#include "member/design_of.hpp"
#include "member/member_outputs.hpp"
#include "member/moored_response.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

struct CampaignFile::Opened {
    hdf5::Handle file;
    std::vector<hdf5::Handle> pieces;  ///< open as long as the file is
    Campaign campaign;
};

namespace {

hdf5::Handle open_campaign(const std::filesystem::path& path) {
    hdf5::Handle file = hdf5::open_for_reading(path);
    hdf5::check_kind(file.id(), campaign_kind, path);
    return file;
}

Campaign read_configured(hid_t file, const std::filesystem::path& path) {
    return read_campaign({hdf5::read_text(file, "provenance/configuration"), path.stem().string() + ".toml", {}},
                         nullptr);
}

}  // namespace

CampaignFile::CampaignFile(const std::filesystem::path& path) : path_(path) {
    const hdf5::QuietErrors quiet;
    hdf5::Handle file = open_campaign(path);
    std::vector<hdf5::Handle> pieces = open_pieces(path, pieces_of(file.id()));
    Campaign campaign = read_configured(file.id(), path);
    opened_ = std::make_unique<const Opened>(std::move(file), std::move(pieces), std::move(campaign));
}

CampaignFile::~CampaignFile() = default;

const Campaign& CampaignFile::campaign() const {
    return opened_->campaign;
}

std::int64_t CampaignFile::id() const {
    return opened_->file.id();
}

std::vector<RowStatus> read_states(const CampaignFile& file) {
    const auto count = static_cast<std::size_t>(member_count(file.campaign()));
    const auto values = hdf5::read_numbers<std::int8_t>(file.id(), "members/status", count, -1, 1);
    std::vector<RowStatus> states;
    for (const std::int8_t value : values) states.push_back(static_cast<RowStatus>(value));
    return states;
}

namespace {

constexpr auto last_mode = static_cast<std::int8_t>(std::size(failure_mode_names) - 1);

constexpr const char* told_facts[]{"date",  "floes", "git_revision", "machine", "compiler", "compiler_flags", "bullet",
                                   "eigen", "hdf5",  "tbb",          "boost",   "mpi",      "math_library",   "seed"};

std::string fact(hid_t group, const char* name) {
    const hdf5::Handle attribute(hdf5::check_read(H5Aopen(group, name, H5P_DEFAULT), group, name), H5Aclose, "H5Aopen",
                                 name);
    const hdf5::Handle type(H5Aget_type(attribute.id()), H5Tclose, "H5Aget_type", name);
    if (H5Tget_class(type.id()) == H5T_STRING) return hdf5::read_text_attribute(group, name);
    if (H5Aget_storage_size(attribute.id()) != sizeof(std::uint64_t))
        hdf5::refuse_damaged(group, fmt::format("the attribute {} is no single number", name));
    std::uint64_t number = 0;
    hdf5::check_read(H5Aread(attribute.id(), hdf5::native_type<std::uint64_t>(), &number), group, name);
    return std::to_string(number);
}

}  // namespace

CampaignOrigin read_origin(const CampaignFile& file) {
    const hdf5::QuietErrors quiet;
    const hdf5::Handle group(
        hdf5::check_read(H5Gopen2(file.id(), "provenance", H5P_DEFAULT), file.id(), "the group provenance"), H5Gclose,
        "H5Gopen", "provenance");
    CampaignOrigin origin;
    origin.configuration = hdf5::read_text(file.id(), "provenance/configuration");
    for (const char* name : told_facts) {
        if (hdf5::has_attribute(group.id(), name)) origin.facts.emplace_back(name, fact(group.id(), name));
    }
    return origin;
}

std::vector<PlanarPose> read_poses(const CampaignFile& file, int member) {
    const hdf5::QuietErrors quiet;
    const ArrayPlaces places(file.campaign());
    const MemberKey key = member_key(file.campaign(), member);
    MemberResult result;
    const auto rows = hdf5::read_column<std::int32_t>(file.id(), "members/arrangement",
                                                      static_cast<std::size_t>(member_count(file.campaign())));
    ArrayReader(file, array_output("arrangements/pose"), places)
        .read(static_cast<std::size_t>(rows[static_cast<std::size_t>(member)]), key.case_index, result);
    return result.arrangement;
}

std::vector<double> read_wall_times(const CampaignFile& file) {
    const hdf5::QuietErrors quiet;
    return hdf5::read_values<double>(file.id(), "provenance/wall_time");
}

std::vector<BreakRow> read_breaks(const CampaignFile& file) {
    const hdf5::QuietErrors quiet;
    const auto member = hdf5::read_values<std::int32_t>(file.id(), "breaks/member");
    const auto time = hdf5::read_column<double>(file.id(), "breaks/time", member.size());
    const auto floe = hdf5::read_column<std::int32_t>(file.id(), "breaks/floe", member.size());
    const auto joint = hdf5::read_column<std::int32_t>(file.id(), "breaks/joint", member.size());
    const auto mode = hdf5::read_numbers<std::int8_t>(file.id(), "breaks/mode", member.size(), 0, last_mode);
    std::vector<BreakRow> rows;
    for (std::size_t i = 0; i < member.size(); ++i)
        rows.push_back({member[i], time.at(i), floe.at(i), joint.at(i), mode.at(i)});
    return rows;
}

std::vector<PieceRow> read_pieces(const CampaignFile& file) {
    const hdf5::QuietErrors quiet;
    if (!hdf5::exists(file.id(), "pieces")) return {};
    const auto member = hdf5::read_values<std::int32_t>(file.id(), "pieces/member");
    const auto floe = hdf5::read_column<std::int32_t>(file.id(), "pieces/floe", member.size());
    const auto area = hdf5::read_column<double>(file.id(), "pieces/area", member.size());
    std::vector<PieceRow> rows;
    for (std::size_t i = 0; i < member.size(); ++i) rows.push_back({member[i], floe.at(i), area.at(i)});
    return rows;
}

void for_each_histories(const CampaignFile& file, std::span<const ArrayOutput* const> arrays,
                        const std::function<bool(int member)>& wanted,
                        const std::function<void(const StoredHistories&)>& use) {
    const hdf5::QuietErrors quiet;
    const Campaign& campaign = file.campaign();
    const ArrayPlaces places(campaign);
    const std::vector<RowStatus> states = read_states(file);
    std::vector<ArrayReader> readers;
    for (const ArrayOutput* array : arrays) readers.emplace_back(file, *array, places);
    for (int member = 0; member < static_cast<int>(states.size()); ++member) {
        if (states[static_cast<std::size_t>(member)] != RowStatus::done || (wanted && !wanted(member))) continue;
        const int of_case = member_key(campaign, member).case_index;
        std::vector<ArrayValues> read;
        for (ArrayReader& reader : readers) read.push_back(reader.read(static_cast<std::size_t>(member), of_case));
        if (std::ranges::any_of(read, [](const ArrayValues& one) { return one.empty(); })) continue;
        const Scenario& scenario = campaign.cases[static_cast<std::size_t>(of_case)].scenario;
        StoredHistories histories{member, scenario.general.time_step * scenario.analysis.history_stride, {}};
        for (const ArrayValues& one : read) histories.values.emplace_back(one.values);
        use(histories);
    }
}

void for_each_history(const CampaignFile& file, const ArrayOutput& of,
                      const std::function<void(const StoredHistory&)>& use,
                      const std::function<bool(int member)>& wanted) {
    const ArrayOutput* const only = &of;
    for_each_histories(file, std::span(&only, 1), wanted, [&](const StoredHistories& found) {
        use({found.member, found.step, found.values.front()});
    });
}

void for_each_history(const CampaignFile& file, const std::function<void(const StoredHistory&)>& use) {
    for_each_history(file, array_output("history/surge_load"), use);
}

void for_each_load_map(const CampaignFile& file, const std::function<void(int, const LoadMap&)>& use) {
    const hdf5::QuietErrors quiet;
    const ArrayPlaces places(file.campaign());
    const std::vector<RowStatus> states = read_states(file);
    std::vector<ArrayReader> readers;
    for (const ArrayOutput& array : array_outputs)
        if (array.group() == "load_map") readers.emplace_back(file, array, places);
    for (std::size_t member = 0; member < states.size(); ++member) {
        if (states[member] != RowStatus::done) continue;
        MemberResult result;
        for (ArrayReader& one : readers)
            one.read(member, member_key(file.campaign(), static_cast<int>(member)).case_index, result);
        if (!result.load_map.empty()) use(static_cast<int>(member), result.load_map);
    }
}

std::vector<MemberResult> read_quantities(const CampaignFile& file, std::size_t count) {
    std::vector<MemberResult> results(count);
    for (const Quantity& one : quantities) {
        const std::string name = fmt::format("members/{}", one.key);
        std::vector<double> values(count, std::numeric_limits<double>::quiet_NaN());
        if (one.since == 0 || hdf5::exists(file.id(), name)) values = hdf5::read_column<double>(file.id(), name, count);
        for (std::size_t k = 0; k < count; ++k) {
            if (!one.holds(values[k]))
                hdf5::refuse_damaged(file.id(), fmt::format("{} has {} in place of a count", name, values[k]));
            one.place.set(results[k], values[k]);
        }
    }
    return results;
}

namespace {

/// Those that are read with the quantities. Times of averaged loads are what the scenario says.
void read_table_arrays(const CampaignFile& file, const std::vector<RowStatus>& states,
                       std::vector<MemberResult>& results) {
    const Campaign& campaign = file.campaign();
    const ArrayPlaces places(campaign);
    const auto case_of = [&](std::size_t member) { return member_key(campaign, static_cast<int>(member)).case_index; };
    for (std::size_t k = 0; k < results.size(); ++k) {
        if (states[k] != RowStatus::done) continue;
        for (const double time : campaign.cases[static_cast<std::size_t>(case_of(k))].scenario.averaging_times())
            results[k].averaged.push_back({.time = time, .segment_maximum = {}});
    }
    for (const ArrayOutput& array : array_outputs) {
        if (!array.in_table) continue;
        ArrayReader reader(file, array, places);
        for (std::size_t k = 0; k < results.size(); ++k)
            if (states[k] == RowStatus::done) reader.read(k, case_of(k), results[k]);
    }
}

}  // namespace

CampaignTable read_campaign_file(const CampaignFile& file) {
    const hdf5::QuietErrors quiet;
    const MemberRows rows(file.campaign());
    CampaignTable table{rows.cases(), {}};
    table.title = hdf5::read_text_attribute(file.id(), "title");
    const std::vector<RowStatus> states = read_states(file);
    std::vector<MemberResult> results = read_quantities(file, states.size());
    read_table_arrays(file, states, results);
    const auto steady = hdf5::read_numbers<std::int8_t>(file.id(), "members/steady", states.size(), -1, 1);
    const auto reason = hdf5::read_texts(file.id(), "members/reason", states.size());
    for (std::size_t k = 0; k < states.size(); ++k) {
        results[k].load.steady = steady[k] == 1;
        results[k].reason = reason[k];
        table.members.push_back(rows.row(k, states[k], results[k]));
    }
    return table;
}

namespace {

void measure(MemberRow& row, std::span<const double> window, double step, const Analysis& analysis,
             std::span<const double> levels) {
    row.load = load_statistics(window, step, analysis.segments);
    std::vector<double> times;
    for (const AveragedLoad& one : row.averaged) times.push_back(one.time);
    row.averaged = averaged_load(window, {.time_step = step,
                                          .segments = analysis.segments,
                                          .times = times,
                                          .peak_separation = analysis.peak_separation});
    const std::vector<LevelCount> counts = count_levels(window, levels);
    for (std::size_t k = 0; k < levels.size(); ++k) {
        if (std::isnan(row.steps_above[k])) continue;
        row.steps_above[k] = counts[k].steps_above;
        row.upcrossings[k] = counts[k].upcrossings;
    }
}

}  // namespace

std::span<const double> in_window(const StoredHistory& history, const Analysis& analysis) {
    const auto count = static_cast<std::size_t>(std::llround(analysis.window / history.step));
    return history.values.last(std::min(count, history.values.size()));
}

namespace {

/// How the structures of a case gave way, in its window of the table, from all that was kept of their motion.
void measure_motion(const CampaignFile& file, CampaignTable& table, std::size_t case_index) {
    Scenario scenario = file.campaign().cases[case_index].scenario;
    if (!scenario.moorings.give_way()) return;
    std::vector<const ArrayOutput*> arrays;
    for (const auto& history : motion_histories)
        if (!axis_of(history.of)->places(scenario).empty())
            arrays.push_back(&array_outputs.at(array_number(history.path)));
    scenario.analysis = table.cases[case_index].analysis;
    const auto row_of = [&](int member) -> MemberRow& { return table.members.at(static_cast<std::size_t>(member)); };
    const auto wanted = [&](int member) { return row_of(member).case_index == static_cast<int>(case_index); };
    for_each_histories(file, arrays, wanted, [&](const StoredHistories& found) {
        MemberResult result;
        for (std::size_t k = 0; k < arrays.size(); ++k)
            arrays[k]->access.set(result, {{found.values[k].size()}, {found.values[k].begin(), found.values[k].end()}});
        MemberRow& row = row_of(found.member);
        row.responses = responses_of(scenario, result.motion);
        const MooredResponse of_run = std::exchange(row.moored, moored_response(scenario, result.motion));
        row.moored.line_tension = of_run.line_tension;
        row.moored.broken_lines = of_run.broken_lines;
    });
}

}  // namespace

CampaignTable measured_anew(const CampaignFile& file, CampaignTable table, const std::vector<Analysis>& windows) {
    for (std::size_t k = 0; k < table.cases.size(); ++k) table.cases[k].analysis = windows.at(k);
    for_each_history(file, [&](const StoredHistory& history) {
        MemberRow& row = table.members.at(static_cast<std::size_t>(history.member));
        const CaseRow& about = table.cases.at(static_cast<std::size_t>(row.case_index));
        if (about.analysis.history_stride > 1)
            throw InputError(
                fmt::format("--window auto measures maxima and deviations anew, which needs the load of every step, "
                            "and the histories of case {} are means over {} steps (analysis.history_steps).",
                            about.name, about.analysis.history_stride));
        measure(row, in_window(history, about.analysis), history.step, about.analysis, table.levels);
    });
    for (std::size_t k = 0; k < table.cases.size(); ++k) measure_motion(file, table, k);
    return table;
}

}  // namespace floes
