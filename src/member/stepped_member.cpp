#include "member/stepped_member.hpp"

#include <utility>

#include "core/contract.hpp"

namespace floes {

SteppedMember::SteppedMember(const Scenario& scenario, std::uint64_t seed, std::uint32_t arrangement,
                             const Vec6* led_from)
    : scenario_(scenario),
      seed_(seed),
      arrangement_(arrangement),
      led_(led_from != nullptr),
      led_from_(led_ ? *led_from : Vec6::Zero()),
      laid_(lay_field(scenario_, seed, arrangement)) {
    begin();
}

void SteppedMember::begin() {
    simulation_.emplace(scenario_, laid_.laid(), std::move(laid_.ahead));
    if (led_) simulation_->lead_hull(led_from_);
}

Wrench SteppedMember::step(int steps, const HullInput& input) {
    FLOES_EXPECTS(steps > 0);
    Wrench sum;
    for (int k = 1; k <= steps; ++k) {
        const double time = k * scenario_.general.time_step;
        simulation_->step({input.load, input.offset + time * input.velocity});
        sum += simulation_->ice_load();
    }
    return {sum.force / steps, sum.moment / steps};
}

void SteppedMember::set(std::span<const std::byte> saved) {
    if (simulation_->steps() > 0) {
        if (scenario_.field.endless())
            laid_ = lay_field(scenario_, seed_, arrangement_);  // what lies ahead is laid again
        begin();
    }
    simulation_->set(saved);
}

}  // namespace floes
