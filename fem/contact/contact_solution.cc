#include "fem/contact/contact_solution.h"

namespace stemware::fem
{

std::string to_string(ContactOutcome outcome)
{
  switch (outcome)
  {
  case ContactOutcome::converged:
    return "converged";
  case ContactOutcome::narrow_contact:
    return "narrow contact";
  case ContactOutcome::tipping:
    return "tipping";
  case ContactOutcome::repeated_set:
    return "repeated contact set";
  case ContactOutcome::singular_set:
    return "singular contact set";
  case ContactOutcome::too_many_steps:
    return "too many contact steps";
  case ContactOutcome::unbalanced:
    return "unbalanced contact forces";
  case ContactOutcome::linear_solver_failed:
    return "linear solver failed";
  case ContactOutcome::inverted_cells:
    return "cells inside out";
  case ContactOutcome::overflow:
    return "overflow";
  }
  throw std::logic_error("unnamed contact outcome");
}

} // namespace stemware::fem
