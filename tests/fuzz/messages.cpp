// Messages between ranks. The first byte chooses the kind.

#include "run/messages.hpp"
#include "fuzz/fuzz.hpp"

namespace {

using floes::Bytes;

template <class Decode, class Encode>
void require_same_bytes(const Bytes& bytes, const Decode& decode, const Encode& encode) {
    const auto message = floes::fuzz::taken([&] { return decode(bytes); });
    if (message) floes::fuzz::require(encode(*message) == bytes, "a message is not what was sent");
}

/// Their records may lack what came later, so the first bytes can be others.
template <class Decode>
void require_one_writing(const Bytes& bytes, const Decode& decode) {
    const auto records = floes::fuzz::taken([&] { return decode(bytes); });
    if (!records) return;
    const Bytes written = floes::encode(*records);
    floes::fuzz::require(floes::encode(decode(written)) == written, "a record is not what was sent");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto rest = floes::fuzz::as_bytes(data, size).subspan(1);
    const Bytes bytes(rest.begin(), rest.end());
    const auto encode = [](const auto& message) { return floes::encode(message); };
    switch (data[0] % 8) {
        case 0:
            require_one_writing(bytes, floes::decode<std::vector<floes::Answer>>);
            break;
        case 1:
            require_same_bytes(bytes, floes::decode<floes::Hello>, encode);
            break;
        case 2:
            require_same_bytes(bytes, floes::decode<std::vector<floes::Assignment>>, encode);
            break;
        case 3:
            require_same_bytes(bytes, floes::decode<int>, encode);
            break;
        case 4:
            require_one_writing(bytes, floes::decode<std::vector<floes::Kept>>);
            break;
        case 5:
            require_same_bytes(bytes, floes::decode<floes::Post>, encode);
            break;
        case 7:
            require_same_bytes(bytes, floes::decode<std::vector<floes::MemberProgress>>, encode);
            break;
        default:
            require_same_bytes(bytes, floes::decode<std::string>, encode);
    }
    return 0;
}
