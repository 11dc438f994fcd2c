#pragma once

#include "fem/pipeline/study_result.h"

#include <chrono>
#include <cstddef>
#include <string>

namespace stemware::pipeline
{

/// Table of contact steps that grows as they come; its header is printed before the first.
class ProgressTable
{
public:
  void add(const fem::ContactIteration &iteration);

private:
  bool has_header = false;
};

/// What is pressed on the table, or the file that says so: one line.
void print_load_source(const Study &study);

/// Size of the finite-element system, and what is special about a mesh file.
void print_mesh(const FootContact &contact);

/// One line: what it is about, in the left column, and what there is to say.
void print_note(const std::string &subject, const std::string &text);

/// A line every few seconds on how many spins contact and friction have been brought into balance at.
class BalanceProgress
{
public:
  void add(std::size_t n_states);

private:
  std::chrono::steady_clock::time_point last_line = std::chrono::steady_clock::now();
};

/// The answer in sentences, and the table of truncations.
void print_answer(const Study &study, const StudyResult &result);

} // namespace stemware::pipeline
