#pragma once
// The synthetic campaign as a campaign file of one session.

#include "campaign_file/publish.hpp"
#include "support/synthetic.hpp"

namespace floes::synthetic {

inline void publish(const std::filesystem::path& file, const Campaign& of, const std::vector<MemberRecord>& records) {
    floes::publish(file, of, records, std::vector<Session>{session()});
}

inline void publish(const std::filesystem::path& file, const Campaign& of = campaign()) {
    publish(file, of, records(of));
}

}  // namespace floes::synthetic
