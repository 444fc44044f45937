#pragma once
// How large the ice is before and after the structure: floes at the start, floes and pieces at the end. The size of ice
// is D, the side of the square with its area.

#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "campaign_file/read.hpp"
#include "findings/evidence.hpp"
#include "tables/section.hpp"

namespace floes {

/// Area by size.
class IceSizes {
  public:
    /// Adds ice of one area, m²; a negative share takes it away again.
    void add(double area, double share = 1);

    double area() const;   ///< of all, m²
    double count() const;  ///< of all floes and pieces

    /// D below which this share (0 to 1) of the area is, m; NaN without ice.
    double quantile(double share) const;

    /// D and the share of the area in ice of at most this size, rising, as steps.
    std::vector<std::pair<double, double>> steps() const;

  private:
    struct Sum {
        double count = 0, area = 0;
    };
    std::map<long long, Sum> by_area_;  // in 10⁻⁹ m²: a floe is as large as its pieces together
};

struct SizesOfCase {
    std::size_t case_index = 0;
    int runs = 0;
    double split = 0;        ///< floes that cracked through, mean over members
    double pieces = 0;       ///< of one of them, mean
    double in_pieces = 0;    ///< share of the area that is in pieces, 0 to 1
    IceSizes before, after;  ///< sums over members
};

/// Areas of the floes of a member, by its number, m²; of a field without end those of a part, of which as many count as
/// entered.
using FloeAreas = std::function<std::vector<double>(int member)>;

/// For every case with done members. `pieces`: in order of member and floe.
std::vector<SizesOfCase> find_piece_sizes(const CampaignTable& table, std::span<const PieceRow> pieces,
                                          const FloeAreas& floes);

/// Part "pieces" of floes summarize.
Section piece_sizes_section(Evidence& evidence);

}  // namespace floes
