#pragma once
// What a member costs, as measured once. The figures are in measured_costs.cpp, with the commands that made them.

#include <string>

namespace floes {

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
