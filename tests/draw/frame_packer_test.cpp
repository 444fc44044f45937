#include "draw/replay_page.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>

#include "draw/synthetic_recording.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace frame_packer_test {

template <typename Value>
std::vector<Value> inflated(const Bytes& packed) {
    Bytes plain(1 << 22);
    uLongf size = plain.size();
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(plain.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                         packed.size()),
              Z_OK);
    std::vector<Value> values(size / sizeof(Value));
    std::memcpy(values.data(), plain.data(), values.size() * sizeof(Value));
    return values;
}

/// What the page reads from the streams, as its data.js does.
class Unpacked {
  public:
    Unpacked(const PackedFrames& packed, std::size_t elements)
        : numbers(inflated<float>(packed.of(FrameStream::numbers))),
          contacts(inflated<std::int16_t>(packed.of(FrameStream::contacts))),
          pieces(inflated<std::int32_t>(packed.of(FrameStream::pieces))),
          elements_(elements) {
        const auto low = inflated<std::uint8_t>(packed.of(FrameStream::low));
        const auto high = inflated<std::uint8_t>(packed.of(FrameStream::high));
        states_.resize(low.size());
        for (std::size_t i = 0; i < low.size(); ++i) {
            const int before = i < 7 * elements ? 0 : states_[i - 7 * elements];
            states_[i] = static_cast<std::int16_t>(before + (low[i] | high[i] << 8));
        }
        percent = inflated<std::uint8_t>(packed.of(FrameStream::utilisation));
        for (std::size_t i = elements; i < percent.size(); ++i)
            percent[i] = static_cast<std::uint8_t>(percent[i] + percent[i - elements]);
    }

    double part(int frame, int part, std::size_t element) const {
        return states_.at(static_cast<std::size_t>(7 * frame + part) * elements_ + element);
    }

    std::vector<float> numbers;
    std::vector<std::int16_t> contacts;
    std::vector<std::int32_t> pieces;
    std::vector<std::uint8_t> percent;

  private:
    std::size_t elements_;
    std::vector<std::int16_t> states_;
};

class PackedReplay : public testing::Test {
  protected:
    static constexpr int frames = 40;

    PackedReplay() : record_(written()), quanta_(quanta_of(record_)) {
        FramePacker packer(quanta_, static_cast<int>(record_.layout().elements.size()));
        for (int i = 0; i < frames; ++i) packer.add(record_.read(i));
        packed_ = packer.finish();
    }

    std::filesystem::path written() {
        synthetic::write_recording(folder_ / "recording.h5", frames);
        return folder_ / "recording.h5";
    }

    TemporaryFolder folder_;
    Recording record_;
    Quanta quanta_;
    PackedFrames packed_;
};

TEST_F(PackedReplay, KeepsPosesToHalfAQuantum) {
    const auto elements = record_.layout().elements.size();
    const Unpacked page(packed_, elements);
    std::vector<Quat> before(elements, Quat(0, 0, 0, 0));
    for (int i = 0; i < frames; ++i) {
        const Frame frame = record_.read(i);
        for (std::size_t e = 0; e < elements; ++e) {
            const BodyState& state = frame.elements[e];
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(quanta_.middle[axis] + quanta_.length * page.part(i, axis, e), state.position[axis],
                            0.501 * quanta_.length);
            const Quat q(page.part(i, 3, e), page.part(i, 4, e), page.part(i, 5, e), page.part(i, 6, e));
            EXPECT_LT(Quat(state.rotation).angularDistance(q.normalized()), 2.2 * quanta_.orientation);
            // The page goes straight from one frame to the next.
            EXPECT_GE(q.dot(before[e]), 0) << "frame " << i << ", element " << e;
            before[e] = q;
        }
    }
    EXPECT_LT(quanta_.length, 11.0 / 65000);  // the field is 11 m long
}

// Of a field without end: elements 0 to 8 leave, others come.
TEST_F(PackedReplay, SaysByATurnOfZerosWhatIsNotThere) {
    const auto elements = record_.layout().elements.size();
    FramePacker packer(quanta_, static_cast<int>(elements));
    const auto is_there = [](int frame, std::size_t e) { return frame < 5 ? e < 18 : e >= 9; };
    for (int i = 0; i < 10; ++i) {
        const Frame whole = record_.read(i);
        Frame part = whole;
        part.elements.clear();
        part.pieces.clear();
        part.utilisation.clear();
        for (std::size_t e = 0; e < elements; ++e) {
            if (!is_there(i, e)) continue;
            part.ids.push_back(static_cast<int>(e));
            part.elements.push_back(whole.elements[e]);
            part.pieces.push_back(whole.pieces[e]);
            part.utilisation.push_back(whole.utilisation[e]);
        }
        packer.add(part);
    }
    const Unpacked page(packer.finish(), elements);
    for (int i = 0; i < 10; ++i) {
        const Frame whole = record_.read(i);
        for (std::size_t e = 0; e < elements; ++e) {
            double turn = 0;
            for (int part = 3; part < 7; ++part) turn += std::pow(page.part(i, part, e), 2);
            ASSERT_EQ(turn > 0, is_there(i, e)) << i << " " << e;
            if (!is_there(i, e)) continue;
            EXPECT_NEAR(quanta_.middle[0] + quanta_.length * page.part(i, 0, e), whole.elements[e].position[0],
                        0.501 * quanta_.length);
        }
    }
    const double last = page.part(4, 0, 0);
    EXPECT_EQ(page.part(9, 0, 0), last) << "what has left keeps its place, which takes no bytes";
}

TEST_F(PackedReplay, KeepsLoadsUtilisationAndPieces) {
    const auto elements = record_.layout().elements.size();
    const Unpacked page(packed_, elements);
    std::vector<int> pieces(elements, -1);
    std::size_t change = 0;
    for (int i = 0; i < frames; ++i) {
        const Frame frame = record_.read(i);
        const float* number = &page.numbers.at(5 * static_cast<std::size_t>(i));
        EXPECT_FLOAT_EQ(number[0], static_cast<float>(frame.time));
        for (int axis = 0; axis < 3; ++axis) EXPECT_FLOAT_EQ(number[1 + axis], static_cast<float>(frame.load[axis]));
        for (; change < page.pieces.size() && page.pieces[change] == i; change += 3)
            pieces[static_cast<std::size_t>(page.pieces[change + 1])] = page.pieces[change + 2];
        EXPECT_EQ(pieces, frame.pieces);
        for (std::size_t e = 0; e < elements; ++e)
            EXPECT_NEAR(page.percent.at(static_cast<std::size_t>(i) * elements + e), 100 * frame.utilisation[e], 0.501);
    }
    EXPECT_EQ(change, page.pieces.size());
}

TEST_F(PackedReplay, KeepsContactsWhoseForceIsToBeSeen) {
    const Unpacked page(packed_, record_.layout().elements.size());
    std::size_t at = 0;
    int of_the_structure = 0;
    int among_ice = 0;
    for (int i = 0; i < frames; ++i) {
        int kept = 0;
        for (const FrameContact& contact : record_.read(i).contacts) {
            const bool of_structure = contact.other == touches_structure;
            if (!of_structure && (contact.normal + contact.friction).norm() < quanta_.least_force) continue;
            ++kept;
            ++(of_structure ? of_the_structure : among_ice);
            for (int axis = 0; axis < 3; ++axis, ++at) {
                EXPECT_NEAR(quanta_.middle[axis] + quanta_.length * page.contacts.at(at), contact.point[axis],
                            0.501 * quanta_.length);
                EXPECT_NEAR(quanta_.force * page.contacts.at(at + 3), contact.normal[axis], 0.501 * quanta_.force);
                EXPECT_NEAR(quanta_.force * page.contacts.at(at + 6), contact.friction[axis], 0.501 * quanta_.force);
            }
            at += 6;
            EXPECT_EQ(page.contacts.at(at++), of_structure ? 1 : 0);
        }
        EXPECT_EQ(page.numbers.at(5 * static_cast<std::size_t>(i) + 4), kept);
    }
    EXPECT_EQ(at, page.contacts.size());
    EXPECT_GT(of_the_structure, 0);
    EXPECT_GT(among_ice, 0);
    EXPECT_NEAR(quanta_.least_force, 0.002 * 10 * (frames - 1), 0.01) << "of the largest load";
}

}  // namespace frame_packer_test
}  // namespace floes
