#pragma once

#include "fem/pipeline/study_result.h"

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

/// A line for every 500 spins at which contact and friction have been brought into balance.
void print_balance(std::size_t n_states);

/// The answer in sentences, and the table of truncations.
void print_answer(const Study &study, const StudyResult &result);

} // namespace stemware::pipeline
