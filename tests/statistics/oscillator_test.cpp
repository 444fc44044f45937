// A mass on a spring and a damper against closed forms.

#include "statistics/oscillator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/contract.hpp"

namespace floes {
namespace oscillator_test {

constexpr double pi = std::numbers::pi;

/// Of 1 s, 250 kg and 9.87 kN/m.
Oscillator of_a_second(double damping_ratio) {
    return {.stiffness = 1000 * pi * pi, .mass = 250, .damping_ratio = damping_ratio};
}

double largest_offset(const std::vector<OscillatorState>& states) {
    return std::ranges::max(states, {}, &OscillatorState::offset).offset;
}

/// F cos(Ω t) as means over intervals of h, from t = 0.
std::vector<double> cosine(double force, double frequency, double step, std::size_t count) {
    std::vector<double> load;
    for (std::size_t k = 0; k < count; ++k) {
        const double from = frequency * step * static_cast<double>(k);
        load.push_back(force * (std::sin(from + frequency * step) - std::sin(from)) / (frequency * step));
    }
    return load;
}

TEST(Oscillator, HasItsPeriod) {
    const Oscillator oscillator = of_a_second(0.1);
    EXPECT_NEAR(oscillator.period(), 1, 1e-12);
    EXPECT_NEAR(oscillator.damping(), 2 * 0.1 * std::sqrt(oscillator.stiffness * oscillator.mass), 1e-9);
    EXPECT_NEAR(oscillator.decay_rate(), 0.1 * 2 * pi, 1e-12);
}

// A step overshoots by e^(-πζ/√(1-ζ²)), half a damped period later, and ends at F/k.
TEST(Oscillator, OvershootsAStep) {
    for (const double zeta : {0.0, 0.05, 0.2, 0.7}) {
        const Oscillator oscillator = of_a_second(zeta);
        const double step = 1 / (2 * std::sqrt(1 - zeta * zeta)) / 50;  // half a damped period has 50
        const std::vector<OscillatorState> states = motion_under(oscillator, std::vector<double>(5000, 30.0), step);
        const double overshoot = 1 + std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta));
        EXPECT_NEAR(largest_offset(states) * oscillator.stiffness / 30, overshoot, 1e-9) << zeta;
        EXPECT_NEAR(states[49].offset * oscillator.stiffness / 30, overshoot, 1e-12) << zeta;
        EXPECT_NEAR(states[49].velocity, 0, 1e-12) << zeta;
        if (zeta > 0) {
            EXPECT_NEAR(states.back().offset * oscillator.stiffness / 30, 1, 1e-6) << zeta;
        }
    }
}

// x = e^(-ζωt) (x₀ cos ω_d t + (v₀ + ζω x₀)/ω_d sin ω_d t), exact at any step.
TEST(Oscillator, DecaysFreely) {
    const double zeta = 0.15;
    const Oscillator oscillator = of_a_second(zeta);
    const double omega = 2 * pi;
    const double damped = omega * std::sqrt(1 - zeta * zeta);
    for (const double step : {0.01, 0.3, 1.7}) {
        const std::vector<OscillatorState> states =
            motion_under(oscillator, std::vector<double>(10, 0.0), step, {.offset = 0.2, .velocity = -1});
        for (std::size_t k = 0; k < states.size(); ++k) {
            const double t = step * static_cast<double>(k + 1);
            const double exact =
                std::exp(-zeta * omega * t) *
                (0.2 * std::cos(damped * t) + (-1 + zeta * omega * 0.2) / damped * std::sin(damped * t));
            EXPECT_NEAR(states[k].offset, exact, 1e-13) << step << " " << k;
        }
    }
}

// The amplitude under F cos Ωt is F/k / √((1 - r²)² + (2ζr)²), r = Ω/ω: 1/(2ζ) at r = 1, 1 for slow loads.
TEST(Oscillator, FollowsASine) {
    const double step = 0.005;
    for (const double zeta : {0.05, 0.1, 0.3})
        for (const double r : {0.01, 0.5, 1.0, 3.0}) {
            const Oscillator oscillator = of_a_second(zeta);
            const std::vector<OscillatorState> states =
                motion_under(oscillator, cosine(30, 2 * pi * r, step, 60000), step);
            const std::vector<OscillatorState> later(states.begin() + 30000, states.end());
            const double exact = 1 / std::hypot(1 - r * r, 2 * zeta * r);
            EXPECT_NEAR(largest_offset(later) * oscillator.stiffness / 30, exact, 2e-3 * exact) << zeta << " " << r;
        }
}

// Without damping, what the load does is in the spring and the mass, to rounding: no numerical damping.
TEST(Oscillator, KeepsEnergy) {
    const Oscillator oscillator = of_a_second(0);
    std::vector<double> load;
    for (int k = 0; k < 20000; ++k) load.push_back(20 + 15 * std::sin(0.37 * k) * std::cos(0.011 * k * k));
    double work = 0;
    double most = 0;
    OscillatorState last;
    for (std::size_t k = 0; const OscillatorState& at : motion_under(oscillator, load, 0.05)) {
        work += load[k++] * (at.offset - last.offset);
        last = at;
        const double energy =
            oscillator.stiffness * at.offset * at.offset / 2 + oscillator.mass * at.velocity * at.velocity / 2;
        most = std::max(most, energy);
        ASSERT_NEAR(work, energy, 1e-9 * most) << k;
    }
}

// With damping, the damper takes ∫ c v² dt, by Simpson's rule on steps a fortieth as long, which have the same states.
TEST(Oscillator, LosesEnergyInTheDamperAlone) {
    const Oscillator oscillator = of_a_second(0.12);
    std::vector<double> coarse;
    std::vector<double> fine;
    for (int k = 0; k < 500; ++k) {
        coarse.push_back(20 + 15 * std::sin(0.37 * k));
        fine.insert(fine.end(), 40, coarse.back());
    }
    const std::vector<OscillatorState> ends = motion_under(oscillator, coarse, 0.05);
    const std::vector<OscillatorState> states = motion_under(oscillator, fine, 0.05 / 40);
    double balance = 0;
    OscillatorState last;
    for (std::size_t k = 0; k + 1 < states.size(); k += 2) {
        const auto power = [&](const OscillatorState& at) { return oscillator.damping() * at.velocity * at.velocity; };
        balance += fine[k] * (states[k + 1].offset - last.offset);
        balance -= 0.05 / 40 / 3 * (power(last) + 4 * power(states[k]) + power(states[k + 1]));
        last = states[k + 1];
    }
    EXPECT_NEAR(ends.back().offset, last.offset, 1e-13);
    EXPECT_NEAR(
        balance,
        oscillator.stiffness * last.offset * last.offset / 2 + oscillator.mass * last.velocity * last.velocity / 2,
        1e-7);
}

// Independent forces with variance s² in intervals of h are white noise with two-sided density S0 = s² h / 2π up to
// high frequencies, under which the variance of x is π S0 / (2 ζ ω³ m²). The variance is s² Σ x_j² of the response to
// one force of 1 N in one interval. The error falls with the square of the interval.
TEST(Oscillator, HasTheVarianceUnderWhiteNoise) {
    const double zeta = 0.1;
    const Oscillator oscillator = of_a_second(zeta);
    const auto ratio = [&](double step) {
        std::vector<double> load(static_cast<std::size_t>(30 / step), 0);
        load.front() = 1;
        double sum = 0;
        for (const OscillatorState& at : motion_under(oscillator, load, step)) sum += at.offset * at.offset;
        const double density = step / (2 * pi);
        return sum / (pi * density / (2 * zeta * std::pow(2 * pi, 3) * 250 * 250));
    };
    EXPECT_NEAR(ratio(0.05), 1, 0.01);
    EXPECT_NEAR(ratio(0.01), 1, 4e-4);
    EXPECT_NEAR((ratio(0.02) - 1) / (ratio(0.01) - 1), 4, 0.1);
}

// Froude, 1 : 36: loads grow with λ³, stiffness with λ², mass with λ³, times with √λ; then offsets grow with λ.
TEST(Oscillator, ScalesByFroude) {
    const double scale = 36;
    const Oscillator model = of_a_second(0.08);
    const Oscillator full{model.stiffness * scale * scale, model.mass * scale * scale * scale, 0.08};
    std::vector<double> load;
    std::vector<double> full_load;
    for (int k = 0; k < 3000; ++k) {
        load.push_back(20 + 15 * std::sin(0.37 * k) + std::cos(0.003 * k * k));
        full_load.push_back(load.back() * scale * scale * scale);
    }
    const std::vector<OscillatorState> small = motion_under(model, load, 0.05);
    const std::vector<OscillatorState> large = motion_under(full, full_load, 0.05 * 6);
    for (std::size_t k = 0; k < small.size(); ++k) {
        EXPECT_NEAR(large[k].offset, scale * small[k].offset, 1e-12);
        EXPECT_NEAR(large[k].velocity, 6 * small[k].velocity, 1e-11);
    }
}

// v = F t / m, x = F t² / 2 m.
TEST(Oscillator, WithoutASpringIsAFreeMass) {
    const std::vector<OscillatorState> states =
        motion_under({.mass = 4, .damping_ratio = 0.5}, std::vector{3.0, 3.0}, 2);
    EXPECT_DOUBLE_EQ(states[1].velocity, 3.0);
    EXPECT_DOUBLE_EQ(states[1].offset, 6.0);
}

TEST(Oscillator, RefusesWhatIsNone) {
    const std::vector<double> load{1, 2};
    for (const Oscillator& none :
         {Oscillator{-1, 1, 0.1}, Oscillator{1, 0, 0.1}, Oscillator{1, 1, 1}, Oscillator{1, 1, -0.1}})
        EXPECT_THROW(motion_under(none, load, 0.1), ContractError);
    EXPECT_THROW(motion_under(of_a_second(0.1), load, 0), ContractError);
    EXPECT_TRUE(motion_under(of_a_second(0.1), {}, 0.1).empty());
}

}  // namespace oscillator_test
}  // namespace floes
