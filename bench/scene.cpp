#include "scene.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "core/error.hpp"
#include "simulation/simulation.hpp"

namespace floes::bench {

namespace {

Vec3 read_vector(std::istream& in) {
    Vec3 v;
    in >> v.x() >> v.y() >> v.z();
    return v;
}

BodyState read_element(std::istream& in) {
    BodyState state;
    state.position = read_vector(in);
    Quat turn;
    in >> turn.w() >> turn.x() >> turn.y() >> turn.z();
    state.rotation = turn.normalized().toRotationMatrix();
    state.velocity = read_vector(in);
    state.angular_velocity = read_vector(in);
    return state;
}

BreakEvent read_break(std::istream& in) {
    BreakEvent event;
    int mode = 0;
    in >> event.time >> event.floe >> event.joint >> mode;
    event.mode = static_cast<FailureMode>(mode);
    return event;
}

PlanarPose read_floe(std::istream& in) {
    PlanarPose pose;
    in >> pose.x >> pose.z >> pose.yaw;
    return pose;
}

}  // namespace

Scenario tow_scenario(SolverKind solver) {
    Scenario scenario = paper_scenario();
    scenario.general.solver = solver;
    scenario.contact = {};
    if (solver == SolverKind::direct) {
        scenario.general.iterations = General{}.iterations;
        scenario.general.tolerance = General{}.tolerance;
        scenario.joint = {};
        scenario.contact = with_preset({}, ContactPreset::physical);
    }
    scenario.arrangement.method = ArrangementMethod::monte_carlo;
    scenario.structure.shape = Shape({{-0.443, 0.171}, {0.122, 0.736}});
    scenario.structure.start = scenario.field.begin - scenario.structure.shape.waterline_radius() - 0.2;
    return scenario;
}

std::string write_scene(const Scene& scene) {
    std::string text = "# A packed scene: ./late_state.cpp says how it came about. Lengths m, times s.\n";
    text +=
        "# floe,x,z,yaw at t = 0 | element,position,rotation w x y z,velocity,angular_velocity | "
        "break,time,floe,joint,mode\n";
    text += fmt::format("steps,{}\n", scene.state.steps);
    for (const PlanarPose& pose : scene.poses) {
        text += fmt::format("floe,{:.9f},{:.9f},{:.9f}\n", pose.x, pose.z, pose.yaw);
    }
    for (const BodyState& state : scene.state.elements) {
        const Quat turn(state.rotation);
        const Vec3& p = state.position;
        const Vec3& v = state.velocity;
        const Vec3& s = state.angular_velocity;
        text += fmt::format("element,{:.9f},{:.9f},{:.9f},{:.10f},{:.10f},{:.10f},{:.10f},", p.x(), p.y(), p.z(),
                            turn.w(), turn.x(), turn.y(), turn.z());
        text += fmt::format("{:.7g},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g}\n", v.x(), v.y(), v.z(), s.x(), s.y(), s.z());
    }
    for (const BreakEvent& event : scene.state.breaks) {
        text +=
            fmt::format("break,{:.2f},{},{},{}\n", event.time, event.floe, event.joint, static_cast<int>(event.mode));
    }
    return text;
}

Scene read_scene(const std::string& text) {
    Scene scene;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('#')) continue;
        for (char& c : line) {
            if (c == ',') c = ' ';
        }
        std::istringstream in(line);
        std::string kind;
        in >> kind;
        if (kind == "steps") in >> scene.state.steps;
        if (kind == "floe") scene.poses.push_back(read_floe(in));
        if (kind == "element") scene.state.elements.push_back(read_element(in));
        if (kind == "break") scene.state.breaks.push_back(read_break(in));
        if (in.fail()) throw InputError(fmt::format("The stored scene has a line that cannot be read: {}.", line));
    }
    return scene;
}

Scene late_scene() {
    const std::string path = FLOES_BENCH_DIR "/late_state.csv";
    std::ifstream file(path);
    if (!file) throw InputError(fmt::format("There is no stored scene at {}; make it with floes_late_state.", path));
    return read_scene({std::istreambuf_iterator<char>(file), {}});
}

Scene early_scene() {
    Scene scene = late_scene();
    const Scenario scenario = tow_scenario(SolverKind::lanes);
    scene.state = Simulation(scenario, floes_at(scenario, scene.poses)).state();
    return scene;
}

}  // namespace floes::bench
