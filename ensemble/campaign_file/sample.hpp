#pragma once
// The members of a campaign in columns: a value of each member, or a row of values along the axes that its array lies
// along (segments, averaging times, parts, levels ...). Statistics take groups of members and a column:
//
//     const Sample sample(table);
//     std::vector<double> means = sample.values(sample.done(0), quantity("mean_load"));
//     std::span<const double> maxima = sample.along("members/segment_maximum", member);

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign_file/campaign_table.hpp"

namespace floes {

/// Members by number.
using Members = std::vector<std::size_t>;

class Sample {
  public:
    /// The table's members: their quantities by key, the arrays that are read with them by path.
    Sample(const CampaignTable& table);  // NOLINT: a table is a sample

    std::size_t cases() const { return done_.size(); }
    std::size_t members() const { return case_of_.size(); }
    /// Done members of a case by arrangement.
    const Members& done(std::size_t of_case) const { return done_.at(of_case); }
    std::size_t case_of(std::size_t member) const { return case_of_.at(member); }
    /// Equal for members that began from the same floes.
    int arrangement_of(std::size_t member) const { return arrangement_of_.at(member); }
    /// The number of the member's arrangement, as people name it: that of its case.
    int number_of(std::size_t member) const { return static_cast<int>(member / cases()); }

    /// For each of the members; NaN where it was not measured.
    std::vector<double> values(const Members& members, const Quantity& quantity) const;
    double value(std::size_t member, const Quantity& quantity) const;

    /// All numbers of a member in that array, row-major; none where it does not have it.
    std::span<const double> along(std::string_view array, std::size_t member) const;
    /// Row `place` of an array along two axes, without what only fills it up.
    std::span<const double> along(std::string_view array, std::size_t member, std::size_t place) const;
    /// Where a member has the averaging time along the arrays "averaged/..."; none where it did not take it.
    std::optional<std::size_t> place_of_time(std::size_t member, double time) const;
    /// The place of each member along an array of one axis, or at `second` along the other of two; NaN where it ends
    /// before.
    std::vector<double> values(const Members& members, std::string_view array, std::size_t place,
                               std::size_t second = 0) const;

  private:
    struct Array {
        std::vector<std::size_t> first;  ///< of each member, and the end
        std::vector<std::size_t> width;  ///< of each member: places along the last axis
        std::vector<double> values;
    };

    void add(std::string_view path, std::span<const double> values, std::size_t width);

    std::vector<Members> done_;
    std::vector<std::size_t> case_of_;
    std::vector<int> arrangement_of_;
    std::map<std::string, std::vector<double>, std::less<>> columns_;  ///< by key, a value of each member
    std::map<std::string, Array, std::less<>> arrays_;                 ///< by path
};

}  // namespace floes
