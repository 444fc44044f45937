#include "findings/report_sections.hpp"

#include <algorithm>

namespace floes {
namespace {

/// The interval of two arrangements is too wide to draw.
constexpr std::size_t fewest_drawn = 3;

}  // namespace

Section convergence_section(Evidence& evidence) {
    Figure figure{.description = "Mean load over the number of arrangements, with its interval",
                  .x = {"arrangements", 0, 2},
                  .legend = case_legend(evidence.summary),
                  .caption = "Mean load of the first n arrangements with its 95 % interval."};
    std::vector<double> drawn;
    for (std::size_t i = 0; i < evidence.table.cases.size(); ++i) {
        Figure::Points mean;
        Figure::Points low;
        Figure::Points high;
        std::vector<double> so_far;
        for (const MemberRow* member : done_members(evidence.table, i)) {
            so_far.push_back(member->load.mean);
            if (so_far.size() < fewest_drawn) continue;
            const double n = static_cast<double>(so_far.size());
            const Interval interval = mean_interval(so_far);
            mean.emplace_back(n, interval.estimate);
            low.emplace_back(n, interval.low);
            high.emplace_back(n, interval.high);
            drawn.insert(drawn.end(), {interval.low, interval.high});
            figure.x.high = std::max(figure.x.high, n);
        }
        figure.band(std::move(low), high, colour(i) + " veil");
        figure.line(std::move(mean), colour(i));
    }
    figure.x.high *= 1.02;
    figure.y = axis_around("mean load, N", drawn, true);
    return {.figures = {std::move(figure)}};
}

}  // namespace floes
