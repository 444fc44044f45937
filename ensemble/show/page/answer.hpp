#pragma once
// The first section of the report: the answer in sentences, what it rests on, and what would change it. For this room
// only.

#include <string>
#include <vector>

#include "page/report_data.hpp"

namespace floes {

/// A sentence for each case: mean load and design load, each with its interval; without design loads, broken floes
/// only.
std::vector<std::string> answer_sentences(const ReportData& data);

/// Members, ice field, method and how sure it is: a sentence each.
std::vector<std::string> basis_sentences(const ReportData& data);

/// The axes of a design that change the mean load most; one sentence if nothing was varied.
std::vector<std::string> change_sentences(const ReportData& data);

/// All of it as a section of a page.
std::string answer_section(const std::string& title, const ReportData& data);

}  // namespace floes
