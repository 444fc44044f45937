#include "campaign_file/filed_campaign.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "campaign_file/array_reader.hpp"

namespace floes {

namespace {

/// Without the places past the last one that the member found, with which the file fills up.
ArrayValues trimmed(const ArrayOutput& array, ArrayValues own) {
    if (own.empty() || array.axis_of(AxisKind::longest) == nullptr) return own;
    const std::size_t width = own.sizes.back();
    std::size_t longest = 0;
    for (std::size_t k = 0; k < own.values.size(); ++k)
        if (!std::isnan(own.values[k])) longest = std::max(longest, k % width + 1);
    ArrayValues shorter{own.sizes, {}};
    shorter.sizes.back() = longest;
    for (std::size_t k = 0; k < own.values.size(); ++k)
        if (k % width < longest) shorter.values.push_back(own.values[k]);
    return shorter;
}

/// Of what a file lists, one member after another, where each member's share ends.
std::vector<std::size_t> ends_of_shares(const CampaignFile& file, std::string_view group, std::size_t members) {
    std::vector<std::size_t> ends(members, 0);
    for (const std::int32_t owner : hdf5::read_values<std::int32_t>(file.id(), fmt::format("{}/member", group))) {
        if (owner < 0 || static_cast<std::size_t>(owner) >= members)
            hdf5::refuse_damaged(file.id(), fmt::format("{}/member has {} in place of a member", group, owner));
        ++ends[static_cast<std::size_t>(owner)];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    return ends;
}

std::vector<double> listed_values(const CampaignFile& file, const ArrayOutput& array) {
    const std::string name(array.path);
    const auto doubles = [](const auto& values) { return std::vector<double>(values.begin(), values.end()); };
    switch (array.numbers) {
        case ArrayNumbers::real:
            return hdf5::read_values<double>(file.id(), name);
        case ArrayNumbers::index:
            return doubles(hdf5::read_values<std::int32_t>(file.id(), name));
        case ArrayNumbers::flag:
            return doubles(hdf5::read_values<std::int8_t>(file.id(), name));
    }
    return {};
}

/// Reads all columns when it is made, and the arrays with each record.
class FiledRecords {
  public:
    explicit FiledRecords(const std::filesystem::path& path)
        : file_(path),
          places_(file_.campaign()),
          states_(read_states(file_)),
          arrangements_(column<std::int32_t>("members/arrangement")),
          wall_time_(column<double>("provenance/wall_time")),
          attempts_(column<std::int32_t>("provenance/attempts")),
          keys_(case_fingerprints(file_.campaign())) {
        for (std::size_t member = 0; member < states_.size(); ++member)
            if (states_[member] == RowStatus::done) members_.push_back(member);
    }

    const CampaignFile& file() const { return file_; }

    MemberNotes notes() const {
        MemberNotes notes;
        for (const std::size_t member : members_) {
            const MemberKey key = key_of(member);
            notes.add(keys_.at(static_cast<std::size_t>(key.case_index)),
                      {.wall_time = wall_time_[member], .arrangement = key.arrangement, .attempt = attempts_[member]});
        }
        return notes;
    }

    MemberRecord read(std::size_t k) {
        const hdf5::QuietErrors quiet;
        if (results_.empty()) read_columns();
        const std::size_t member = members_.at(k);
        const MemberKey key = key_of(member);
        MemberRecord record;
        record.case_key = keys_.at(static_cast<std::size_t>(key.case_index));
        record.arrangement = key.arrangement;
        record.attempt = attempts_[member];
        record.rank = rank_[member];
        record.host = host_[member];
        record.peak_memory = static_cast<std::uint64_t>(peak_memory_[member]);
        record.result = results_[member];
        record.result.load.steady = steady_[member] == 1;
        record.result.wall_time = wall_time_[member];
        record.result.cpu_time = cpu_time_[member];
        for (std::size_t number = 0; number < array_outputs.size(); ++number)
            if (const ArrayValues own = array(number, member); !own.empty()) record.arrays[number] = pack(own);
        return record;
    }

  private:
    /// Where each member's share of a list ends, and the list.
    struct List {
        std::vector<std::size_t> ends;
        std::vector<double> values;
    };

    MemberKey key_of(std::size_t member) const { return member_key(file_.campaign(), static_cast<int>(member)); }

    template <class Value>
    std::vector<Value> column(const char* name) const {
        return hdf5::read_column<Value>(file_.id(), name, states_.size());
    }

    void read_columns() {
        results_ = read_quantities(file_, states_.size());
        steady_ = column<std::int8_t>("members/steady");
        cpu_time_ = column<double>("provenance/cpu_time");
        peak_memory_ = column<double>("provenance/peak_memory");
        rank_ = column<std::int32_t>("provenance/rank");
        host_ = hdf5::read_texts(file_.id(), "provenance/host", states_.size());
        for (std::size_t number = 0; number < array_outputs.size(); ++number) {
            const ArrayOutput& one = array_outputs[number];
            std::optional<ArrayReader>& reader = readers_.emplace_back();
            if (!one.in_file()) continue;
            if (one.axis_of(AxisKind::listed) == nullptr)
                reader.emplace(file_, one, places_);
            else if (hdf5::exists(file_.id(), std::string(one.path)))
                lists_[number] = {ends_of_shares(file_, one.group(), states_.size()), listed_values(file_, one)};
        }
    }

    ArrayValues array(std::size_t number, std::size_t member) {
        const ArrayOutput& one = array_outputs[number];
        const MemberKey key = key_of(member);
        if (!one.in_file()) {  // what the scenario says
            const Scenario& scenario = file_.campaign().cases[static_cast<std::size_t>(key.case_index)].scenario;
            std::vector<double> places = one.axes.front()->places(scenario);
            return {{places.size()}, std::move(places)};
        }
        if (one.axis_of(AxisKind::listed) != nullptr) return share(lists_[number], member);
        const auto row = one.of_arrangement ? static_cast<std::size_t>(arrangements_[member]) : member;
        return trimmed(one, readers_[number]->read(row, key.case_index));
    }

    static ArrayValues share(const List& list, std::size_t member) {
        if (list.ends.empty()) return {};
        const std::size_t begin = member == 0 ? 0 : list.ends[member - 1];
        const std::size_t end = list.ends[member];
        const auto values = std::span(list.values).subspan(begin, end - begin);
        return {{values.size()}, {values.begin(), values.end()}};
    }

    CampaignFile file_;
    ArrayPlaces places_;
    std::vector<RowStatus> states_;
    std::vector<std::int32_t> arrangements_;  ///< rows of /arrangements, as their writer counted them
    std::vector<double> wall_time_;
    std::vector<std::int32_t> attempts_;
    std::vector<std::string> keys_;     ///< of cases
    std::vector<std::size_t> members_;  ///< that are done
    std::vector<MemberResult> results_;
    std::vector<std::int8_t> steady_;
    std::vector<double> cpu_time_;
    std::vector<double> peak_memory_;
    std::vector<std::int32_t> rank_;
    std::vector<std::string> host_;
    std::vector<std::optional<ArrayReader>> readers_;  ///< by number of the array
    std::array<List, array_outputs.size()> lists_;     ///< likewise
};

/// "floes 3.0.0; bullet 3.24"
std::vector<Software> software_in(std::string_view text) {
    std::vector<Software> software;
    while (!text.empty()) {
        const std::string_view one = text.substr(0, text.find("; "));
        const std::size_t blank = std::min(one.find(' '), one.size());
        software.push_back(
            {std::string(one.substr(0, blank)), std::string(one.substr(std::min(blank + 1, one.size())))});
        text.remove_prefix(std::min(one.size() + 2, text.size()));
    }
    return software;
}

std::vector<Session> read_sessions(const CampaignFile& file) {
    std::vector<Session> sessions;
    for (const std::string& text : hdf5::read_texts(file.id(), "provenance/session_software"))
        sessions.emplace_back().software = software_in(text);
    read_columns(file.id(), "provenance", session_columns, sessions);
    return sessions;
}

std::vector<CalibrationRecord> read_calibrations(const CampaignFile& file) {
    if (!hdf5::exists(file.id(), "calibration")) return {};
    const auto of_case = hdf5::read_values<std::int32_t>(file.id(), "calibration/case");
    std::vector<CurvePoint> points(of_case.size());
    read_columns(file.id(), "calibration", calibration_columns, points);
    std::vector<CalibrationRecord> found;
    for (std::size_t k = 0; k < file.campaign().cases.size(); ++k) {
        const Scenario& scenario = file.campaign().cases[k].scenario;
        CalibrationRecord record{calibration_key(scenario), {.cfm = scenario.joint.cfm, .curve = {}}};
        for (std::size_t point = 0; point < points.size(); ++point)
            if (of_case[point] == static_cast<int>(k)) record.found.curve.push_back(points[point]);
        if (record.found.curve.empty() || find_calibration(found, record.key) != nullptr) continue;
        record.found.ceiling = record.found.curve.front().elastic_modulus;  // the smallest Σ comes first
        found.push_back(std::move(record));
    }
    return found;
}

}  // namespace

FiledCampaign read_filed(const std::filesystem::path& path) {
    const hdf5::QuietErrors quiet;
    const auto records = std::make_shared<FiledRecords>(path);
    return {records->file().campaign(), records->notes(), [records](std::size_t k) { return records->read(k); },
            read_sessions(records->file()), read_calibrations(records->file())};
}

void take_in(const FiledCampaign& filed, const Campaign& campaign, Journal& journal) {
    const auto known = match_records(campaign, journal.contents().members);
    const auto there = match_records(campaign, filed.notes);
    for (std::size_t member = 0; member < known.size(); ++member)
        if (there[member] && (!known[member] || !journal.contents().members[*known[member]].done()))
            journal.append(filed.read(*there[member]));
    for (const CalibrationRecord& calibration : filed.calibrations) journal.append(calibration);
    if (journal.contents().sessions.size() < filed.sessions.size())
        journal.append(std::span(filed.sessions).subspan(journal.contents().sessions.size()));
    journal.sync();
}

}  // namespace floes
