#pragma once
// Pictures one after another into a film file. For this module only.

#include <filesystem>
#include <memory>

#include "draw/canvas.hpp"

namespace floes {

class Encoder {
  public:
    virtual ~Encoder() = default;
    /// All pictures have the same size.
    virtual void add(const Canvas& picture) = 0;
    /// Completes the file. Throws RunError when that fails.
    virtual void finish() = 0;
};

/// What comes in.
struct FilmShape {
    int width = 0;     ///< pixels
    int height = 0;    ///< pixels
    int pictures = 0;  ///< how many
    int rate = 0;      ///< pictures a second
};

/// By the ending of `path`; see film.hpp.
std::unique_ptr<Encoder> make_encoder(const std::filesystem::path& path, const FilmShape& shape);

}  // namespace floes
