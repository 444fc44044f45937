// A published campaign file, damaged. The second byte of an input says what is read of it.

#include "campaign_file/publish.hpp"
#include "fuzz/edited_file.hpp"
#include "support/everything_read.hpp"
#include "support/synthetic.hpp"

namespace {

using namespace floes;

/// The whole file, and what each reader gives of it.
class Published {
  public:
    Published() : files_(write, write_campaign(campaign())) {
        for (const auto& read : parts_read) right_.push_back(read(files_.whole()));
        fuzz::require(!read_campaign_file(files_.whole()).members.empty(), "the whole file has no members");
    }

    void read(const fuzz::FileInput& input) {
        const std::filesystem::path path = files_.damaged(input);
        if (path.empty()) return;
        const std::size_t part = part_of(input.choice);
        const auto read = fuzz::taken([&] { return parts_read[part](path); });
        fuzz::require(!read || input.damage == fuzz::Damage::values || *read == right_[part],
                      "damaged bytes are numbers");
    }

  private:
    /// The last part, the configuration, takes long to parse and has targets of its own: one choice of 256 reads it.
    static std::size_t part_of(std::uint8_t choice) {
        constexpr std::size_t last = std::size(parts_read) - 1;
        return choice == 255 ? last : choice % last;
    }

    static Campaign campaign() { return synthetic::campaign(1); }

    static void write(const std::filesystem::path& path) {
        const Campaign of = campaign();
        std::vector<MemberRecord> records;
        for (int number = 0; number < member_count(of); ++number) records.push_back(synthetic::record(of, number));
        publish(path, of, records, std::vector<Session>(1));
    }

    fuzz::DamagedFiles files_;
    std::vector<Bytes> right_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Published published;
    if (size >= 2) published.read(fuzz::FileInput(std::span(data, size)));
    return 0;
}
