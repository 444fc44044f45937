#pragma once
// Floes whose joints are solved exactly. The velocities of a connected piece at the end of a step follow from one
// linear system (solver/piece_compliance.hpp), so an impulse on one element moves the whole piece at once, and only
// contacts between pieces are iterated.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "solver/aligned_array.hpp"
#include "solver/lane_layout.hpp"
#include "solver/piece_compliance.hpp"
#include "solver/solver_parts.hpp"

namespace floes {

/// Where the bodies and joints of a system lie in its lanes.
struct LaneSlots {
    std::span<const std::uint32_t> body;
    std::span<const std::uint32_t> joint;
    std::size_t body_groups;
    std::size_t joint_groups;
};

class DirectFloes {
  public:
    /// `kernels`: of the slots' width; `widest`: for what bodies do one by one.
    DirectFloes(std::span<const SolverBody> bodies, std::span<const SolverJoint> joints, const LaneSlots& slots,
                const LaneKernels& kernels, const LaneKernels& widest);

    /// Takes effect in the next step.
    void remove_joint(std::size_t joint);

    /// The share of its stiffness against bending and torsion that the joint has left. Takes effect in the next step.
    void soften_joint(std::size_t joint, double sound);

    /// Takes effect in the next step.
    void set_water(std::size_t body, const CarriedWater& water);

    /// Applies the joints as they act without contacts, from the bodies' start velocities.
    void prepare(const LaneArrays& all, std::span<const LaneBlock> blocks, double time_step);

    /// Prepares impulses on the bodies in these contacts: fills `delta` of all bodies that they may move.
    void touch(const LaneArrays& all, std::span<const SolverContact> contacts);

    /// Velocity changes of the pieces by all impulses, and the reactions of the joints.
    void finish(const LaneArrays& all, std::span<const LaneBlock> blocks);

    DirectArrays arrays() { return {local_.data(), spring_.data(), impulse_.data()}; }

    /// By slot of a body, and for the spare slot after them; valid from touch() on.
    const ComplianceColumn* columns() const { return columns_.data(); }

    /// Of the bodies in contacts whose velocities impulses change; valid from touch() on.
    std::span<const std::uint32_t> touched_slots() const { return touched_slots_; }

    /// The piece of a body: two of one piece move together.
    std::uint32_t piece(std::size_t body) const { return piece_of_body_[body]; }

    bool moves(std::size_t body) const { return bodies_[body].inverse_mass > 0; }

  private:
    struct Piece {
        std::vector<std::uint32_t> bodies;         ///< rising
        std::vector<std::uint32_t> joints;         ///< alive, rising
        std::vector<std::uint32_t> slots, within;  ///< of the bodies, and 0, 1, 2, …
        std::vector<Mat3> at_rest;                 ///< body -> piece, unstrained
        std::shared_ptr<PieceCompliance> compliance;
        std::vector<std::uint32_t> touched_slots, touched_within;
        bool broken = false;  ///< joints were removed since it was found
    };

    void store_water(std::size_t body);
    void split(std::size_t piece);
    void make_compliance(Piece& piece);
    void find_compliance(Piece& piece, std::vector<PieceBody> bodies, std::vector<PieceJoint> joints);
    PieceJoint at_rest(const Piece& piece, const SolverJoint& joint, const std::vector<PieceBody>& bodies,
                       std::array<double, 6>& stiffness) const;
    void store_spring(std::size_t joint, const PieceJoint& at_rest, const std::array<double, 6>& stiffness);
    void turn_frames(const LaneArrays& all);
    void apply_compliance(Piece& piece, const std::vector<std::uint32_t>& slots,
                          const std::vector<std::uint32_t>& within, double* delta);
    void apply_whole_compliance(Piece& piece, double* delta);

    const LaneKernels* kernels_;
    const LaneKernels* widest_;
    LaneSlots slots_;
    std::vector<SolverBody> bodies_;
    std::vector<SolverJoint> joints_;
    std::vector<Piece> pieces_;
    std::vector<std::uint32_t> piece_of_body_, within_piece_;
    std::vector<std::shared_ptr<PieceCompliance>> compliances_;  ///< shared by the pieces of one form
    bool stale_ = true;
    double time_step_ = 0;
    AlignedArray<double> local_, spring_, impulse_;
    AlignedArray<double> carried_;  ///< empty as long as no body carries water
    std::vector<ComplianceColumn> columns_;
    std::vector<std::uint32_t> touched_pieces_, touched_bodies_, touched_slots_;
    std::vector<std::uint8_t> is_touched_;  ///< by body
    std::vector<double> piece_impulse_, piece_change_;
};

}  // namespace floes
