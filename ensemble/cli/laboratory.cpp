// floes laboratory: the numerical ice tested by itself, without a tow.

#include "cli/commands.hpp"

namespace floes {

void add_laboratory(CommandLine& line) {
    Verb verb = line.verb("laboratory", "Test the numerical ice by itself: its elastic modulus, its strength");
    add_plate(verb);
    add_cantilever(verb);
    verb.footer(
        "Both tests take the ice of a configuration's first case, or the paper's.\n\n"
        "  floes laboratory plate --modulus-MPa 60     the Σ with which a sheet shows 60 MPa\n"
        "  floes laboratory cantilever                 the strength of a beam\n"
        "  floes laboratory plate --help               options of a test");
    line.moved("calibrate", "laboratory plate");
    line.moved("cantilever", "laboratory cantilever");
}

}  // namespace floes
