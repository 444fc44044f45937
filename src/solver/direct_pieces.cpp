// The connected pieces of floes that are solved exactly: how they are split, and their compliance.

#include <algorithm>
#include <cmath>

#include "core/vector.hpp"
#include "solver/direct_floes.hpp"
#include "solver/lane_slot.hpp"

namespace floes {
namespace {

using Rows3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Mat3 matrix_of(const SolverFrame& frame) {
    return Eigen::Map<const Rows3>(frame.rotation.data());
}

Vec3 origin_of(const SolverFrame& frame) {
    return Vec3(frame.origin[0], frame.origin[1], frame.origin[2]);
}

/// Whether a crack opens this part of a joint's six: torsion and bending. What is left of the section still holds
/// shear.
bool opens(std::size_t part) {
    return part == 3 || part == 5;
}

}  // namespace

void DirectFloes::split(std::size_t piece) {
    const Piece whole = std::move(pieces_[piece]);
    Components parts(whole.bodies.size());  // of bodies by their numbers in the whole
    for (const std::uint32_t joint : whole.joints) {
        parts.connect(within_piece_[joints_[joint].a], within_piece_[joints_[joint].b]);
    }
    pieces_[piece] = Piece{};
    for (std::uint32_t i = 0; i < whole.bodies.size(); ++i) {
        const std::uint32_t body = whole.bodies[i];
        if (i > 0 && parts.first(i) == i) {
            piece_of_body_[body] = static_cast<std::uint32_t>(pieces_.size());
            pieces_.emplace_back();
        }
        piece_of_body_[body] = piece_of_body_[whole.bodies[parts.first(i)]];
        Piece& part = pieces_[piece_of_body_[body]];
        within_piece_[body] = static_cast<std::uint32_t>(part.bodies.size());
        part.within.push_back(within_piece_[body]);
        part.bodies.push_back(body);
        part.slots.push_back(slots_.body[body]);
    }
    for (const std::uint32_t joint : whole.joints) {
        pieces_[piece_of_body_[joints_[joint].a]].joints.push_back(joint);
    }
}

void DirectFloes::store_spring(std::size_t joint, const PieceJoint& at_rest, const std::array<double, 6>& stiffness) {
    const auto put = [&](int field, double value) {
        spring_[place(slots_.joint[joint], spring_field::count, field, kernels_->width)] = value;
    };
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) put(spring_field::axes + 3 * i + k, at_rest.axes(i, k));
        put(spring_field::lever_a + i, at_rest.lever_a[i]);
        put(spring_field::lever_b + i, at_rest.lever_b[i]);
    }
    for (std::size_t i = 0; i < 6; ++i) {
        put(spring_field::stiffness + static_cast<int>(i), stiffness[i] * time_step_);
        put(spring_field::hold + static_cast<int>(i), at_rest.hold[i]);
    }
}

PieceJoint DirectFloes::at_rest(const Piece& piece, const SolverJoint& joint, const std::vector<PieceBody>& bodies,
                                std::array<double, 6>& stiffness) const {
    PieceJoint found;
    found.a = static_cast<int>(within_piece_[joint.a]);
    found.b = static_cast<int>(within_piece_[joint.b]);
    const Mat3& turn_a = piece.at_rest[within_piece_[joint.a]];
    const Mat3& turn_b = piece.at_rest[within_piece_[joint.b]];
    found.axes = turn_a * matrix_of(joint.in_a);
    found.lever_a = turn_a * origin_of(joint.in_a);
    found.lever_b = turn_b * origin_of(joint.in_b);
    const std::array<double, 6> inverse_mass =
        inverse_effective_mass(bodies[within_piece_[joint.a]], bodies[within_piece_[joint.b]], found);
    const double step = time_step_;
    for (std::size_t i = 0; i < 6; ++i) {
        double damping = 0;
        if (joint.spring) {
            stiffness[i] = i < 3 ? joint.spring->force[i] : joint.spring->moment[i - 3];
            damping = 2 * joint.spring->damping_ratio * std::sqrt(stiffness[i] / inverse_mass[i]);
        } else {  // docs/fracture.md: K = Γ / (Δt² Σ A), D = (1 - Γ) / (Δt Σ A)
            const double per_step = 1 / (step * joint.cfm * inverse_mass[i]);
            stiffness[i] = joint.erp * per_step / step;
            damping = (1 - joint.erp) * per_step;
        }
        if (joint.sound < 1 && opens(i)) {
            damping *= std::sqrt(joint.sound);
            stiffness[i] *= joint.sound;
        }
        found.hold[i] = step * damping + step * step * stiffness[i];
    }
    return found;
}

void DirectFloes::make_compliance(Piece& piece) {
    // In the unstrained piece the joints give each body's rotation relative to the first.
    piece.at_rest.assign(piece.bodies.size(), Mat3::Identity());
    std::vector<bool> known(piece.bodies.size(), false);
    known[0] = true;
    for (bool more = true; more;) {
        more = false;
        for (const std::uint32_t number : piece.joints) {
            const SolverJoint& joint = joints_[number];
            const std::uint32_t a = within_piece_[joint.a];
            const std::uint32_t b = within_piece_[joint.b];
            if (known[a] == known[b]) continue;
            const Mat3 in_a = piece.at_rest[a] * matrix_of(joint.in_a);
            const Mat3 in_b = piece.at_rest[b] * matrix_of(joint.in_b);
            if (known[a])
                piece.at_rest[b] = in_a * matrix_of(joint.in_b).transpose();
            else
                piece.at_rest[a] = in_b * matrix_of(joint.in_a).transpose();
            known[a] = known[b] = more = true;
        }
    }
    std::vector<PieceBody> bodies;
    for (std::size_t i = 0; i < piece.bodies.size(); ++i)
        bodies.push_back(body_of(bodies_[piece.bodies[i]], piece.at_rest[i]));
    std::vector<PieceJoint> joints;
    for (const std::uint32_t joint : piece.joints) {
        std::array<double, 6> stiffness{};
        joints.push_back(at_rest(piece, joints_[joint], bodies, stiffness));
        store_spring(joint, joints.back(), stiffness);
    }
    find_compliance(piece, std::move(bodies), std::move(joints));
    piece.touched_slots.reserve(piece.bodies.size());  // so that steps need not
    piece.touched_within.reserve(piece.bodies.size());
}

void DirectFloes::find_compliance(Piece& piece, std::vector<PieceBody> bodies, std::vector<PieceJoint> joints) {
    const auto cracks = [&](std::uint32_t joint) { return joints_[joint].sound < 1; };
    if (std::ranges::any_of(piece.joints, cracks)) {  // no other piece is like it
        piece.compliance = std::make_shared<PieceCompliance>(std::move(bodies), std::move(joints));
        return;
    }
    const auto found =
        std::ranges::find_if(compliances_, [&](const auto& compliance) { return compliance->is_of(bodies, joints); });
    if (found != compliances_.end()) {
        piece.compliance = *found;
        return;
    }
    piece.compliance = std::make_shared<PieceCompliance>(std::move(bodies), std::move(joints));
    compliances_.push_back(piece.compliance);
}

}  // namespace floes
