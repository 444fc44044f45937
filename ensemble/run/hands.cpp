#include "run/hands.hpp"

#include <fcntl.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <string>

#include "campaign_file/pieces.hpp"
#include "core/contract.hpp"
#include "core/error.hpp"
#include "member/run_member.hpp"

namespace floes {

namespace {

namespace fs = std::filesystem;

}  // namespace

std::vector<PieceOrder> piece_orders(const Campaign& published, const JournalContents& journal,
                                     const fs::path& campaign_file, int pieces) {
    FLOES_EXPECTS(pieces >= 1);
    const auto records = match_records(published, journal.members);
    const std::vector<int> attempts = last_attempts(published, journal.members);
    FoundSizes most{};
    for (const std::optional<std::size_t>& record : records)
        if (record && journal.members[*record].done()) add_found(most, journal.members[*record]);
    const int count = std::clamp(published.arrangements, 1, pieces);
    const fs::path file = fs::absolute(campaign_file);
    std::vector<PieceOrder> orders;
    for (int k = 0; k < count; ++k) {
        const auto [first, arrangements] = arrangements_of_piece(published.arrangements, count, k);
        PieceOrder& order = orders.emplace_back();
        order.campaign_file = file.string();
        order.journal = journal_path(file).string();
        order.name = piece_name(file, journal.sessions.size(), k + 1);
        order.arrangements = published.arrangements;
        order.first = first;
        order.most = most;
        const std::size_t cases = published.cases.size();
        const std::size_t begin = static_cast<std::size_t>(first) * cases;
        for (std::size_t member = begin; member < begin + static_cast<std::size_t>(arrangements) * cases; ++member) {
            PieceOrder::Member& one = order.members.emplace_back();
            one.attempts = attempts[member];
            one.has_record = records[member].has_value();
            if (!one.has_record) continue;
            one.note = journal.members[*records[member]];
            one.place = journal.places[*records[member]];
        }
    }
    return orders;
}

PieceMade make_piece(Campaign campaign, const PieceOrder& order) {
    const double begin = cpu_seconds_of_this_thread();
    PieceMade made;
    try {
        campaign.arrangements = order.arrangements;
        MemberNotes notes;
        std::vector<JournalContents::Place> places;
        PieceRows rows{.first = order.first, .records = {}, .attempts = {}, .most = order.most};
        for (const PieceOrder::Member& member : order.members) {
            rows.attempts.push_back(member.attempts);
            rows.records.emplace_back(member.has_record ? std::optional(notes.size()) : std::nullopt);
            if (!member.has_record) continue;
            notes.add("", member.note);
            places.push_back(member.place);
        }
        std::map<int, OpenFile> open;  // the journal and its pieces, each from its first record on
        const StoredMembers members(notes, [&](std::size_t k) {
            const JournalContents::Place& place = places.at(k);
            if (!open.contains(place.piece))
                open.emplace(place.piece, open_file(piece_path(order.journal, place.piece), O_RDONLY));
            return journal_format::read_member(open.at(place.piece), place);
        });
        made.piece = publish_piece(order.campaign_file, order.name, campaign, members, std::move(rows));
    } catch (const std::exception& error) {
        made.trouble = error.what();
    }
    made.processor_time = cpu_seconds_of_this_thread() - begin;
    return made;
}

DigestsMade make_digests(const DigestOrder& order) {
    DigestsMade made;
    try {
        std::vector<FilePiece> pieces;
        for (const std::string& file : order.pieces) pieces.emplace_back().file = file;
        made.digests = digests_over_pieces(order.file, pieces, order.datasets);
    } catch (const std::exception& error) {
        made.trouble = error.what();
    }
    return made;
}

Hands::Hands(Link& link, const Campaign& campaign, const Groups& groups, std::function<void()> listen)
    : link_(link), campaign_(campaign), listen_(std::move(listen)), ranks_(groups.writers()) {
    ranks_.insert(ranks_.begin(), master_rank);
}

bool Hands::publish(const Campaign& published, const Journal& journal, const fs::path& campaign_file) {
    const std::vector<PieceOrder> orders =
        piece_orders(published, journal.contents(), campaign_file, static_cast<int>(ranks_.size()));
    make_piece_folder(campaign_file);
    const std::vector<FilePiece> pieces = make_pieces(orders);
    if (lost_one_) return false;
    publish_over_pieces(campaign_file, published, pieces, orders.front().most, journal.contents().sessions,
                        journal.contents().calibrations,
                        [&](const fs::path& over, const std::vector<std::string>& datasets) {
                            return digests(over, pieces, datasets);
                        });
    return true;
}

std::vector<FilePiece> Hands::make_pieces(const std::vector<PieceOrder>& orders) {
    std::vector<std::pair<int, Bytes>> by_rank;
    for (const PieceOrder& order : orders) by_rank.emplace_back(ranks_[by_rank.size()], encode(order));
    std::vector<FilePiece> pieces;
    std::string trouble;
    for (const Bytes& answer : ask(Tag::publish, by_rank)) {
        PieceMade made = decode<PieceMade>(answer);
        if (!made.trouble.empty()) trouble = made.trouble;
        if (made.trouble.empty()) pieces.push_back(std::move(made.piece));
    }
    if (trouble.empty()) return pieces;
    remove_those(orders.front().campaign_file, pieces);  // on a full disk the journals need the room
    throw RunError(trouble);
}

/// Of the datasets of a file over pieces, some by each rank; what a lost one leaves is computed here.
DatasetDigests Hands::digests(const fs::path& file, std::span<const FilePiece> pieces,
                              const std::vector<std::string>& datasets) {
    DigestOrder order{.file = fs::absolute(file).string(), .pieces = {}, .datasets = {}};
    for (const FilePiece& piece : pieces) order.pieces.push_back(piece.file);
    std::vector<DigestOrder> shares(std::min(ranks_.size(), datasets.size()), order);
    for (std::size_t k = 0; k < datasets.size(); ++k) shares[k % shares.size()].datasets.push_back(datasets[k]);
    std::vector<std::pair<int, Bytes>> by_rank;
    for (const DigestOrder& share : shares) by_rank.emplace_back(ranks_[by_rank.size()], encode(share));
    DatasetDigests all;
    const auto add = [&](DigestsMade made) {
        if (!made.trouble.empty()) throw RunError(made.trouble);
        all.merge(made.digests);
    };
    for (const Bytes& answer : ask(Tag::digest, by_rank)) add(decode<DigestsMade>(answer));
    for (const std::string& path : datasets)
        if (!all.contains(path)) order.datasets.push_back(path);
    if (!order.datasets.empty()) add(make_digests(order));
    return all;
}

/// Gives each of these ranks its order and waits for the answers, which come in the order of the orders. Of a rank that
/// is lost meanwhile there is none.
std::vector<Bytes> Hands::ask(Tag tag, const std::vector<std::pair<int, Bytes>>& orders) {
    answers_.clear();
    Hand own;
    for (const auto& [rank, order] : orders) {
        awaited_.insert(rank);
        if (rank != master_rank) link_.send(rank, tag, order);
    }
    if (!orders.empty())  // rank 0 has the first
        own.begin(tag, [this, tag, order = orders.front().second] {
            return tag == Tag::publish ? encode(make_piece(campaign_, decode<PieceOrder>(order)))
                                       : encode(make_digests(decode<DigestOrder>(order)));
        });
    while (!awaited_.empty()) {
        if (auto done = own.take()) answered(master_rank, std::move(done->second));
        listen_();
    }
    std::vector<Bytes> all;
    for (const auto& [rank, order] : orders)
        if (answers_.contains(rank)) all.push_back(std::move(answers_.at(rank)));
    return all;
}

void Hands::answered(int rank, Bytes answer) {
    if (awaited_.erase(rank) > 0) answers_[rank] = std::move(answer);
}

void Hands::lost(int rank) {
    lost_one_ = awaited_.erase(rank) > 0 || lost_one_;
    std::erase(ranks_, rank);  // nobody answers for it
}

void Hand::begin(Tag answer, Work work) {
    FLOES_EXPECTS(!work_.valid());
    answer_ = answer;
    work_ = std::async(std::launch::async, std::move(work));
}

std::optional<std::pair<Tag, Bytes>> Hand::take() {
    if (!work_.valid() || work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
    return std::pair(answer_, work_.get());
}

}  // namespace floes
