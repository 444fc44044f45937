// The record of a replayed member, damaged.

#include "campaign/write.hpp"
#include "fuzz/edited_file.hpp"
#include "replay/record.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace {

using namespace floes;

fuzz::EditedFile recorded() {
    const TemporaryFolder folder;
    const Campaign campaign = synthetic::campaign(1);
    RecordSubject subject;
    subject.campaign = campaign.name;
    subject.configuration = write_campaign(campaign);
    subject.case_name = campaign.cases.front().name;
    subject.scenario = campaign.cases.front().scenario;
    constexpr int floes_of_it = 2;
    const auto elements = static_cast<std::size_t>(floes_of_it * elements_of_a_floe(subject));
    RecordWriter writer(folder / "a.h5", subject, floes_of_it);
    for (int k = 0; k < 2; ++k) {
        Frame frame;
        frame.step = k;
        frame.time = 0.02 * k;
        frame.elements.resize(elements);
        frame.pieces.assign(elements, 0);
        frame.utilisation.assign(elements, 0.5);
        frame.contacts.resize(2);
        writer.add(frame);
    }
    writer.finish({{{1, 2}, {3, 4}, {5, 6}}, {{0.02, 1, 2, FailureMode::shear}}});
    return fuzz::EditedFile(folder / "a.h5");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static fuzz::EditedFile file = recorded();
    file.edit(std::span(data, size));
    const auto read = fuzz::taken([&] {
        const Record record(file.path());
        Frame frame;
        double sum = 0;
        for (int k = 0; k < std::min(3, record.frames()); ++k) {
            record.read(record.nearest(record.time(k)), frame);
            sum += frame.load.x();
        }
        broken_floes(record.outcome().breaks, record.floes(), sum);
        return sum;
    });
    fuzz::require(read.has_value() || size > 0, "the whole record is refused");
    return 0;
}
