#include "driver/scribe.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <utility>

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

MemberRecord Scribe::record(Assignment assignment, MemberResult result) const {
    const MemberKey key = member_key(campaign_, assignment.number);
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    MemberRecord record;
    record.case_key = case_keys_[static_cast<std::size_t>(key.case_index)];
    record.arrangement = key.arrangement;
    record.attempt = assignment.attempt;
    record.rank = rank_;
    record.host = host_;
    record.peak_memory = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
    record.result = std::move(result);
    return record;
}

}  // namespace floes
