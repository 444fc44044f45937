#include "campaign_file/campaign_content.hpp"

#include <numeric>
#include <set>
#include <string>

namespace floes {
namespace {

using hdf5::Label;
using hdf5::Scale;

// Ends of what the values of a history are of where all cases step alike, else the numbers of the values.
Scale time_scale(hid_t file, const CampaignContent& content) {
    std::set<double> steps;
    for (const Case& one : content.campaign.cases)
        steps.insert(one.scenario.general.time_step * one.scenario.analysis.history_stride);
    const bool alike = steps.size() == 1;
    std::vector<double> times(
        content.largest([](const Scenario& s) { return s.step_count() / s.analysis.history_stride; }));
    for (std::size_t k = 0; k < times.size(); ++k)
        times[k] = static_cast<double>(k + 1) * (alike ? *steps.begin() : 1.0);
    if (alike) return hdf5::write_scale(file, Label{"time", "s", "end of the time steps of a value"}, times);
    return hdf5::write_scale(
        file, Label{"time", "1", "number of the value from 1; times /cases/time_step and /cases/history_stride"},
        times);
}

}  // namespace

CampaignContent::CampaignContent(const Campaign& of, std::span<const MemberRecord> all_records)
    : campaign(of),
      records(match_records(of, all_records)),
      attempts(last_attempts(of, all_records)),
      table(campaign_table(of, all_records)),
      arrangement_rows(of) {}

const MemberResult* CampaignContent::done(std::size_t member) const {
    const MemberRecord* record = records[member];
    return record != nullptr && record->result.status == MemberStatus::done ? &record->result : nullptr;
}

std::size_t CampaignContent::break_count() const {
    std::size_t count = 0;
    for (std::size_t member = 0; member < records.size(); ++member)
        if (const MemberResult* result = done(member)) count += result->breaks.size();
    return count;
}

CampaignScales::CampaignScales(hid_t file, const CampaignContent& content)
    : member(hdf5::write_index_scale(file, "member", "member: arrangement number times cases plus case",
                                     content.records.size())),
      case_(hdf5::write_index_scale(file, "case", "case, a row of /cases", content.campaign.cases.size())),
      arrangement(hdf5::write_index_scale(file, "arrangement", "arrangement, a row of /arrangements",
                                          static_cast<std::size_t>(content.arrangement_rows.count()))),
      segment(hdf5::write_index_scale(file, "segment", "equal part of the analysis window",
                                      content.largest([](const Scenario& s) { return s.analysis.segments; }))),
      floe(hdf5::write_index_scale(file, "floe", "floe of an arrangement",
                                   content.largest([](const Scenario& s) { return s.field.floes; }))),
      time(time_scale(file, content)),
      coordinate(hdf5::write_scale(file, Label{"coordinate", "1", "coordinate of a floe's pose"},
                                   std::vector<std::string>{"x", "z", "yaw"})),
      profile_point(
          hdf5::write_index_scale(file, "profile_point", "point of the structure's profile, from below",
                                  content.largest([](const Scenario& s) { return s.structure.shape.rows().size(); }))),
      break_(hdf5::write_index_scale(file, "break", "failed joint, a row of /breaks", content.break_count())) {}

}  // namespace floes
