// seeds CORPUS: writes the first inputs of the targets that read bytes, from small members with a different value in
// every field. Inputs that a fuzzer found and that reach more stand beside them.

#include <filesystem>
#include <fstream>

#include "member/array_output.hpp"
#include "run/messages.hpp"
#include "store/journal.hpp"
#include "support/small_journal.hpp"
#include "support/synthetic.hpp"

namespace {

using namespace floes;

class Seeds {
  public:
    explicit Seeds(std::filesystem::path corpus) : corpus_(std::move(corpus)) {}

    /// `before` and `after` the bytes: what chooses how they are read.
    void write(const std::string& name, std::span<const std::byte> bytes, const std::string& before,
               const std::string& after = "") const {
        const std::filesystem::path path = corpus_ / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream file(path, std::ios::binary);
        file << before;
        file.write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
        file << after;
    }

  private:
    std::filesystem::path corpus_;
};

std::string kind(int number) {
    return {static_cast<char>(number)};
}

MemberRecord member() {
    const Campaign campaign = synthetic::campaign(1);
    MemberRecord record = synthetic::record(campaign, 0);
    record.result.reason = "none";
    record.result.averaged = {{0.1, 1, {4, 5}, 2, 3, {6}}};
    record.result.history = {{1, 2}, {3, 4}, {5, 6}};
    record.result.load_map.along_tow.assign(LoadMap::parts, 9);
    return record;
}

Bytes numbers(std::size_t count) {
    std::vector<double> values(count);
    for (std::size_t k = 0; k < count; ++k) values[k] = 0.5 * static_cast<double>(k % 7);
    const PackedNumbers packed = pack(values);
    ByteWriter out;
    out.u64(packed.count);
    Bytes bytes = out.take();
    bytes.insert(bytes.end(), packed.chunk.begin(), packed.chunk.end());
    return bytes;
}

Bytes journal() {
    using namespace journal_format;
    Bytes bytes = header("[[case]]\nname = \"a\"\n");
    const auto add = [&](RecordType type, std::span<const std::byte> payload) {
        const Bytes one = record(type, payload);
        bytes.insert(bytes.end(), one.begin(), one.end());
    };
    Session session;
    session.started = "2026";
    add(RecordType::session_begin, encode(session));
    ByteWriter begun;
    begun.text("case");
    begun.i32(1);
    begun.i32(1);
    add(RecordType::attempt_started, begun.bytes());
    add(RecordType::member, encode(small_record(1)));
    add(RecordType::calibration, encode(CalibrationRecord{"key", {}}));
    ByteWriter text;
    text.text("[campaign]\narrangements = 2\n");
    add(RecordType::campaign, text.bytes());
    ByteWriter end;
    end.text("2027");
    end.text("complete");
    add(RecordType::session_end, end.bytes());
    return bytes;
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return 2;
    const Seeds seeds(arguments[1]);
    seeds.write("packed_numbers/plain", numbers(3), "");
    seeds.write("packed_numbers/deflated", numbers(200), "");
    seeds.write("records/member", encode(member()), kind(0));
    Session session;
    session.software = {{"bullet", "3"}};
    seeds.write("records/session", encode(session), kind(1));
    seeds.write("records/calibration", encode(CalibrationRecord{"key", {.curve = {{}}}}), kind(2));
    seeds.write("messages/answers", encode(std::vector<Answer>{{3, small_record(1)}}), kind(0));
    seeds.write("messages/hello", encode(Hello{2, "node", "0123", 77}), kind(1));
    seeds.write("messages/assignments", encode(std::vector<Assignment>{{1, 1, false}, {2, 1, true}}), kind(2));
    seeds.write("messages/status", encode(85), kind(3));
    seeds.write("messages/kept", encode(std::vector<Kept>{{3, 6, {}, {}, {}}, {4, 7, {}, {}, small_record(1)}}),
                kind(4));
    seeds.write("messages/post", encode(Post{64, "/a/b.journal.1"}), kind(5));
    seeds.write("messages/progress", encode(std::vector<MemberProgress>{{3, 43.5, 200}}), kind(7));
    seeds.write("messages/text", encode(std::string("a sentence")), kind(6));
    seeds.write("journal/whole", journal(), "", kind(1));
    Bytes torn = journal();
    torn[torn.size() / 2] ^= std::byte{1};
    torn.resize(torn.size() - 3);
    seeds.write("journal/damaged", torn, "", kind(0));
    return 0;
}
