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

class DirectFloes {
  public:
    /// Bodies and joints lie in the lanes by their numbers.
    DirectFloes(std::span<const SolverBody> bodies, std::span<const SolverJoint> joints, const LaneKernels& kernels);

    /// Takes effect in the next step.
    void remove_joint(std::size_t joint);

    /// The share of its stiffness against bending and torsion that the joint has left. Takes effect in the next step.
    void soften_joint(std::size_t joint, double sound);

    /// Takes effect in the next step.
    void set_water(std::size_t body, const CarriedWater& water);

    /// Applies the joints as they act without contacts, from the bodies' start velocities.
    void prepare(const LaneArrays& all, double time_step);

    /// Prepares impulses on the bodies in these contacts: fills `delta` of all bodies that they may move.
    void touch(const LaneArrays& all, std::span<const SolverContact> contacts);

    /// Velocity changes of the pieces by all impulses, and the reactions of the joints.
    void finish(const LaneArrays& all);

    DirectArrays arrays() {
        return {frame_.data(), piece_of_body_.data(), spring_.data(), joined_.data(), start_.data(), impulse_.data()};
    }

    /// Of each body, and of the spare slot after all groups of them; valid from touch() on.
    const ComplianceColumn* columns() const { return columns_.data(); }
    std::uint32_t spare() const { return static_cast<std::uint32_t>(columns_.size() - 1); }

    /// Bodies in contacts, rising, whose velocities impulses change; valid from touch() on.
    std::span<const std::uint32_t> touched_bodies() const { return touched_bodies_; }

    /// The piece of a body: two of one piece move together.
    std::uint32_t piece(std::size_t body) const { return piece_of_body_[body]; }

    bool moves(std::size_t body) const { return bodies_[body].inverse_mass > 0; }

    /// Everything that its next steps depend on, saved or set (core/state_archive.hpp), of the same bodies and joints.
    void archive(StateArchive& state);

  private:
    struct Piece {
        std::vector<std::uint32_t> bodies;  ///< rising
        std::vector<std::uint32_t> within;  ///< 0, 1, 2, …
        std::vector<std::uint32_t> joints;  ///< alive, rising
        std::vector<Mat3> at_rest;          ///< body -> piece, unstrained
        std::shared_ptr<PieceCompliance> compliance;
        std::shared_ptr<PieceCompliance> before;             ///< while it is to be made anew with other joints or water
        std::vector<std::uint32_t> touched, touched_within;  ///< numbers in the piece, from touch() on in columns
        bool broken = false;                                 ///< joints were removed since it was found
    };

    void archive_pieces(StateArchive& state);
    void forget_compliance(Piece& piece);
    void store_water(std::size_t body);
    void store_all_water();
    void split(std::size_t piece);
    void make_compliance(Piece& piece);
    void turn_at_rest(Piece& piece) const;
    void find_compliance(Piece& piece, std::vector<PieceBody> bodies, std::vector<PieceJoint> joints);
    PieceJoint at_rest(const Piece& piece, const SolverJoint& joint, const std::vector<PieceBody>& bodies,
                       std::array<double, 6>& stiffness) const;
    void store_spring(std::size_t joint, const PieceJoint& at_rest, const std::array<double, 6>& stiffness);
    void turn_frames(const LaneArrays& all);
    void apply_compliance(Piece& piece, const std::vector<std::uint32_t>& bodies,
                          const std::vector<std::uint32_t>& within, double* delta);
    void apply_whole_compliance(Piece& piece, const std::vector<std::uint32_t>& within, double* delta);

    const LaneKernels* kernels_;
    std::size_t body_groups_, joint_groups_;
    std::vector<SolverBody> bodies_;
    std::vector<SolverJoint> joints_;
    std::vector<Piece> pieces_;
    std::vector<std::uint32_t> piece_of_body_, within_piece_;
    std::vector<std::shared_ptr<PieceCompliance>> compliances_;  ///< shared by the pieces of one form
    bool stale_ = true;
    double time_step_ = 0;
    AlignedArray<double> frame_, spring_, start_, impulse_;
    std::vector<std::uint32_t> joined_;
    AlignedArray<double> carried_;  ///< empty as long as no body carries water
    std::vector<ComplianceColumn> columns_;
    std::vector<std::uint32_t> touched_pieces_, touched_bodies_;
    std::vector<std::uint8_t> is_touched_;  ///< by body
    std::vector<double> piece_impulse_, piece_change_;
};

}  // namespace floes
