#pragma once
// Writes down who computed what on this rank.

#include <string>
#include <vector>

#include "driver/crew.hpp"
#include "records/member_record.hpp"

namespace floes {

std::string host_name();

class Scribe {
  public:
    /// `campaign` must outlive the scribe.
    Scribe(const Campaign& campaign, int rank);

    /// Of an outcome that has a result.
    MemberRecord record(Outcome outcome) const;

  private:
    const Campaign& campaign_;
    int rank_;
    std::string host_;
    std::vector<std::string> case_keys_;
};

}  // namespace floes
