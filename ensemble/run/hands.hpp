#pragma once
// The campaign file by many hands, in a run of several writers: what each has to do, and a hand that does it beside the
// thread that passes messages.

#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "campaign/campaign.hpp"
#include "run/link.hpp"
#include "run/messages.hpp"
#include "run/writer.hpp"
#include "store/journal.hpp"

namespace floes {

/// The orders for so many pieces, fewer where there are fewer arrangements. `published`: the campaign of the file;
/// `journal`: its members, all records of which can be read.
std::vector<PieceOrder> piece_orders(const Campaign& published, const JournalContents& journal,
                                     const std::filesystem::path& campaign_file, int pieces);

/// Does what was ordered, and tells of trouble in the answer. `campaign`: with at least the arrangements of the order.
PieceMade make_piece(Campaign campaign, const PieceOrder& order);
DigestsMade make_digests(const DigestOrder& order);

/// The ranks that keep records, as they publish a campaign file together. Of rank 0.
class Hands {
  public:
    /// `listen`: takes the messages that have come, passes answers and losses on to these hands, and sleeps a little.
    /// The others must outlive these, too.
    Hands(Link& link, const Campaign& campaign, const Groups& groups, std::function<void()> listen);

    /// To be called when everything is in the journals. False where a rank was lost on the way. Throws RunError where
    /// the file cannot be written; the pieces are removed then.
    bool publish(const Campaign& published, const Journal& journal, const std::filesystem::path& campaign_file);

    void answered(int rank, Bytes answer);
    void lost(int rank);

  private:
    std::vector<Bytes> ask(Tag tag, const std::vector<std::pair<int, Bytes>>& orders);
    std::vector<FilePiece> make_pieces(const std::vector<PieceOrder>& orders);
    DatasetDigests digests(const std::filesystem::path& file, std::span<const FilePiece> pieces,
                           const std::vector<std::string>& datasets);

    Link& link_;
    const Campaign& campaign_;
    std::function<void()> listen_;
    std::vector<int> ranks_;  ///< rank 0 is the first
    std::set<int> awaited_;   ///< that have an order
    std::map<int, Bytes> answers_;
    bool lost_one_ = false;
};

/// Works on one order at a time in a thread of its own, so that its rank goes on giving signs of life.
class Hand {
  public:
    using Work = std::function<Bytes()>;

    /// `answer`: the message that take() gives when the work is done.
    void begin(Tag answer, Work work);
    /// The answer, once.
    std::optional<std::pair<Tag, Bytes>> take();

  private:
    Tag answer_ = Tag::published;
    std::future<Bytes> work_;
};

}  // namespace floes
