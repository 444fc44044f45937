// floes --version: what this program is, and what it was built with.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.hpp"
#include "records/build_info.hpp"
#include "solver/lane_width.hpp"
#include "wire/mpi_link.hpp"

namespace floes {

std::string version_text() {
    std::string text = fmt::format("floes {}\n", floes_version());
    std::vector<Software> parts = built_with();
    parts.push_back({"mpi", library_version()});
    for (const Software& part : parts) {
        if (part.name != "floes") text += fmt::format("{}: {}\n", part.name, part.version);
    }
    return text + fmt::format("lane_widths: {}", fmt::join(lane_widths(), ", "));  // whoever prints it ends the line
}

}  // namespace floes
