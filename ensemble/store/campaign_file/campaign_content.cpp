#include "campaign_file/campaign_content.hpp"

#include <algorithm>
#include <numeric>
#include <string>

namespace floes {
namespace {

using hdf5::Label;
using hdf5::Scale;

std::vector<std::int32_t> counted_to(std::size_t count) {
    std::vector<std::int32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

Scale make_scale(hid_t file, const ArrayAxis& axis, const CampaignContent& content) {
    const Label label{std::string(axis.key), std::string(axis.unit), std::string(axis.long_name)};
    const FiledAxis& filed = content.places.axis(axis);
    if (axis.places == nullptr) return hdf5::write_scale(file, label, counted_to(content.found(axis)));
    if (!axis.words.empty())
        return hdf5::write_scale(file, label, std::vector<std::string>(axis.words.begin(), axis.words.end()));
    if (axis.whole_numbers) return hdf5::write_scale(file, label, counted_to(filed.places.size()));
    if (filed.alike) return hdf5::write_scale(file, label, filed.places);
    std::vector<double> numbers(filed.places.size());
    std::iota(numbers.begin(), numbers.end(), 1.0);
    return hdf5::write_scale(file, Label{std::string(axis.key), "1", std::string(axis.unlike)}, numbers);
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
      rows(of),
      places(of) {}

std::size_t CampaignContent::found(const ArrayAxis& axis) const {
    std::size_t most = 0;
    std::size_t all = 0;
    for_each_done(*this, [&](const MemberNote& note) {
        const auto own = static_cast<std::size_t>(found_along(note, axis));
        most = std::max(most, own);
        all += own;
    });
    return axis.kind == AxisKind::listed ? all : most;
}

bool CampaignContent::has(const ArrayOutput& array) const {
    return std::ranges::none_of(array.axes, [&](const ArrayAxis* axis) {
        if (axis == nullptr) return false;
        return ((axis->kind == AxisKind::placed || axis->kind == AxisKind::counted) &&
                places.axis(*axis).places.empty()) ||
               (axis->kind == AxisKind::longest && found(*axis) == 0);
    });
}

CampaignScales::CampaignScales(hid_t file, const CampaignContent& content)
    : member(hdf5::write_index_scale(file, "member", "member: arrangement number times cases plus case",
                                     content.records.size())),
      case_(hdf5::write_index_scale(file, "case", "case, a row of /cases", content.campaign.cases.size())),
      arrangement(hdf5::write_index_scale(file, "arrangement", "arrangement, a row of /arrangements",
                                          static_cast<std::size_t>(content.rows.arrangements().count()))),
      profile_point(hdf5::write_index_scale(file, "profile_point", "point of the structure's profile, from below",
                                            content.largest([](const Scenario& s) {
                                                return std::max<std::size_t>(1, s.structure.shape.profile().size());
                                            }))) {
    for (const ArrayOutput& array : array_outputs) {
        if (!array.in_file() || !content.has(array)) continue;
        for (const ArrayAxis* axis : array.axes)
            if (axis != nullptr && !axes_.contains(axis)) axes_.emplace(axis, make_scale(file, *axis, content));
    }
}

}  // namespace floes
