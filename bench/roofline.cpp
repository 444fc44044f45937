// floes_roofline: what this core could do, and what the sweeps of the late scene do of it. Prints CSV lines:
//
//   ceiling,WHAT,VALUE                                     GB/s read, by size of what is read; Gflop/s
//   sweep,SOLVER,SCENE,µs,joints,contacts,bytes,flops,GB/s of one sweep, and of a plain read of as much
//
// A sweep's time is the difference between steps of many sweeps and steps of few, so that nothing else of a step is in
// it. Bytes and operations are those of the kernels' fields and formulas, each once a sweep.

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "scenario/scenario.hpp"
#include "scene.hpp"
#include "simulation/simulation.hpp"
#include "solver/lane_layout.hpp"

namespace floes::bench {
namespace {

double now() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

using Vector [[gnu::vector_size(64)]] = double;  // as wide as any register; two or four narrower ones elsewhere
constexpr std::size_t at_once = 8;               // side by side, so that none waits for the one before

/// Reads all of it once; `count` vectors.
[[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default"), gnu::noinline]] double read_all(
    const Vector* data, std::size_t count) {
    Vector sum[at_once]{};
    for (std::size_t i = 0; i < count; i += at_once) {
#pragma GCC unroll 8
        for (std::size_t k = 0; k < at_once; ++k) sum[k] += data[i + k];
    }
    for (std::size_t k = 1; k < at_once; ++k) sum[0] += sum[k];
    return sum[0][0];
}

/// `rounds` multiplications and additions of each of the vectors.
[[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default"), gnu::optimize("fp-contract=fast"),
  gnu::noinline]] double
compute(int rounds, double factor) {
    Vector sum[at_once]{};
    for (int i = 0; i < rounds; ++i) {
#pragma GCC unroll 8
        for (std::size_t k = 0; k < at_once; ++k) sum[k] = sum[k] * factor + factor;
    }
    for (std::size_t k = 1; k < at_once; ++k) sum[0] += sum[k];
    return sum[0][0];
}

/// Best of some tries of at least 20 ms, as work a second.
template <class Work>
double best_rate(double work, const Work& run) {
    double best = 0;
    for (int tries = 0; tries < 15; ++tries) {
        int runs = 0;
        const double start = now();
        do {
            run();
            ++runs;
        } while (now() - start < 0.02);
        best = std::max(best, work * runs / (now() - start));
    }
    return best;
}

double needed = 0;  // so that the sums are

/// Bytes a second, of reading so many again and again.
double read_rate(double bytes) {
    const std::vector<Vector> data(at_once * static_cast<std::size_t>(bytes / (at_once * sizeof(Vector))), Vector{1});
    const int times = std::max(1, static_cast<int>(4e6 / bytes));
    return best_rate(times * bytes, [&] {
        for (int i = 0; i < times; ++i) needed += read_all(data.data(), data.size());
    });
}

void print_ceilings() {
    for (const int kib : {24, 512, 4096, 256 * 1024})
        fmt::print("ceiling,read {} KiB,{:.4g}\n", kib, 1e-9 * read_rate(1024.0 * kib));
    constexpr int rounds = 20000;
    const double flops = 2.0 * at_once * sizeof(Vector) / sizeof(double) * rounds;
    const double rate = best_rate(flops, [&] { needed += compute(rounds, 0.5); });
    fmt::print("ceiling,multiply and add,{:.4g}\n", 1e-9 * rate);
}

/// What one joint or contact costs a sweep.
struct Row {
    int doubles_read, doubles_written, flops;
};

/// joint_kernels.inl: 3 for the relative rotation, twice 33 for three rows and 15 for what they exert, 36 to turn both
/// bodies, 27 for the pivots, 12 to push and 54 to twist.
constexpr Row lane_joint{row_field::count, 6, 228};
/// contact_kernels.inl, one direction of friction: a normal and a friction row of 27 to look and 26 to push each.
constexpr Row lane_contact{2 * (contact_field::count + 2), 2, 110};
/// direct_contacts.inl and contact_impulses.inl: three rows of 23 to look and 48 to push, and 17 for the cone. Fields
/// beyond the coupling are read once a step.
constexpr Row direct_contact{direct_field::friction_coefficient + 1 + 2 + 6 + 2, 3, 230};

struct Tow {
    const char* solver;
    Simulation simulation;
    int sweeps;
};

Tow tow(SolverKind solver, int sweeps) {
    const Scene scene = late_scene();
    Scenario scenario = tow_scenario(solver);
    scenario.general.iterations = sweeps;
    scenario.general.tolerance = 0;
    Tow made{solver == SolverKind::direct ? "direct" : "lanes",
             Simulation(scenario, floes_at(scenario, scene.poses), scene.state), sweeps};
    for (int i = 0; i < 5; ++i) made.simulation.step();
    return made;
}

void print_sweep(SolverKind solver, int few, int many) {
    Tow tows[] = {tow(solver, few), tow(solver, many)};
    std::vector<double> slopes;
    for (int turn = 0; turn < 40; ++turn) {
        double took[2];
        for (int k = 0; k < 2; ++k) {
            const double start = now();
            tows[k].simulation.step();
            took[k] = now() - start;
        }
        slopes.push_back((took[1] - took[0]) / (many - few));
    }
    std::ranges::nth_element(slopes, slopes.begin() + 20);
    Frame frame;
    tows[1].simulation.read_frame(frame);
    const auto contacts = static_cast<double>(frame.contacts.size());
    const double joints = solver == SolverKind::lanes ? tows[1].simulation.ice().live_joints() : 0;
    const Row& row = solver == SolverKind::lanes ? lane_contact : direct_contact;
    const double bytes = 8 * (joints * (lane_joint.doubles_read + lane_joint.doubles_written) +
                              contacts * (row.doubles_read + row.doubles_written));
    const double flops = joints * lane_joint.flops + contacts * row.flops;
    fmt::print("sweep,{},{:.4g},{},{},{:.4g},{:.4g},{:.4g}\n", tows[0].solver, 1e6 * slopes[20], joints, contacts,
               bytes, flops, 1e-9 * read_rate(bytes));
}

}  // namespace
}  // namespace floes::bench

int main() {
    using namespace floes;
    bench::print_ceilings();
    bench::print_sweep(SolverKind::lanes, 10, 50);
    bench::print_sweep(SolverKind::direct, 5, 25);
    return bench::needed == 0 ? 1 : 0;
}
