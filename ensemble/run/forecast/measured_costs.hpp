#pragma once
// Measured costs of members and of the driver. The figures are in measured_costs.cpp, with the commands that produced
// them.

#include <string>

namespace floes {

/// Costs of the driver. All times in s, all sizes in bytes.
struct DriverCosts {
    // -- before the first member
    double start_up = 0;           ///< of a single rank
    double start_up_per_rank = 0;  ///< for each further rank: launch, campaign, hello

    // -- the master's thread
    double send = 0;              ///< a message to another rank
    double assign = 0;            ///< each member in it
    double receive = 0;           ///< a message of another rank
    double answer = 0;            ///< each answer in it: take it, keep it in the journal
    double own_member = 0;        ///< hand out and keep a member of the master's own cores
    double receive_per_byte = 0;  ///< for each byte of an answer of another rank
    double keep_per_byte = 0;     ///< for each byte of the record
    double sync = 0;              ///< fdatasync of the journal
    double sync_interval = 0;     ///< s between two syncs
    double publish = 0;           ///< write the campaign file
    double publish_per_member = 0;
    double publish_per_byte = 0;  ///< for each byte of its records
    double publish_interval = 0;  ///< minimum time between two publications
    double publish_share = 0;     ///< largest share of the time during the run

    double memory_per_member = 0;  ///< bytes: the plan of what is to do, the notes of what is done, publishing

    // -- a worker
    double member = 0;             ///< begin and end a member on a core
    double member_per_byte = 0;    ///< for each byte of the packed histories
    double report = 0;             ///< in the rank's message thread: write an answer and send it
    double report_per_byte = 0;    ///< for each byte of the record
    double longest_held_back = 0;  ///< longest time for which an answer is held back
    double most_held_back = 0;     ///< largest number of answers held back

    // -- messages
    double latency = 0;  ///< of a message
    double transfer_per_byte = 0;
    double longest_pause = 0;  ///< longest pause between two polls of an idle rank
};

/// Costs of the present driver on the machine named in measured_costs.cpp.
DriverCosts measured_costs();

/// Costs of a member.
struct MemberCosts {
    double lanes_per_unit = 0;        ///< s per unit of expected_cost(): an element, a step
    double stock_per_unit = 0;        ///< the same with Bullet's own solver
    double variation = 0;             ///< of the run times of a case: standard deviation over mean
    double history_bytes = 0;         ///< per number of a load history, packed, in record and campaign file
    double file_per_record_byte = 0;  ///< of everything else: the file has rows that several records share only once
    std::string source;               ///< a sentence: where and when
};

MemberCosts measured_member_costs();

}  // namespace floes
