#pragma once
// The conditions that decide the load together, in words: structure wall, far end and contacts. A load without them
// means nothing.

#include <string>
#include <vector>

#include "findings/summary.hpp"
#include "tables/data_rows.hpp"

namespace floes {

/// "an ice sheet" or "open".
std::string far_end_words(FarEnd far_end);

/// The key's value in the configuration: "ice_sheet" or "open".
std::string far_end_key(FarEnd far_end);

/// "preset paper, friction in one direction, rigid with Γ 0.2".
std::string contact_words(const ContactLaw& law);

/// "80 to 230 s after the tow began, in 3 segments".
std::string window_words(const Analysis& analysis);

/// One sentence for each condition; where cases differ, one for each value with the names of its cases.
std::vector<std::string> condition_lines(const Summary& summary);

using ConditionColumn = DataColumn<CaseRow>;

/// Whether maxima of single steps depend on the time step in some case, because its contacts are rigid.
bool has_rigid_contacts(const Summary& summary);

/// The conditions as columns of a case's record: "structure_wall" in CSV, under "conditions" in JSON.
std::vector<ConditionColumn> condition_columns(const Summary& summary);

}  // namespace floes
