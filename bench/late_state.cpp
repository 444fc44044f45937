// Makes bench/late_state.csv: tows the structure through arrangement 0 of seed 1 with the lanes solver.
//
//   floes_late_state SECONDS FILE

#include <fmt/format.h>

#include <fstream>

#include "scene.hpp"
#include "simulation/simulation.hpp"

int main(int count, char** arguments) {
    using namespace floes;
    if (count != 3) {
        fmt::print(stderr, "Usage: floes_late_state SECONDS FILE\n");
        return 2;
    }
    const double end = std::atof(arguments[1]);
    const Scenario scenario = bench::tow_scenario(SolverKind::lanes);
    const Arrangement floes = make_arrangement(scenario, 1, 0);
    bench::Scene scene{floes.poses(), {}};
    Simulation tow(scenario, floes);
    while (tow.time() < end) {
        tow.step();
        if (tow.steps() % 500 == 0) {
            fmt::print(stderr, "t = {:.0f} s, {} broken floes, surge load {:.1f} N\n", tow.time(),
                       tow.ice().broken_floes(), tow.loads().surge.back());
        }
    }
    scene.state = tow.state();
    std::ofstream(arguments[2]) << bench::write_scene(scene);
}
