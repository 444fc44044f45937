#include "statistics/oscillator.hpp"

#include "core/contract.hpp"

namespace floes {

OscillatorStep::OscillatorStep(const Oscillator& oscillator, double step) : stiffness_(oscillator.stiffness) {
    const bool real = oscillator.stiffness >= 0 && oscillator.mass > 0 && oscillator.damping_ratio >= 0 &&
                      oscillator.damping_ratio < 1 && step > 0;
    if (!real) throw ContractError("An oscillator has stiffness and mass, damping below the critical, and a step.");
    if (stiffness_ == 0) {
        offset_of_velocity_ = step;
        velocity_of_load_ = step / oscillator.mass;
        return;
    }
    const double omega = oscillator.angular_frequency();
    const double decay = oscillator.decay_rate();
    const double omega_damped = omega * std::sqrt(1 - oscillator.damping_ratio * oscillator.damping_ratio);
    const double fall = std::exp(-decay * step);
    const double cosine = std::cos(omega_damped * step);
    const double sine = std::sin(omega_damped * step) / omega_damped;  // s
    offset_of_offset_ = fall * (cosine + decay * sine);
    offset_of_velocity_ = fall * sine;
    velocity_of_offset_ = -fall * omega * omega * sine;
    velocity_of_velocity_ = fall * (cosine - decay * sine);
}

std::vector<OscillatorState> motion_under(const Oscillator& oscillator, std::span<const double> load, double step,
                                          OscillatorState start) {
    const OscillatorStep interval(oscillator, step);
    std::vector<OscillatorState> states;
    states.reserve(load.size());
    OscillatorState at = start;
    for (const double force : load) states.push_back(at = interval.after(at, force));
    return states;
}

double rms_rate(std::span<const double> values, double step) {
    FLOES_EXPECTS(values.size() >= 2 && step > 0);
    double squares = 0;
    for (std::size_t k = 1; k < values.size(); ++k) {
        const double rate = (values[k] - values[k - 1]) / step;
        squares += rate * rate;
    }
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

}  // namespace floes
