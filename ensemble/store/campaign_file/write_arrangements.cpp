#include <algorithm>

#include "campaign_file/campaign_content.hpp"

namespace floes {
namespace {

/// The rows of one arrangement number after another: members come in the order of these.
class Arrangements {
  public:
    Arrangements(hid_t group, const CampaignScales& scales, const ArrangementRows& rows)
        : rows_(rows),
          floes_(scales.floe.size()),
          number_(group, {"number", "1", "arrangement number"}, {scales.arrangement}),
          pose_(group, {"pose", "m, m, rad", "pose of each floe at the start: x, z, yaw"},
                {scales.arrangement, scales.floe, scales.coordinate}, nan),
          psi4_(group, {"psi4", "1", "fourfold orientational order of the arrangement"}, {scales.arrangement}, nan) {
        begin(0);
    }

    void write(const FiledMember& member) {
        const int row = member.row.arrangement;
        if (rows_.number(row) != rows_.number(first_)) {
            end();
            begin(row - row % rows_.groups());
        }
        if (member.record == nullptr || member.record->result.arrangement.empty()) return;
        const MemberResult& result = member.record->result;
        const auto place = static_cast<std::size_t>(row - first_);
        orders_[place] = result.psi4;
        for (std::size_t floe = 0; floe < std::min(floes_, result.arrangement.size()); ++floe) {
            const PlanarPose& pose = result.arrangement[floe];
            std::ranges::copy(std::array{pose.x, pose.z, pose.yaw},
                              poses_.begin() + static_cast<std::ptrdiff_t>((place * floes_ + floe) * 3));
        }
    }

    void finish() {
        end();
        number_.finish();
        pose_.finish();
        psi4_.finish();
    }

  private:
    void begin(int row) {
        const auto groups = static_cast<std::size_t>(rows_.groups());
        first_ = row;
        poses_.assign(groups * floes_ * 3, nan);
        orders_.assign(groups, nan);
    }

    void end() {
        for (std::size_t k = 0; k < orders_.size(); ++k) number_.add(rows_.number(first_));
        pose_.add(poses_);
        psi4_.add(orders_);
    }

    const ArrangementRows& rows_;
    std::size_t floes_;
    hdf5::Column<std::int32_t> number_;
    hdf5::Column<double> pose_;
    hdf5::Column<double> psi4_;
    int first_ = 0;  ///< row of the present arrangement number
    std::vector<double> poses_;
    std::vector<double> orders_;
};

}  // namespace

void add_arrangements(hid_t file, const CampaignContent& content, const CampaignScales& scales, MemberTables& tables) {
    const hdf5::Handle group = hdf5::create_group(file, "arrangements");
    tables.add(std::make_shared<Arrangements>(group.id(), scales, content.rows.arrangements()),
               [](Arrangements& all, const FiledMember& member) { all.write(member); });
}

}  // namespace floes
