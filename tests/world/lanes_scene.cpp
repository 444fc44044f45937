#include "world/lanes_scene.hpp"

namespace floes::test {

namespace {

constexpr double spacing = 0.64;
const Vec3 cone_start(-1.05, 0, 0);

}  // namespace

LanesScene::LanesScene(const WorldDefinition& definition, int floes, int sides)
    : world(definition), time_step_(definition.time_step) {
    for (int i = 0; i < floes; ++i) {
        const Vec3 centre(spacing * i, 0.004 * (i % 3), 0.05 * (i % 2));
        add_floe({centre, turned(0.04 * i, Vec3::UnitY())}, i);
    }
    FixedBoxDefinition sheet;
    sheet.half_extents = Vec3(0.3, 0.1, 2);
    sheet.pose.position = Vec3(spacing * floes + 0.1, 0, 0);
    world.add_fixed_box(sheet);
    ConvexSolid solid(Frustum{-0.4, 0.2, 0.2, 0.8});
    if (sides > 0) solid = ConvexSolid(convex_hull(solid.corners(sides)));
    cone = world.add_structure(std::vector<ConvexSolid>{solid}, {cone_start});
}

void LanesScene::add_floe(const Pose& pose, int piece) {
    std::vector<BodyId> own;
    for (int i = 0; i < 9; ++i) {
        const Vec3 offset(element_side * (i % 3 - 1), 0, element_side * (i / 3 - 1));
        own.push_back(
            world.add_element(element_at(pose.position + pose.orientation * offset, pose.orientation, piece)));
    }
    const auto join = [&](std::size_t a, std::size_t b, const Quat& turn) {
        JointDefinition joint{.a = own[a], .b = own[b]};
        joint.pivot = (world.state(own[a]).position + world.state(own[b]).position) / 2;
        joint.frame = pose.orientation * turn;
        joint.cfm = 0.016;
        joints.push_back(world.add_joint(joint));
    };
    for (std::size_t i = 0; i < 9; ++i) {
        if (i % 3 < 2) join(i, i + 1, Quat::Identity());
        if (i < 6) join(i, i + 3, turned(-std::acos(-1.0) / 2, Vec3::UnitY()));
    }
    elements.insert(elements.end(), own.begin(), own.end());
}

void LanesScene::step() {
    ++steps_;
    world.move_structure({cone_start + Vec3(speed * time_step_ * steps_, 0, 0)});
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const auto k = static_cast<double>(i);
        const BodyState state = world.state(elements[i]);
        const Vec3 wave(0.2 * std::sin(k), 0.3 * std::cos(2 * k), 0.1 * std::sin(3 * k));
        const Vec3 force = wave - 2 * state.velocity - Vec3(0, 200 * state.position.y() - 9.81 * element_mass, 0);
        const Vec3 moment(0.01 * std::cos(k), 0.005 * std::sin(5 * k), 0.01 * std::sin(2 * k));
        world.apply(elements[i], {force, moment - 0.05 * state.angular_velocity});
    }
    world.step();
}

void LanesScene::break_joints(std::size_t stride) {
    for (std::size_t i = 0; i < joints.size(); i += stride) world.remove_joint(joints[i]);
}

}  // namespace floes::test
