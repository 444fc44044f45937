#include "campaign_file/campaign_content.hpp"

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

template <class Use>
void for_each_done(const CampaignContent& content, const Use& use) {
    for (const std::optional<std::size_t>& record : content.records)
        if (record && content.members.notes()[*record].done()) use(content.members.notes()[*record]);
}

}  // namespace

CampaignContent::CampaignContent(const Campaign& of, const StoredMembers& all_members)
    : campaign(of),
      members(all_members),
      records(match_records(of, all_members.notes())),
      attempts(last_attempts(of, all_members.notes())),
      rows(of) {}

std::size_t CampaignContent::break_count() const {
    std::size_t count = 0;
    for_each_done(*this, [&](const MemberNote& note) { count += static_cast<std::size_t>(note.breaks); });
    return count;
}

std::size_t CampaignContent::most_peaks() const {
    std::size_t most = 0;
    for_each_done(*this, [&](const MemberNote& note) { most = std::max(most, static_cast<std::size_t>(note.peaks)); });
    return most;
}

CampaignScales::CampaignScales(hid_t file, const CampaignContent& content)
    : member(hdf5::write_index_scale(file, "member", "member: arrangement number times cases plus case",
                                     content.records.size())),
      case_(hdf5::write_index_scale(file, "case", "case, a row of /cases", content.campaign.cases.size())),
      arrangement(hdf5::write_index_scale(file, "arrangement", "arrangement, a row of /arrangements",
                                          static_cast<std::size_t>(content.rows.arrangements().count()))),
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
