#include "store/stored_members.hpp"

#include <algorithm>
#include <utility>

#include "campaign/identity.hpp"

namespace floes {
namespace {

/// As member_key() has it.
std::size_t number_of(const Campaign& campaign, const MemberKey& key) {
    return static_cast<std::size_t>(key.arrangement) * campaign.cases.size() + static_cast<std::size_t>(key.case_index);
}

/// Calls `use` with the number of each record and of each member that it is a record of. Cases of equal physics share
/// their records.
template <class Use>
void for_each_match(const Campaign& campaign, const MemberNotes& notes, const Use& use) {
    std::vector<std::vector<int>> cases_of_key(notes.keys().size());
    for (int k = 0; k < static_cast<int>(campaign.cases.size()); ++k) {
        const auto key = notes.keys().find(case_fingerprint(campaign, k));
        if (key != notes.keys().end()) cases_of_key[static_cast<std::size_t>(key->second)].push_back(k);
    }
    for (std::size_t record = 0; record < notes.size(); ++record) {
        const MemberNote& note = notes[record];
        if (note.arrangement < 0 || note.arrangement >= campaign.arrangements) continue;
        for (const int case_index : cases_of_key[static_cast<std::size_t>(note.key)])
            use(record, number_of(campaign, {case_index, note.arrangement}));
    }
}

/// How far the record's arrays go along the axes of which it alone knows that.
std::array<int, found_axes.size()> found_in(const MemberRecord& record) {
    std::array<int, found_axes.size()> found{};
    for (std::size_t number = 0; number < array_outputs.size(); ++number) {
        const auto& axes = array_outputs[number].axes;
        for (std::size_t k = 0; k < axes.size() && axes[k] != nullptr; ++k) {
            const auto at = std::ranges::find(found_axes, axes[k]);
            if (at == found_axes.end()) continue;
            const PackedArray array = record.array(number);
            if (!array.empty())
                found[static_cast<std::size_t>(at - found_axes.begin())] = static_cast<int>(array.sizes[k]);
        }
    }
    return found;
}

MemberNotes notes_of(std::span<const MemberRecord> records) {
    MemberNotes notes;
    for (const MemberRecord& record : records) notes.add(record);
    return notes;
}

}  // namespace

int found_along(const MemberNote& note, const ArrayAxis& axis) {
    return note.found.at(static_cast<std::size_t>(std::ranges::find(found_axes, &axis) - found_axes.begin()));
}

void MemberNotes::add(const MemberRecord& record) {
    const int key = keys_.try_emplace(record.case_key, static_cast<int>(keys_.size())).first->second;
    notes_.push_back({.wall_time = record.result.wall_time,
                      .key = key,
                      .arrangement = record.arrangement,
                      .attempt = record.attempt,
                      .found = found_in(record),
                      .status = record.result.status});
}

void MemberNotes::add(const MemberNotes& others) {
    std::vector<int> key_here(others.keys().size());
    for (const auto& [key, there] : others.keys())
        key_here[static_cast<std::size_t>(there)] =
            keys_.try_emplace(key, static_cast<int>(keys_.size())).first->second;
    for (MemberNote note : others.notes_) {
        note.key = key_here[static_cast<std::size_t>(note.key)];
        notes_.push_back(note);
    }
}

StoredMembers::StoredMembers(const MemberNotes& notes, Read read) : notes_(notes), read_(std::move(read)) {}

StoredMembers::StoredMembers(std::span<const MemberRecord> records)
    : own_(notes_of(records)), notes_(own_), read_([records](std::size_t k) { return records[k]; }) {}

std::vector<std::optional<std::size_t>> match_records(const Campaign& campaign, const MemberNotes& notes) {
    std::vector<std::optional<std::size_t>> matched(static_cast<std::size_t>(member_count(campaign)));
    for_each_match(campaign, notes, [&](std::size_t record, std::size_t member) {
        std::optional<std::size_t>& known = matched[member];
        if (!known || !notes[*known].done()) known = record;
    });
    return matched;
}

std::vector<int> last_attempts(const Campaign& campaign, const MemberNotes& notes) {
    std::vector<int> attempts(static_cast<std::size_t>(member_count(campaign)), 0);
    for_each_match(campaign, notes, [&](std::size_t record, std::size_t member) {
        attempts[member] = std::max(attempts[member], notes[record].attempt);
    });
    return attempts;
}

}  // namespace floes
