// What the step loop takes from the heap: calls of operator new of any kind, and of Bullet's allocator.

#include <LinearMath/btAlignedAllocator.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <set>
#include <tuple>
#include <utility>

#include "arrangement/arrangement.hpp"
#include "simulation/simulation.hpp"
#include "support/default_scenes.hpp"
#include "support/replaced_new.hpp"
#include "support/sweeping_scenario.hpp"

namespace {

std::atomic<long> allocations{0};         // operator new
std::atomic<long> bullet_allocations{0};  // Bullet's allocator

}  // namespace

void floes::replaced_new::taken(void*) noexcept {
    ++allocations;
}

void floes::replaced_new::leaving(void*) noexcept {}

namespace floes {
namespace {

struct Taken {
    long by_new = 0;
    long by_bullet = 0;
    friend bool operator==(const Taken&, const Taken&) = default;
};

void PrintTo(const Taken& taken, std::ostream* out) {
    *out << taken.by_new << " by operator new, " << taken.by_bullet << " by Bullet";
}

class StepLoop : public ::testing::Test {
  protected:
    StepLoop() {
        // Bullet aligns what these return, as it does with its own default.
        btAlignedAllocSetCustom(
            [](std::size_t size) {
                ++bullet_allocations;
                return std::malloc(size);
            },
            [](void* memory) { std::free(memory); });
    }
    ~StepLoop() override { btAlignedAllocSetCustom(nullptr, nullptr); }

    static Taken taken_in(Simulation& simulation, int steps) {
        const Taken before{allocations, bullet_allocations};
        for (int i = 0; i < steps; ++i) simulation.step();
        return {allocations - before.by_new, bullet_allocations - before.by_bullet};
    }
};

/// Floes in rows of four, `gap` m apart, between walls that are as far, the structure at the near edge.
struct Rows {
    Scenario scenario = sweeping_scenario();
    FloeSet arrangement;

    Rows(int rows, double gap) {
        scenario.general.solver = SolverKind::lanes;
        scenario.field.floes = 4 * rows;
        const double cell = scenario.floe.length + gap;
        scenario.field.half_width = 2 * cell + 0.5 * gap;
        scenario.field.concentration = 0.36 * 4 * rows / (2 * scenario.field.half_width * (cell * rows + gap));
        scenario.structure.shape = Shape({{-0.443, 0.171}, {0.122, 0.736}});  // nothing breaks at this wall
        scenario.structure.start = scenario.field.begin - scenario.structure.shape.waterline_radius() - 0.02;
        std::vector<PlanarPose> poses;
        for (int i = 0; i < 4 * rows; ++i)
            poses.push_back({.x = scenario.field.begin + gap + cell * (i / 4) + 0.3, .z = cell * (i % 4 - 1.5)});
        arrangement = floes_at(scenario, poses);
    }
};

TEST_F(StepLoop, TakesNothingFromTheHeapWhileTheIceIsAtRest) {
    Rows rows(5, 0.09);
    rows.scenario.structure.start -= 2;
    Simulation simulation(rows.scenario, rows.arrangement);
    taken_in(simulation, 5);
    EXPECT_EQ(taken_in(simulation, 200), Taken{});
}

// Floes that drift into each other come and go as pairs: their algorithms and manifolds come from Bullet's pools.
class Collisions : public StepLoop, public ::testing::WithParamInterface<std::pair<SolverKind, ContactPreset>> {};

TEST_P(Collisions, TakeNothingFromTheHeap) {
    Rows rows(5, 0.03);
    rows.scenario.general.solver = GetParam().first;
    rows.scenario.contact = with_preset({}, GetParam().second);
    rows.scenario.structure.start -= 2;
    SimulationState state = Simulation(rows.scenario, rows.arrangement).state();
    for (std::size_t i = 0; i < state.elements.size(); ++i) {
        const double angle = 2.4 * static_cast<double>(i / 9);
        state.elements[i].velocity = {0.2 * std::cos(angle), 0, 0.2 * std::sin(angle)};
    }
    Simulation simulation(rows.scenario, rows.arrangement, state);
    taken_in(simulation, 60);
    EXPECT_EQ(taken_in(simulation, 200), Taken{});
}

INSTANTIATE_TEST_SUITE_P(StepLoop, Collisions,
                         ::testing::Values(std::pair(SolverKind::lanes, ContactPreset::paper),
                                           std::pair(SolverKind::lanes, ContactPreset::physical),
                                           std::pair(SolverKind::direct, ContactPreset::physical)));

TEST_F(StepLoop, TakesNothingForElementsThatComeNearTheStructure) {
    Rows rows(5, 0.004);
    Simulation simulation(rows.scenario, rows.arrangement);
    taken_in(simulation, 250);  // step 402 has more contacts than any before, and takes room for rows
    const Taken taken = taken_in(simulation, 150);
    EXPECT_GT(simulation.loads().surge.back(), 1) << "the ice is packed";
    EXPECT_EQ(taken, Taken{});
}

// Floes as they are by default, cut into cells, as they jam, bend and break.

class OfTheDefault : public StepLoop, public ::testing::WithParamInterface<DefaultScene> {
  protected:
    /// What changes when floes break, come, leave or wake: all that is kept by piece is laid out anew then.
    static auto happened(const Simulation& simulation) {
        int there = 0;
        for (int place = 0; place < simulation.ice().places(); ++place) there += simulation.ice().is_there(place);
        return std::tuple(simulation.ice().breaks().size(), simulation.ice().floes(), simulation.floes_resting(),
                          there);
    }
};

// What is left is taken once for each element of a piece, when it is touched first: what an impulse there does to the
// whole piece. Touches without force are not seen here, so a few of the other steps may take something, too.
TEST_P(OfTheDefault, HardlyAStepTakesAnythingUnlessFloesBreakComeOrLeave) {
    Simulation simulation = GetParam().reached();
    std::set<int> touched;  // since pieces were laid out
    Frame frame;
    int quiet = 0;
    int taking = 0;
    bool was_quiet = false;  // pieces are laid out at the beginning of the step after the one in which they broke
    for (int i = 0; i < 300; ++i) {
        const auto before = happened(simulation);
        const Taken taken = taken_in(simulation, 1);
        EXPECT_EQ(taken.by_bullet, 0) << i;
        const bool is_quiet = happened(simulation) == before;
        if (!was_quiet) touched.clear();
        const std::size_t so_far = touched.size();
        simulation.read_frame(frame);
        for (const FrameContact& contact : frame.contacts) touched.insert({contact.element, contact.other});
        if (is_quiet && was_quiet && touched.size() == so_far) {
            ++quiet;
            taking += taken != Taken{} ? 1 : 0;
        }
        was_quiet = is_quiet;
    }
    EXPECT_GT(quiet, 30);
    EXPECT_LE(taking, 0.02 * quiet);
    EXPECT_GT(simulation.loads().surge.back(), 1) << "the ice bears on the structure";
}

INSTANTIATE_TEST_SUITE_P(StepLoop, OfTheDefault, ::testing::ValuesIn(default_scenes()),
                         [](const auto& scene) { return scene.param.name; });

}  // namespace
}  // namespace floes
