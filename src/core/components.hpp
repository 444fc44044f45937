#pragma once
// Connected components of a graph (union-find).

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace floes {

class Components {
  public:
    /// Nodes 0 to `nodes` - 1, none connected.
    explicit Components(std::size_t nodes) : smaller_(nodes) {
        std::iota(smaller_.begin(), smaller_.end(), std::size_t{0});
    }

    void connect(std::size_t a, std::size_t b) {
        a = first(a);
        b = first(b);
        if (a > b) std::swap(a, b);
        smaller_[b] = a;
    }

    /// The smallest node that this one is connected with; itself if there is none smaller.
    std::size_t first(std::size_t node) {
        while (smaller_[node] != node) node = smaller_[node] = smaller_[smaller_[node]];  // shortens the next search
        return node;
    }

  private:
    std::vector<std::size_t> smaller_;  ///< a smaller node of the same component, or the node itself
};

}  // namespace floes
