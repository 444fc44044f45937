#include "picture/film.hpp"

#include "picture/encoder.hpp"

namespace floes {

void write_film(const std::filesystem::path& path, const Recording& recording, const PictureStyle& style, int rate,
                const std::function<void(double)>& progress) {
    const Stage stage(recording.subject(), recording.outcome());
    const int height = picture_height(style, recording.subject());
    const std::unique_ptr<Encoder> film = make_encoder(path, {style.width, height, recording.frames(), rate});
    Canvas picture(style.width, height);
    Frame frame;
    for (int k = 0; k < recording.frames(); ++k) {
        recording.read(k, frame);
        draw_picture(picture, stage, frame, style);
        film->add(picture);
        progress(static_cast<double>(k + 1) / recording.frames());
    }
    film->finish();
}

}  // namespace floes
