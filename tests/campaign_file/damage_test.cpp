// Campaign files with damaged bytes: nothing of them is a number, and what is said names the dataset.

#include <gmock/gmock.h>

#include <fstream>
#include <optional>
#include <random>

#include "campaign_file/publish.hpp"
#include "core/error.hpp"
#include "hdf5/dataset.hpp"
#include "hdf5/pages.hpp"
#include "hdf5/read.hpp"
#include "support/everything_read.hpp"
#include "support/file_bytes.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace damage_test {

using testing::AnyOf;
using testing::HasSubstr;

class Damage : public testing::Test {
  protected:
    Damage() { publish(path_, campaign_, synthetic::records(campaign_), sessions_); }

    /// Changes the byte, and changes it back when called again.
    void flip(std::uint64_t at, unsigned bits) {
        std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
        file.seekg(static_cast<std::streamoff>(at));
        const auto changed = static_cast<char>(file.get() ^ static_cast<int>(bits));
        file.seekp(static_cast<std::streamoff>(at));
        file.put(changed);
    }

    /// As after h5repack: HDF5 alone says what is damaged, and the digests of datasets.
    void strip_page_digests() {
        const std::uint64_t size = hdf5::CheckedPages::open(path_)->size();
        std::filesystem::resize_file(path_, size);
    }

    /// What is said instead of numbers; none where the numbers are the right ones.
    std::optional<std::string> said(const Bytes& right) {
        try {
            EXPECT_EQ(everything_read(path_), right) << "damaged numbers";
            return std::nullopt;
        } catch (const RunError& error) {
            return error.what();
        } catch (const InputError& error) {
            return error.what();
        }
    }

    /// Gives a member another value, and calls `then` with the file and the dataset. HDF5 itself writes them, so that
    /// all its checksums fit.
    template <class Then>
    void rewrite(const char* name, double value, const Then& then) {
        const hdf5::Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, "H5Fopen", "a.h5");
        auto values = hdf5::read_values<double>(file.id(), name);
        values[3] = value;
        const hdf5::Handle dataset(H5Dopen2(file.id(), name, H5P_DEFAULT), H5Dclose, "H5Dopen", name);
        H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
        then(file.id(), dataset.id());
    }

    void expect_refusal(const std::string& sentence) {
        EXPECT_THAT([&] { read_campaign_file(path_); }, testing::ThrowsMessage<RunError>(HasSubstr(sentence)));
    }

    /// Where the first of these bytes stand.
    std::uint64_t place_of(std::span<const double> values) {
        const Bytes all = file_bytes(path_);
        const auto bytes = std::as_bytes(values);
        return static_cast<std::uint64_t>(std::ranges::search(all, bytes).begin() - all.begin());
    }

    TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / "a.h5";
    Campaign campaign_ = synthetic::campaign();
    std::vector<Session> sessions_{synthetic::session()};
};

TEST_F(Damage, FlippedBytesAreNeverNumbers) {
    const Bytes right = everything_read(path_);
    const std::uint64_t size = std::filesystem::file_size(path_);
    std::mt19937 random(1);
    int found = 0;
    constexpr int flips = 600;
    for (int k = 0; k < flips; ++k) {
        const std::uint64_t at = random() % size;
        const unsigned bits = 1 + random() % 255;
        flip(at, bits);
        const auto sentence = said(right);
        if (sentence) {
            ++found;
            EXPECT_THAT(*sentence, AnyOf(HasSubstr("is damaged: "), HasSubstr("is not an HDF5 file"))) << at;
        }
        flip(at, bits);
    }
    EXPECT_GT(found, flips / 2) << "the rest is what floes does not read, /cases among it";
    EXPECT_EQ(everything_read(path_), right);
}

TEST_F(Damage, IsSaidWithDatasetAndRemedy) {
    const Bytes right = everything_read(path_);
    const std::vector<double> mean_loads{100.1, 200.1};
    const std::uint64_t at = place_of(mean_loads);
    for (const bool with_pages : {true, false}) {
        if (!with_pages) strip_page_digests();
        flip(at + 5, 0x10);
        const auto sentence = said(right);
        ASSERT_TRUE(sentence);
        EXPECT_THAT(*sentence, HasSubstr(path_.string() + " is damaged: "));
        EXPECT_THAT(*sentence, HasSubstr("members/mean_load cannot be read (HDF5: "));
        EXPECT_THAT(*sentence, HasSubstr("--resume"));
        const hdf5::FileCheck check = hdf5::check_file(path_, {});
        EXPECT_FALSE(check.good());
        EXPECT_THAT(check.damaged,
                    testing::Contains(testing::Field(&hdf5::DamagedDataset::path, "/members/mean_load")));
        flip(at + 5, 0x10);
        EXPECT_TRUE(hdf5::check_file(path_, {}).good());
    }
}

// Found by fuzzing: HDF5 read far beyond a heap, because a size in it was another one.
TEST_F(Damage, OfTheTextOfADigestIsFoundBeforeHdf5ReadsIt) {
    std::string text;
    {
        const hdf5::Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "H5Fopen", "a.h5");
        const hdf5::Handle dataset(H5Dopen2(file.id(), "members/mean_load", H5P_DEFAULT), H5Dclose, "H5Dopen", "");
        text = hdf5::read_text_attribute(dataset.id(), "digest");
    }
    const Bytes all = file_bytes(path_);
    const auto place = std::ranges::search(all, std::as_bytes(std::span(text))).begin() - all.begin();
    constexpr int size_before_text = 8;  // u64, the last of what the heap says of a text
    flip(static_cast<std::uint64_t>(place - size_before_text + 1), 0xb1);
    const hdf5::QuietErrors quiet;
    const hdf5::Handle file = hdf5::open_for_reading(path_);
    EXPECT_THAT([&] { hdf5::read_values<double>(file.id(), "members/mean_load"); },
                testing::ThrowsMessage<RunError>(HasSubstr("are not those that were written")));
}

TEST_F(Damage, IsFoundWhereSomebodyChangedANumber) {
    rewrite("members/mean_load", 1, [](hid_t, hid_t) {});
    expect_refusal("members/mean_load does not fit its digest");
    const hdf5::FileCheck check = hdf5::check_file(path_, {});
    ASSERT_EQ(check.damaged.size(), 1u);
    EXPECT_EQ(check.damaged[0].path, "/members/mean_load");
}

// Found by fuzzing: without digests it became a count that nobody had counted, since the conversion is undefined.
TEST_F(Damage, OfACountIsRefusedWithoutDigests) {
    strip_page_digests();
    rewrite("members/failures_bending", -1e300, [](hid_t file, hid_t dataset) {
        H5Adelete(file, hdf5::contents_attribute);
        H5Adelete(dataset, hdf5::digest_attribute);
    });
    expect_refusal("members/failures_bending has -1e+300 in place of a count");
}

TEST_F(Damage, IsFoundInAttributesAndNames) {
    const auto change = [&](auto action) {
        publish(path_, campaign_, synthetic::records(campaign_), sessions_);
        const hdf5::Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, "H5Fopen", "a.h5");
        action(file.id());
    };
    EXPECT_TRUE(hdf5::check_file(path_, {}).good());
    change([](hid_t file) {
        const hdf5::Handle dataset(H5Dopen2(file, "members/mean_load", H5P_DEFAULT), H5Dclose, "H5Dopen", "");
        H5Adelete(dataset.id(), "units");
        hdf5::write_attribute(dataset.id(), "units", std::string("kN"));
    });
    EXPECT_THAT(hdf5::check_file(path_, {}).fault, HasSubstr("attributes"));
    change([](hid_t file) { H5Ldelete(file, "members/trend", H5P_DEFAULT); });
    EXPECT_THAT(hdf5::check_file(path_, {}).fault, HasSubstr("names of its datasets"));
    change([](hid_t file) {
        const hdf5::Handle dataset(H5Dopen2(file, "members/trend", H5P_DEFAULT), H5Dclose, "H5Dopen", "");
        H5Adelete(dataset.id(), "digest");
    });
    EXPECT_FALSE(hdf5::check_file(path_, {}).good());
    EXPECT_THROW(read_campaign_file(path_), RunError);
}

TEST_F(Damage, SaysWhichMembersAHistoryIsLostOf) {
    strip_page_digests();
    const Bytes chunk = pack(synthetic::record(campaign_, 5).result.load_map.along_tow).chunk;
    const Bytes all = file_bytes(path_);
    const auto found = std::ranges::search(all, chunk);
    ASSERT_FALSE(found.empty());
    flip(static_cast<std::uint64_t>(found.begin() - all.begin()) + 40, 0xff);
    const hdf5::FileCheck check = hdf5::check_file(path_, {});
    ASSERT_EQ(check.damaged.size(), 1u);
    EXPECT_EQ(check.damaged[0].path, "/load_map/surge_load_along_tow");
    EXPECT_THAT(check.damaged[0].rows, testing::ElementsAre(5u));
}

TEST_F(Damage, CutFilesAreRefusedAtEveryLength) {
    const Bytes whole = file_bytes(path_);
    const Bytes right = everything_read(path_);
    const std::uint64_t pages_end = hdf5::CheckedPages::open(path_)->size();
    for (std::uint64_t size = 0; size < pages_end; size += 1 + size / 8 + pages_end / 200) {
        write_file_bytes(path_, std::span(whole).first(size));
        EXPECT_TRUE(said(right)) << size;
    }
    write_file_bytes(path_, std::span(whole).first(pages_end));  // nothing but the digests is missing
    EXPECT_FALSE(said(right));
}

// The whole of a small file, each byte in turn.
TEST(CheckedPages, FindEveryFlippedByte) {
    const TemporaryFolder folder;
    const auto path = folder / "pages";
    std::string text;
    for (int k = 0; k < 9000; ++k) text += static_cast<char>(k * 7 % 251);
    write_file_bytes(path, std::as_bytes(std::span(text)));
    hdf5::append_page_digests(path);
    const Bytes whole = file_bytes(path);
    Bytes read(text.size());
    const auto is_right = [&] {
        try {
            auto pages = hdf5::CheckedPages::open(path);
            return pages && pages->size() == text.size() && pages->read(0, read);
        } catch (const RunError&) {
            return false;
        }
    };
    EXPECT_TRUE(is_right());
    EXPECT_EQ(std::memcmp(read.data(), text.data(), text.size()), 0);
    Bytes bytes = whole;
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    for (std::size_t k = 0; k < whole.size(); ++k) {
        const auto put = [&](std::byte value) {
            file.seekp(static_cast<std::streamoff>(k));
            file.put(static_cast<char>(value));
            file.flush();
        };
        put(whole[k] ^ std::byte{0x20});
        EXPECT_FALSE(is_right()) << k;
        put(whole[k]);
    }
    EXPECT_TRUE(is_right());
}

}  // namespace damage_test
}  // namespace floes
