#include "simulation/moving_window.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "scenario/sizes.hpp"

namespace floes {
namespace {

constexpr double strides_in_a_floe = 4;  // more strides lay the solver out anew more often
constexpr double floes_in_reserve = 3;   // side by side: what is pushed cannot pass them

}  // namespace

MovingWindow::MovingWindow(const Scenario& scenario, const FloeSet& floes, IceAhead ahead)
    : ahead_(scenario.window_ahead()),
      behind_(scenario.window_behind()),
      stride_(largest_side(floes) / strides_in_a_floe),
      least_(window_least(scenario)),
      reserve_(floes_in_reserve * largest_side(floes)),
      at_(-std::numeric_limits<double>::infinity()),
      ice_(std::move(ahead)) {
    for (std::size_t i = 0; i < floes.size(); ++i)
        places_.push_back({floes.floes[i].pose, floes.shape(i), floes.material(i)});
}

bool MovingWindow::moves_to(double structure_x) {
    const double at = std::max(at_, stride_ * std::floor(structure_x / stride_));
    return std::exchange(at_, at) != at;
}

std::vector<SingleFloe> MovingWindow::next_part() {
    if (ice_.end > last() + reserve_) return {};
    FieldPart part = ice_.next();
    ice_.end = part.end;
    return std::move(part.floes);
}

}  // namespace floes
