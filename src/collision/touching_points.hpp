#pragma once
// The points at which two bodies touch, from step to step: they last while their two halves stay near each other, and
// keep their impulses. The rules of Bullet's btPersistentManifold, to the last bit.

#include <array>
#include <cstdint>
#include <vector>

#include "collision/overlap.hpp"

namespace floes {

class StateArchive;

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
    double remembered_slip = -1;  ///< m/s, for friction that depends on it; below 0: the point is new
};

class TouchingPoints {
  public:
    int count() const { return count_; }
    TouchingPoint& operator[](int i) { return points_[static_cast<std::size_t>(i)]; }
    const TouchingPoint& operator[](int i) const { return points_[static_cast<std::size_t>(i)]; }

    // Lengths in m. `reach`: a point lasts while its halves are nearer than this.

    /// Takes up a point, at most four in all: where it is on b, the unit normal from b to a, and how far a is from
    /// there along it. One near a known point takes its place and its impulses.
    void add(const PrismPlace& a, const PrismPlace& b, const Triple& on_b, const Triple& normal, double distance,
             double reach);

    /// Gives each point the impulses of that one of `before` which is nearest to it on b, if nearer than `reach`.
    void take_impulses(const TouchingPoints& before, double reach);

    /// Moves the points with the bodies, and drops those whose halves have come apart.
    void refresh(const PrismPlace& a, const PrismPlace& b, double reach);

    void archive(StateArchive& state);  ///< core/state_archive.hpp

  private:
    int least_wanted(const TouchingPoint& added) const;

    static constexpr int most = 4;
    std::array<TouchingPoint, most> points_;
    int count_ = 0;
};

/// Two bodies that touch, and where in a store their points are. Ordered as contacts are solved.
struct Touching {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::int32_t solid = -1;  ///< of a structure's solids, which one it is at; -1: at none
    std::int32_t points = -1;

    friend bool operator<(const Touching& one, const Touching& other) {
        if (one.a != other.a) return one.a < other.a;
        return one.b != other.b ? one.b < other.b : one.solid < other.solid;
    }
};

/// The points of all that touches: of ice on ice and of ice on the structure. Places are used again.
class ContactStore {
  public:
    void reserve(std::size_t count);

    std::int32_t take();
    void give_back(std::int32_t place) { free_.push_back(place); }

    TouchingPoints& operator[](std::int32_t place) { return points_[static_cast<std::size_t>(place)]; }
    const TouchingPoints& operator[](std::int32_t place) const { return points_[static_cast<std::size_t>(place)]; }

    void archive(StateArchive& state);  ///< core/state_archive.hpp

  private:
    std::vector<TouchingPoints> points_;
    std::vector<std::int32_t> free_;
};

}  // namespace floes
