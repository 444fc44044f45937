#pragma once
// Pictures one after another into a film file. For this room only.

#include <filesystem>
#include <memory>

#include "picture/canvas.hpp"

namespace floes {

inline constexpr int film_rate = 25;  ///< frames a second

class Encoder {
  public:
    virtual ~Encoder() = default;
    /// All pictures have the same size.
    virtual void add(const Canvas& picture) = 0;
    /// Completes the file. Throws RunError when that fails.
    virtual void finish() = 0;
};

/// By the ending of `path`; see film.hpp. `pictures`: how many will come.
std::unique_ptr<Encoder> make_encoder(const std::filesystem::path& path, int width, int height, int pictures);

}  // namespace floes
