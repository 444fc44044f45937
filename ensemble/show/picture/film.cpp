#include "picture/film.hpp"

#include "picture/encoder.hpp"

namespace floes {

void write_film(const std::filesystem::path& path, const Record& record, const PictureStyle& style, int rate,
                const std::function<void(double)>& progress) {
    const Stage stage(record.subject(), record.outcome(), record.floes());
    const int height = picture_height(style, record.subject());
    const std::unique_ptr<Encoder> film = make_encoder(path, {style.width, height, record.frames(), rate});
    Canvas picture(style.width, height);
    Frame frame;
    for (int k = 0; k < record.frames(); ++k) {
        record.read(k, frame);
        draw_picture(picture, stage, frame, style);
        film->add(picture);
        progress(static_cast<double>(k + 1) / record.frames());
    }
    film->finish();
}

}  // namespace floes
