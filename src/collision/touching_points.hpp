#pragma once
// The points at which two bodies touch, from step to step: they last while their two halves stay near each other, and
// keep their impulses. The rules of Bullet's btPersistentManifold, to the last bit.

#include <array>

#include "collision/box.hpp"
#include "collision/box_box.hpp"

namespace floes {

struct TouchingPoint {
    Triple in_a{};  ///< m, in the axes of body a
    Triple in_b{};
    Triple on_a{};  ///< m, world
    Triple on_b{};
    Triple normal{};              ///< unit, from b to a
    double distance = 0;          ///< m, along the normal; negative where they overlap
    double impulse = 0;           ///< N s, of the last solve, on a along the normal
    Triple slide{};               ///< of the friction impulse, unit; zero where there is none
    double friction_impulse = 0;  ///< N s
};

class TouchingPoints {
  public:
    int count() const { return count_; }
    TouchingPoint& operator[](int i) { return points_[static_cast<std::size_t>(i)]; }
    const TouchingPoint& operator[](int i) const { return points_[static_cast<std::size_t>(i)]; }

    /// Takes up the points of an overlap, at most four in all, and drops those whose halves are `reach` apart. m.
    void update(const BoxPlace& a, const BoxPlace& b, const BoxOverlap& overlap, double reach);

  private:
    void add(const TouchingPoint& point, double reach);
    int least_wanted(const TouchingPoint& added) const;
    void refresh(const BoxPlace& a, const BoxPlace& b, double reach);

    static constexpr int most = 4;
    std::array<TouchingPoint, most> points_;
    int count_ = 0;
};

}  // namespace floes
