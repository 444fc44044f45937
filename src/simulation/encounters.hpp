#pragma once
// Which floes were computed, and which of them touched the structure: what counts of broken floes are relative to.

#include <cstdint>
#include <span>
#include <vector>

#include "ice/ice_field.hpp"
#include "world/world.hpp"

namespace floes {

class Encounters {
  public:
    /// Floes from now on computed.
    void enter(int floes) { entered_ += floes; }

    /// After a step: contacts of the structure in it. Allocates nothing unless the ice has a place more.
    void meet(std::span<const ContactForce> contacts, const IceField& ice);

    /// Before the floe at this place leaves the ice.
    void leave(int place, const IceField& ice);

    int entered() const { return entered_; }
    int met(const IceField& ice) const;         ///< that touched the structure
    int met_broken(const IceField& ice) const;  ///< of these, with a failed joint

  private:
    bool has_met(int place) const;

    int entered_ = 0;
    int left_met_ = 0, left_broken_ = 0;  // of floes that have left
    std::vector<std::uint8_t> met_;       // by place
};

}  // namespace floes
