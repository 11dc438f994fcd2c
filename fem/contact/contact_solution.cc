#include "fem/contact/contact_solution.h"

namespace stemware::fem
{

std::string to_string(ContactOutcome outcome)
{
  static constexpr const char *names[] = { "converged",
                                           "narrow contact",
                                           "tipping",
                                           "repeated contact set",
                                           "singular contact set",
                                           "too many contact steps",
                                           "unbalanced contact forces",
                                           "linear solver failed",
                                           "cells inside out",
                                           "overflow" };
  return names[static_cast<std::size_t>(outcome)];
}

} // namespace stemware::fem
