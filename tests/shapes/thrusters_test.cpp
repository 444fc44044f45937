// The law of thrusters against closed forms.

#include "shapes/moorings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace floes {
namespace thrusters_test {

constexpr double mass = 500;

/// Of the natural period 2π s.
Thrusters thrusters(double limit) {
    return {.gain = {500, 500, 500}, .limit = {limit, 0, 0}, .damping = 0.5};
}

TEST(Thrusters, PullBackAsFarAsTheyCan) {
    const ThrustLaw law = thrust_law(thrusters(300), 0, mass);
    EXPECT_DOUBLE_EQ(law.damping, 500) << "2 ζ √(K M)";
    EXPECT_DOUBLE_EQ(thrust(law, 0.2, 0.1), -150);
    EXPECT_EQ(thrust(law, 0.6, 0.1), -300);
    EXPECT_EQ(thrust(law, -5, 0.1), 300);
    EXPECT_DOUBLE_EQ(thrust(thrust_law(thrusters(300), 1, mass), -5, 0), 2500) << "no limit abeam";
    EXPECT_FALSE(Thrusters{}.any());
}

// Against 100,000 small steps of v' = F(v)/M, above the limit, below it, from one to the other, and without damping.
TEST(Thrusters, SlowDownWithoutError) {
    for (const double limit : {0.0, 300.0, 30.0}) {
        for (const double zeta : {0.0, 0.5}) {
            Thrusters one = thrusters(limit);
            one.damping = zeta;
            const ThrustLaw law = thrust_law(one, 0, mass);
            for (const double offset : {-0.4, 0.05}) {
                for (const double before : {-1.5, 0.3, 2.0}) {
                    constexpr int count = 100000;
                    constexpr double time = 1.5;
                    double stepped = before;
                    for (int k = 0; k < count; ++k) stepped += time / count * thrust(law, offset, stepped) / mass;
                    EXPECT_NEAR(velocity_under_thrust(law, offset, before, mass, time), stepped, 3e-5)
                        << limit << " " << zeta << " " << offset << " " << before;
                }
            }
        }
    }
}

// w = K e + D v falls by L/M D a second above the limit, then by e^(-D t / M).
TEST(Thrusters, LeaveTheirLimitAtAKnownTime) {
    const ThrustLaw law = thrust_law(thrusters(300), 0, mass);
    // w from 700 to 300 N in 400 / (300 · 1 1/s) s, then a second more.
    const double after = velocity_under_thrust(law, 0.4, 1.0, mass, 400.0 / 300 + 1);
    EXPECT_NEAR(law.gain * 0.4 + law.damping * after, 300 * std::exp(-1.0), 1e-9);
}

}  // namespace thrusters_test
}  // namespace floes
