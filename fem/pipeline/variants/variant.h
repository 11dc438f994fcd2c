#pragma once

#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/study/study.h"

#include <memory>
#include <string>

namespace stemware::pipeline
{

/// A study changed in one thing, or in none, with a name: what is solved beside the study itself. Makers of
/// variants add to it what their judge has to know.
struct Variant
{
  std::string key = {};  ///< what it is told apart by, its place in a chain or the part of a band
  std::string name = {}; ///< for people: "tilt"
  Study study = {};
  unsigned int n_harmonics = all_harmonics; ///< whose friction acts
  bool on_same_foot = false;                ///< on the foot of the study, not on one of its own
  bool on_same_load = false;                ///< of the study: only what the ring is asked differs
  std::string reason = {};                  ///< why it is not solved; empty where it is
  bool on_other_rings = false;              ///< of the same foot: they are placed anew
};

} // namespace stemware::pipeline
