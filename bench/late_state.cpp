// Makes bench/late_state.csv and bench/late_state_steep.csv: tows the structure through arrangement 0 of seed 1 with
// the lanes solver.
//
//   floes_late_state straight|steep SECONDS FILE

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

#include "scene.hpp"
#include "simulation/simulation.hpp"

int main(int count, char** arguments) {
    using namespace floes;
    if (count != 4) {
        fmt::print(stderr, "Usage: floes_late_state straight|steep SECONDS FILE\n");
        return 2;
    }
    const bench::Wall wall = bench::wall_named(arguments[1]);
    const double end = std::atof(arguments[2]);
    const Scenario scenario = bench::tow_scenario(SolverKind::lanes, wall);
    const Arrangement floes = make_arrangement(scenario, 1, 0);
    bench::Scene scene{wall, floes.poses(), {}};
    Simulation tow(scenario, floes);
    while (tow.time() < end) {
        tow.step();
        if (tow.steps() % 500 == 0) {
            fmt::print(stderr, "t = {:.0f} s, {} broken floes, surge load {:.1f} N\n", tow.time(),
                       tow.ice().broken_floes(), tow.loads().surge.back());
        }
    }
    scene.state = tow.state();
    std::ofstream(arguments[3]) << bench::write_scene(scene);
}
