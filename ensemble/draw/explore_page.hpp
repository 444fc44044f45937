#pragma once
// The members of a campaign on one page that can be asked: points over any two quantities or inputs, histograms by
// case, load histories and parallel coordinates, in which what is brushed in one is marked in all. It asks nothing of
// the network; D3 is part of it, for scales, axes and brushes.
//
// Its streams, little endian; m done members, in member order:
//   members  2 m int32: their numbers, then their cases
//   columns  a column: m float32, as the header's list of columns has them; NaN where there is no value
//   history  a member: least and largest load of each part of its run, 2 int16 in the header's quantum; where it kept
//            no history, -32768

#include <cstddef>
#include <iosfwd>
#include <string>

namespace floes {

class CampaignFile;
struct Evidence;

struct ExploreOptions {
    std::string file;                     ///< the campaign file as people type it in commands
    std::size_t most_values = 4'000'000;  ///< of all columns; quantities that people are shown less are left out first
    std::size_t most_parts = 3'000'000;   ///< of all histories: each has at most 500 and at least 8 parts
};

/// `evidence`: of `file`. Throws InputError when no member is done.
void write_explore_page(std::ostream& page, const Evidence& evidence, const CampaignFile& file,
                        const ExploreOptions& options);

}  // namespace floes
