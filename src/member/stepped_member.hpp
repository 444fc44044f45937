#pragma once
// A member step by step: what run_member() runs to its end, and what another program steps.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "arrangement/arrangement.hpp"
#include "core/bytes.hpp"
#include "core/vector.hpp"
#include "scenario/scenario.hpp"
#include "simulation/simulation.hpp"

namespace floes {

/// What another program gives the hull at the beginning of some steps.
struct HullInput {
    Wrench load{};               ///< of one that gives way: FromOutside::load, the same in all these steps
    Vec6 offset = Vec6::Zero();  ///< of one that others lead: FromOutside::offset, at the beginning of these steps ...
    Vec6 velocity = Vec6::Zero();  ///< ... and how fast it changes in them, m/s and rad/s
};

class SteppedMember {
  public:
    /// At its start. `led_from`: others lead the hull, which begins at this offset (Simulation::lead_hull); none: it
    /// moves by itself. Throws InputError for a scenario that cannot be built or an arrangement that cannot be made.
    SteppedMember(const Scenario& scenario, std::uint64_t seed, std::uint32_t arrangement,
                  const Vec6* led_from = nullptr);

    const Arrangement& floes() const { return laid_.floes; }  ///< at the start
    Simulation& simulation() { return *simulation_; }
    const Simulation& simulation() const { return *simulation_; }

    /// So many steps, at least one. The mean load of the ice on the hull over them, its impulse over their time: in the
    /// world's axes and about the hull's reference point, N and N m. Throws MemberFailure as Simulation::step() does.
    Wrench step(int steps, const HullInput& input);

    /// Simulation::set() at any time, of a member with the same arguments; `led_from` may differ. Throws RunError for
    /// bytes that are of no such member, which is then of no use.
    void set(std::span<const std::byte> saved);

  private:
    void begin();

    Scenario scenario_;
    std::uint64_t seed_;
    std::uint32_t arrangement_;
    bool led_;
    Vec6 led_from_;
    LaidField laid_;
    std::optional<Simulation> simulation_;
};

}  // namespace floes
