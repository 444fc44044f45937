#include "member/result.hpp"

namespace floes {

std::vector<double> properties_of(const FloeSet& floes) {
    std::vector<double> rows;
    for (std::size_t i = 0; i < floes.size(); ++i)
        for (const FloeProperty& one : floe_properties) rows.push_back(one.of(floes.shape(i), floes.material(i)));
    return rows;
}

}  // namespace floes
