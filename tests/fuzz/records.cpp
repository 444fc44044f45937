// What journals store, as bytes. The first byte chooses the kind of record.

#include "fuzz/fuzz.hpp"
#include "store/member_record.hpp"
#include "store/session.hpp"

namespace {

using floes::Bytes;

/// What `decode` takes is written in one way only, and read from that with the same bits. Keys of a newer version
/// are skipped, so the first bytes may be others.
template <class Decode>
auto require_one_writing(std::span<const std::byte> bytes, const Decode& decode) {
    auto record = floes::fuzz::taken([&] { return decode(bytes); });
    if (record) {
        const Bytes written = floes::encode(*record);
        floes::fuzz::require(floes::encode(decode(written)) == written, "a record is not what was written");
    }
    return record;
}

void use(const floes::MemberRecord& record) {
    floes::fuzz::taken([&] { return record.whole(); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto bytes = floes::fuzz::as_bytes(data, size).subspan(1);
    switch (data[0] % 3) {
        case 0: {
            const auto record = require_one_writing(bytes, floes::decode_member_record);
            if (record) use(*record);
            break;
        }
        case 1:
            require_one_writing(bytes, floes::decode_session);
            break;
        default:
            require_one_writing(bytes, floes::decode_calibration_record);
    }
    return 0;
}
