#pragma once
// What members cost, and what the driver costs beside them, as measured. The figures are in measured_costs.cpp, with
// the commands that made them.

#include <string>

namespace floes {

/// What the driver costs. All times in s, all sizes in bytes.
struct DriverCosts {
    // -- before the first member
    double start_up = 0;           ///< of the program, alone
    double start_up_per_rank = 0;  ///< more for every rank beyond the first: launch, campaign, hello

    // -- the master's thread, one thing after the other
    double send = 0;              ///< a message to another rank
    double assign = 0;            ///< each member in it
    double receive = 0;           ///< a message of another rank
    double answer = 0;            ///< each answer in it: take it, keep it in the journal
    double own_member = 0;        ///< hand out and keep a member of the master's own cores
    double receive_per_byte = 0;  ///< more for every byte of an answer of another rank
    double keep_per_byte = 0;     ///< more for every byte of the record
    double sync = 0;              ///< fdatasync of the journal
    double sync_interval = 0;     ///< between two of them
    double publish = 0;           ///< write the campaign file
    double publish_per_member = 0;
    double publish_per_byte = 0;  ///< of the records in it
    double publish_interval = 0;  ///< between two of them, at least
    double publish_share = 0;     ///< of the time at most, while the run goes on

    // -- a worker
    double member = 0;             ///< begin and end a member on a core
    double member_per_byte = 0;    ///< more for every byte that histories are packed to
    double report = 0;             ///< of the rank's message thread: write an answer and send it
    double report_per_byte = 0;    ///< more for every byte of the record
    double longest_held_back = 0;  ///< an answer, while others are to come
    double most_held_back = 0;     ///< answers

    // -- between them
    double latency = 0;  ///< of a message
    double transfer_per_byte = 0;
    double longest_pause = 0;  ///< a rank without news looks for messages at least this often
};

/// Of the present driver on the machine named in measured_costs.cpp.
DriverCosts measured_costs();

/// What a member costs.
struct MemberCosts {
    double lanes_per_unit = 0;        ///< s per unit of expected_cost(): an element, a step
    double stock_per_unit = 0;        ///< the same with Bullet's own solver
    double variation = 0;             ///< of the run times of a case: standard deviation over mean
    double history_bytes = 0;         ///< of a number of a load history, packed, in record and campaign file
    double file_per_record_byte = 0;  ///< of all else: rows that several records have stand in the file once
    std::string source;               ///< a sentence: where and when
};

MemberCosts measured_member_costs();

}  // namespace floes
