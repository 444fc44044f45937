#include "findings/report_sections.hpp"

#include <algorithm>

#include "findings/printable.hpp"

namespace floes {
namespace {

/// The interval of two arrangements is too wide to draw.
constexpr std::size_t fewest_drawn = 3;

struct Curve {
    std::size_t of_case;
    Figure::Points mean;
    Figure::Points low;
    Figure::Points high;
};

}  // namespace

Section convergence_section(Evidence& evidence) {
    Figure figure{.description = "Mean load over the number of arrangements, with its interval",
                  .x = {"arrangements", 0, 2},
                  .legend = case_legend(evidence.summary),
                  .caption = "Mean load of the first n arrangements with its 95 % interval."};
    std::vector<double> drawn;
    std::vector<Curve> curves;
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
            drawn.push_back(interval.estimate);
            if (says_something(interval.estimate, {interval.low, interval.high}, static_cast<int>(so_far.size())))
                drawn.insert(drawn.end(), {interval.low, interval.high});
            figure.x.high = std::max(figure.x.high, n);
        }
        curves.push_back({i, std::move(mean), std::move(low), std::move(high)});
    }
    figure.x.high *= 1.02;
    figure.y = axis_around("mean load, N", drawn, true);
    for (Curve& curve : curves) {
        // Of the first few the interval may be far wider than anything else: it ends at the figure's edge.
        for (Figure::Points* limit : {&curve.low, &curve.high})
            for (auto& [n, load] : *limit) load = std::clamp(load, figure.y.low, figure.y.high);
        figure.band(std::move(curve.low), curve.high, colour(curve.of_case) + " veil");
        figure.line(std::move(curve.mean), colour(curve.of_case));
    }
    return {.figures = {std::move(figure)}};
}

}  // namespace floes
