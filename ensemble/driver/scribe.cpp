#include "driver/scribe.hpp"

#include <unistd.h>

#include <array>
#include <utility>

#include "campaign/identity.hpp"

namespace floes {

std::string host_name() {
    std::array<char, 256> name{};
    ::gethostname(name.data(), name.size() - 1);
    return name.data();
}

Scribe::Scribe(const Campaign& campaign, int rank) : campaign_(campaign), rank_(rank), host_(host_name()) {
    for (int i = 0; i < static_cast<int>(campaign.cases.size()); ++i) {
        case_keys_.push_back(case_fingerprint(campaign, i));
    }
}

MemberRecord Scribe::record(Outcome outcome) const {
    const MemberKey key = member_key(campaign_, outcome.assignment.number);
    MemberRecord record;
    record.case_key = case_keys_[static_cast<std::size_t>(key.case_index)];
    record.arrangement = key.arrangement;
    record.attempt = outcome.assignment.attempt;
    record.rank = rank_;
    record.host = host_;
    record.peak_memory = outcome.peak_memory;
    record.result = std::move(*outcome.result);
    record.history = std::move(outcome.history);
    return record;
}

}  // namespace floes
