#include "solver/direct_floes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/state_archive.hpp"
#include "core/vector.hpp"

namespace floes {

namespace {

using Rows3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// The rotation nearest to a mean of rotations (Higham 1986, Newton's iteration for the polar factor). Three steps are
/// exact where rotations differ by a tenth.
Mat3 nearest_rotation(Mat3 mean) {
    for (int i = 0; i < 3; ++i) mean = 0.5 * (mean + Mat3(mean.inverse().transpose()));
    return mean;
}

}  // namespace

DirectFloes::DirectFloes(std::span<const SolverBody> bodies, std::span<const SolverJoint> joints,
                         const LaneKernels& kernels)
    : kernels_(&kernels),
      body_groups_(groups_of(bodies.size(), kernels.width)),
      joint_groups_(groups_of(joints.size(), kernels.width)),
      bodies_(bodies.begin(), bodies.end()),
      joints_(joints.begin(), joints.end()),
      within_piece_(bodies.size()),
      is_touched_(bodies.size()) {
    const auto lanes = static_cast<std::size_t>(kernels.width);
    piece_of_body_.resize(bodies.size() + 1);                     // with the spare body of empty lanes
    frame_ = AlignedArray<double>(bodies.size() * frame_stride);  // there are no more pieces than bodies
    spring_ = AlignedArray<double>(joint_groups_ * lanes * spring_field::count);
    start_ = AlignedArray<double>(body_groups_ * lanes * 8);
    impulse_ = AlignedArray<double>(body_groups_ * lanes * 8);
    columns_.resize(body_groups_ * lanes + 1);
    joined_.resize(2 * joint_groups_ * lanes);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        std::uint32_t* const pair = &joined_[i / lanes * 2 * lanes + i % lanes];
        pair[0] = joints[i].a;
        pair[lanes] = joints[i].b;
    }
    touched_bodies_.reserve(bodies_.size());
    touched_pieces_.reserve(bodies_.size());
    // One piece of all bodies, which is then split by its joints.
    Piece all;
    all.bodies.resize(bodies_.size());
    std::iota(all.bodies.begin(), all.bodies.end(), 0U);
    all.joints.resize(joints_.size());
    std::iota(all.joints.begin(), all.joints.end(), 0U);
    within_piece_ = all.bodies;
    pieces_.push_back(std::move(all));
    split(0);
}

void DirectFloes::remove_joint(std::size_t joint) {
    Piece& piece = pieces_[piece_of_body_[joints_[joint].a]];
    std::erase(piece.joints, static_cast<std::uint32_t>(joint));
    piece.broken = true;
    stale_ = true;
    store_spring(joint, {}, {});
}

void DirectFloes::soften_joint(std::size_t joint, double sound) {
    if (joints_[joint].sound == sound) return;
    joints_[joint].sound = sound;
    forget_compliance(pieces_[piece_of_body_[joints_[joint].a]]);
}

void DirectFloes::forget_compliance(Piece& piece) {
    if (piece.compliance != nullptr) piece.before = std::move(piece.compliance);
    piece.compliance = nullptr;
    stale_ = true;
}

void DirectFloes::set_water(std::size_t body, const CarriedWater& water) {
    if (bodies_[body].water == water) return;
    bodies_[body].water = water;
    forget_compliance(pieces_[piece_of_body_[body]]);
    if (carried_.size() > 0)
        store_water(body);
    else
        store_all_water();
}

void DirectFloes::store_all_water() {
    carried_ = AlignedArray<double>(body_groups_ * static_cast<std::size_t>(kernels_->width) *
                                    static_cast<std::size_t>(carried_field::count));
    for (std::size_t i = 0; i < bodies_.size(); ++i) store_water(i);
}

void DirectFloes::store_water(std::size_t body) {
    const SolverBody& of = bodies_[body];
    if (!(of.inverse_mass > 0)) return;
    const auto put = [&](int field, double value) {
        carried_[place(static_cast<std::uint32_t>(body), carried_field::count, field, kernels_->width)] = value;
    };
    PieceBody free = body_of(of, Mat3::Identity());
    free.rail = -1;  // what acts on a body on a rail from outside is along it
    const Eigen::Matrix<double, 6, 6> inertia = inertia_of(free);
    const CarriedWater& water = of.water;
    const double moments[] = {water.in_plane, water.yaw, water.normal, water.x, water.z, water.xx, water.xz, water.zz};
    for (int i = 0; i < 8; ++i) put(i, moments[i]);
    put(carried_field::inverse_in_plane, 1 / inertia(0, 0));
    put(carried_field::inverse_yaw, 1 / inertia(4, 4));
    constexpr std::array<int, 3> out{1, 3, 5};
    Mat3 out_of_plane;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k)
            out_of_plane(i, k) = inertia(out[static_cast<std::size_t>(i)], out[static_cast<std::size_t>(k)]);
    }
    const Mat3 inverse = out_of_plane.inverse();
    int field = carried_field::inverse_out;
    for (int i = 0; i < 3; ++i) {
        for (int k = i; k < 3; ++k) put(field++, inverse(i, k));
    }
    for (std::size_t i = 0; i < 3; ++i) put(carried_field::ice + static_cast<int>(i), 1 / of.inverse_inertia[i]);
}

void DirectFloes::turn_frames(const LaneArrays& all) {
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
        const Piece& piece = pieces_[k];
        Mat3 sum = Mat3::Zero();
        for (std::size_t i = 0; i < piece.bodies.size(); ++i) {
            const Mat3 turn = Eigen::Map<const Rows3>(all.motion[piece.bodies[i]].rotation);
            sum += turn * piece.at_rest[i].transpose();
        }
        Eigen::Map<Rows3> frame(&frame_[k * frame_stride]);
        frame = piece.bodies.size() == 1 ? sum : nearest_rotation(sum / static_cast<double>(piece.bodies.size()));
    }
}

void DirectFloes::prepare(const LaneArrays& all, double time_step) {
    if (stale_ || time_step != time_step_) {
        const bool all_anew = time_step != time_step_;
        time_step_ = time_step;
        if (all_anew) compliances_.clear();
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (pieces_[i].broken) split(i);
        }
        for (Piece& piece : pieces_) {
            if (all_anew || piece.compliance == nullptr) make_compliance(piece);
        }
        std::erase_if(compliances_, [](const auto& compliance) { return compliance.use_count() == 1; });
        stale_ = false;
    }
    if (carried_.size() > 0) kernels_->direct.carry_water(all, carried_.data(), body_groups_, time_step);
    turn_frames(all);
    kernels_->direct.begin(all, arrays(), body_groups_);
    kernels_->direct.press(all, arrays(), joint_groups_, time_step);
}

void DirectFloes::apply_whole_compliance(Piece& piece, const std::vector<std::uint32_t>& within, double* delta) {
    piece_impulse_.resize(8 * piece.bodies.size());
    piece_change_.resize(8 * piece.bodies.size());
    for (std::size_t i = 0; i < piece.bodies.size(); ++i) {
        std::copy_n(impulse_.data() + 8 * static_cast<std::size_t>(piece.bodies[i]), 8, &piece_impulse_[8 * i]);
    }
    piece.compliance->velocity_changes(piece_impulse_.data(), within, piece_change_.data());
    for (const std::size_t i : within)
        std::copy_n(&piece_change_[8 * i], 8, delta + 8 * static_cast<std::size_t>(piece.bodies[i]));
}

void DirectFloes::apply_compliance(Piece& piece, const std::vector<std::uint32_t>& bodies,
                                   const std::vector<std::uint32_t>& within, double* delta) {
    if (!piece.compliance->is_small()) {
        apply_whole_compliance(piece, within, delta);
        return;
    }
    piece.compliance->make_columns(piece.within);
    for (const std::uint32_t body : bodies) std::fill_n(delta + 8 * static_cast<std::size_t>(body), 8, 0.0);
    for (std::size_t i = 0; i < piece.bodies.size(); ++i) {
        const ComplianceColumn column{piece.compliance->column(i), nullptr, bodies.data(), within.data(),
                                      bodies.size()};
        kernels_->direct.add_velocity_changes(delta, column,
                                              impulse_.data() + 8 * static_cast<std::size_t>(piece.bodies[i]));
    }
}

void DirectFloes::touch(const LaneArrays& all, std::span<const SolverContact> contacts) {
    for (const std::uint32_t body : touched_bodies_) {
        is_touched_[body] = 0;
        columns_[body] = {};
    }
    touched_bodies_.clear();
    for (const SolverContact& contact : contacts) {
        for (const std::uint32_t body : {contact.a, contact.b}) {
            if (is_touched_[body] != 0 || !moves(body)) continue;
            is_touched_[body] = 1;
            touched_bodies_.push_back(body);
        }
    }
    std::ranges::sort(touched_bodies_);
    for (const std::uint32_t piece : touched_pieces_) {
        pieces_[piece].touched.clear();
        pieces_[piece].touched_within.clear();
    }
    touched_pieces_.clear();
    for (const std::uint32_t body : touched_bodies_) {
        Piece& piece = pieces_[piece_of_body_[body]];
        if (piece.touched.empty()) touched_pieces_.push_back(piece_of_body_[body]);
        piece.touched.push_back(body);
        piece.touched_within.push_back(within_piece_[body]);
    }
    for (const std::uint32_t i : touched_pieces_) pieces_[i].compliance->make_columns(pieces_[i].touched_within);
    for (const std::uint32_t i : touched_pieces_) {
        Piece& piece = pieces_[i];
        apply_compliance(piece, piece.touched, piece.touched_within, all.delta);
        for (std::size_t k = 0; k < piece.touched.size(); ++k) {
            std::uint32_t& within = piece.touched_within[k];
            const double* blocks = piece.compliance->column(within);
            within = piece.compliance->number(within);
            columns_[piece.touched[k]] = {blocks, blocks + within * compliance_block, piece.touched.data(),
                                          piece.touched_within.data(), piece.touched.size()};
        }
    }
}

void DirectFloes::finish(const LaneArrays& all) {
    for (Piece& piece : pieces_) apply_compliance(piece, piece.bodies, piece.within, all.delta);
    kernels_->direct.from_pieces(all, arrays(), body_groups_);
    kernels_->direct.reactions(all, arrays(), joint_groups_, time_step_);
}

// The connected pieces of floes that are solved exactly: how they are split, and their compliance.

namespace {

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
    }
    for (const std::uint32_t joint : whole.joints) pieces_[piece_of_body_[joints_[joint].a]].joints.push_back(joint);
}

void DirectFloes::store_spring(std::size_t joint, const PieceJoint& at_rest, const std::array<double, 6>& stiffness) {
    const auto put = [&](int field, double value) {
        spring_[place(static_cast<std::uint32_t>(joint), spring_field::count, field, kernels_->width)] = value;
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
    if (piece.at_rest.empty()) turn_at_rest(piece);
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
    piece.before = nullptr;
    piece.touched.reserve(piece.bodies.size());  // so that steps need not
    piece.touched_within.reserve(piece.bodies.size());
}

/// In the unstrained piece the joints give each body's rotation relative to the first.
void DirectFloes::turn_at_rest(Piece& piece) const {
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
}

void DirectFloes::find_compliance(Piece& piece, std::vector<PieceBody> bodies, std::vector<PieceJoint> joints) {
    const auto cracks = [&](std::uint32_t joint) { return joints_[joint].sound < 1; };
    if (std::ranges::any_of(piece.joints, cracks)) {  // no other piece is like it
        piece.compliance = std::make_shared<PieceCompliance>(std::move(bodies), std::move(joints), piece.before.get());
        return;
    }
    const auto found =
        std::ranges::find_if(compliances_, [&](const auto& compliance) { return compliance->is_of(bodies, joints); });
    if (found != compliances_.end()) {
        piece.compliance = *found;
        return;
    }
    piece.compliance = std::make_shared<PieceCompliance>(std::move(bodies), std::move(joints), piece.before.get());
    compliances_.push_back(piece.compliance);
}

// A piece keeps the compliance that was made for another of its form, and so the last bits of that one.

void DirectFloes::archive(StateArchive& state) {
    auto& [kernels, body_groups, joint_groups, bodies, joints, pieces, piece_of_body, within_piece, compliances, stale,
           time_step, frame, spring, start, impulse, joined, carried, columns, touched_pieces, touched_bodies,
           is_touched, piece_impulse, piece_change] = *this;  // from `frame` on, of each step but for the springs
    state(bodies, joints, piece_of_body, within_piece, stale, time_step);
    std::vector<std::uint32_t> slots(joints.size());
    std::iota(slots.begin(), slots.end(), 0U);
    archive_slots(state, spring, slots, spring_field::count, kernels->width);
    archive_pieces(state);
    bool carries = carried.size() > 0;
    state(carries);
    if (state.sets() && carries) store_all_water();
}

void DirectFloes::archive_pieces(StateArchive& state) {
    std::vector<std::shared_ptr<PieceCompliance>> all = compliances_;  // then those of pieces that crack
    const auto number_of = [&](const std::shared_ptr<PieceCompliance>& one) {
        if (one == nullptr) return std::int64_t{-1};
        const auto known = std::ranges::find(all, one);
        const auto number = known - all.begin();
        if (known == all.end()) all.push_back(one);
        return static_cast<std::int64_t>(number);
    };
    std::vector<std::int64_t> of_piece;
    for (const Piece& piece : pieces_) of_piece.push_back(number_of(piece.compliance));
    std::uint64_t shared = compliances_.size();
    std::uint64_t count = all.size();
    state(of_piece, shared, count);
    all.resize(count);
    for (std::shared_ptr<PieceCompliance>& one : all) PieceCompliance::archive(state, one);
    pieces_.resize(of_piece.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        auto& [bodies, within, joints, at_rest, compliance, before, touched, touched_within, broken] = pieces_[i];
        state(bodies, within, joints, at_rest, broken);
        if (!state.sets()) continue;
        compliance = of_piece[i] < 0 ? nullptr : all.at(static_cast<std::size_t>(of_piece[i]));
        before = nullptr;  // it would make nothing else
        for (std::vector<std::uint32_t>* of_step : {&touched, &touched_within}) {
            of_step->clear();
            of_step->reserve(bodies.size());
        }
    }
    if (!state.sets()) return;
    all.resize(shared);
    compliances_ = std::move(all);
}

}  // namespace floes
