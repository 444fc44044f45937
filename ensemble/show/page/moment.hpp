#pragma once
// A member with a large load in pictures: how the floes lay before, at the largest load, and at the end.

#include <string>
#include <vector>

namespace floes {

struct MomentPicture {
    std::string png;      ///< its bytes
    std::string caption;  ///< what is to be seen
};

struct Moment {
    int member = 0;
    std::vector<MomentPicture> pictures;
    std::vector<std::string> differences;  ///< of the member computed for them from the one in the file
};

}  // namespace floes
