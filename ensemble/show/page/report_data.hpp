#pragma once
// What the report tells beside its findings.

#include <string>
#include <vector>

#include "findings/catalogue.hpp"

namespace floes {

struct MomentPicture {
    std::string png;      ///< its bytes
    std::string caption;  ///< what is to be seen
};

/// A member with a large load in pictures: how the floes lay before, at the largest load, and at the end.
struct Moment {
    int member = 0;
    std::vector<MomentPicture> pictures;
    std::vector<std::string> differences;  ///< of the member computed for them from the one in the file
};

struct ReportData {
    Evidence evidence;
    std::vector<Moment> moments;  ///< the worst ones; empty: no pictures were made
    std::string command;          ///< that repeats the campaign
};

}  // namespace floes
