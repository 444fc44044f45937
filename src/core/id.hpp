#pragma once
// Indices that cannot be mixed up: BodyId and JointId are different types over the same integer.

#include <compare>
#include <cstddef>
#include <cstdint>

namespace floes {

/// An index, from 0, of the kind named by Tag.
template <class Tag>
class Id {
  public:
    constexpr explicit Id(std::size_t index) : value_(static_cast<std::uint32_t>(index)) {}

    constexpr std::size_t index() const { return value_; }
    friend constexpr auto operator<=>(Id, Id) = default;

  private:
    std::uint32_t value_;
};

}  // namespace floes
