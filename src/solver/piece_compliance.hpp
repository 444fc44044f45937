#pragma once
// The compliance of a connected piece of ice: what impulses do to its velocities within one step. With stiffness K,
// damping D and masses M the velocities v at the end of an implicit step follow from
//
//   (M + Δt D + Δt² K) (v - v_free) = impulses,
//
// v_free being what they would be without them. The matrix is factorised once for all pieces of the same form: they
// differ by a turn in space only, and bend too little to differ by more (docs/fracture.md). A piece is flat, its joints
// in the plane of its bodies: so what moves it within its plane, and out of it, are two systems of half the size.

#include <Eigen/SparseCholesky>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/vector.hpp"
#include "solver/aligned_array.hpp"
#include "solver/carried_water.hpp"
#include "solver/lane_layout.hpp"
#include "solver/solver_parts.hpp"

namespace floes {

/// A body of an unstrained piece, in the piece's axes, y normal to its plane. Mass 0: it never moves.
struct PieceBody {
    double mass = 0;               ///< kg
    Mat3 inertia = Mat3::Zero();   ///< about the centre of mass, kg m²
    Mat3 turn = Mat3::Identity();  ///< body -> piece
    CarriedWater water{};          ///< in the body's axes
    int rail = -1;                 ///< axis along which alone it moves, of a body by itself
};

/// The body in a piece in which it is turned by `turn`, body -> piece.
PieceBody body_of(const SolverBody& body, const Mat3& turn);

/// Inertia of the body with the water that it carries, in the piece's axes: linear, then angular.
Eigen::Matrix<double, 6, 6> inertia_of(const PieceBody& body);

/// A joint of an unstrained piece, in the piece's axes.
struct PieceJoint {
    int a = 0;
    int b = 0;
    Mat3 axes = Mat3::Identity();  ///< joint -> piece
    Vec3 lever_a = Vec3::Zero();   ///< centre of mass of a -> pivot, m
    Vec3 lever_b = Vec3::Zero();   ///< likewise of b
    std::array<double, 6> hold{};  ///< Δt D + Δt² K of the linear, then of the angular parts: kg, kg m²
};

/// Two systems of one pattern, L D Lᵀ each, solved side by side: in the plane, and out of it. An unknown of either has
/// a place in the order of elimination; what a place depends on lies on its way to the root of the elimination tree.
class PlaneFactors {
  public:
    using Sparse = Eigen::SparseMatrix<double>;

    /// `like`: of matrices of much the same values, whose work is taken where it would be done again; nullptr: of none.
    /// Only what is `kept` can be taken later, for twice the memory.
    PlaneFactors(std::array<Sparse, 2> matrices, bool kept, const PlaneFactors* like);

    std::size_t size() const { return place_.size(); }
    std::size_t place(std::size_t unknown) const { return static_cast<std::size_t>(place_[unknown]); }

    /// The next place on the way to the root, which is above this one; size() from the root on.
    std::size_t next(std::size_t place) const;

    // Both take right sides `x`, `sides` in the plane and then as many out of it for the place that `slot` gives a
    // place of. Each does what it does by the operations, in their order, of Eigen's SimplicialLDLT: neither the number
    // of sides shows in the bits nor which other places are asked for.

    /// x ← D⁻¹ L⁻¹ x at rising places: all that are not zero, with their ways to the root.
    template <std::size_t sides, class Places, class Slot>
    void eliminate(const Places& places, double* x, const Slot& slot) const;

    /// x ← L⁻ᵀ x at falling places, of whose ways to the root the rest is known.
    template <std::size_t sides, class Places, class Slot>
    void substitute(const Places& places, double* x, const Slot& slot) const;

  private:
    std::vector<int> place_;
    std::vector<int> start_, row_;                             ///< of L, by column, below its diagonal
    std::vector<double> value_;                                ///< of both, one after the other
    std::vector<double> inverse_;                              ///< of D, likewise
    std::shared_ptr<Eigen::SimplicialLDLT<Sparse>> analysed_;  ///< by their pattern; none unless kept
    std::array<Sparse, 2> matrices_;                           ///< likewise
};

class PieceCompliance {
  public:
    /// Throws InputError for a piece that is not flat. `before`: of the same piece with other joints or water, which
    /// makes it sooner, to the same bits; nullptr: of none.
    PieceCompliance(std::vector<PieceBody> bodies, std::vector<PieceJoint> joints,
                    const PieceCompliance* before = nullptr);

    /// Whether this is the compliance of such a piece, lengths and masses equal to a relative 1e-9.
    bool is_of(std::span<const PieceBody> bodies, std::span<const PieceJoint> joints) const;

    std::size_t bodies() const { return bodies_.size(); }

    /// Small pieces know all of their compliance at once, by the numbers of the bodies.
    bool is_small() const { return bodies_.size() <= 64; }

    /// Makes what impulses on these bodies, and those of earlier calls, do to one another. Of large pieces nothing else
    /// is computed.
    void make_columns(std::span<const std::uint32_t> bodies);

    /// Of a body that make_columns() knows: its number in columns.
    std::uint32_t number(std::size_t body) const { return number_[body]; }

    /// What unit impulses on this body do to the velocities of all known ones: a compliance_block for each. Moves in
    /// memory when make_columns() meets new bodies.
    const double* column(std::size_t source) const { return columns_[source].data(); }

    /// Changes of velocity by impulses on all bodies, both 8 numbers a body in the order of a block's rows: of these
    /// bodies, which are all of them or known to make_columns(). For large pieces: it needs no columns.
    void velocity_changes(const double* impulses, std::span<const std::uint32_t> of, double* changes);

    /// Saves `known`, or sets it to the one that was saved (core/state_archive.hpp).
    static void archive(StateArchive& state, std::shared_ptr<PieceCompliance>& known);

  private:
    static constexpr std::size_t most_sources = 4;  ///< a factor that fills a cache is read once for all of them

    /// Columns of some bodies while more places of them may be asked for: by slots of places.
    struct Sources {
        std::vector<std::uint32_t> bodies;  ///< one, or most_sources
        std::vector<double> solved;
    };

    bool knows_all() const { return known_.size() == bodies_.size(); }
    std::vector<std::uint32_t> unknown_of(std::span<const std::uint32_t> bodies) const;
    std::vector<std::size_t> give_slots(std::span<const std::uint32_t> bodies);
    void add_sources(std::span<const std::uint32_t> bodies);
    template <class Task>
    static void for_size(const Sources& of, const Task& task);
    template <std::size_t sources>
    void eliminate(Sources& of) const;
    template <std::size_t sources>
    void substitute(Sources& of, std::span<const std::size_t> places, std::size_t first);

    std::vector<PieceBody> bodies_;
    std::vector<PieceJoint> joints_;
    PlaneFactors factors_;
    std::vector<std::uint32_t> known_;   ///< bodies by their numbers
    std::vector<std::uint32_t> number_;  ///< by body
    std::vector<std::size_t> places_;    ///< of known bodies with their ways to the root, falling
    std::vector<std::size_t> slot_;      ///< by place
    std::vector<Sources> sources_;       ///< empty once all bodies are known
    std::vector<AlignedArray<double>> columns_;
    std::vector<double> solved_;
};

/// J M⁻¹ Jᵀ of a joint's six parts: the inverse of the mass that each moves, 1/kg and 1/(kg m²).
std::array<double, 6> inverse_effective_mass(const PieceBody& a, const PieceBody& b, const PieceJoint& joint);

}  // namespace floes
