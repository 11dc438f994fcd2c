#include "fem/pipeline/report/paper_spin_up.h"

#include "fem/pipeline/ring_load.h"

namespace stemware::pipeline
{

SpinUp paper_spin_up(const Study &study)
{
  Study paper = study;
  paper.motion.closure = ring::Closure::paper;
  paper.load = {};
  paper.load.source = LoadSource::first_harmonic;
  return { "the paper's model", spin_up_curves(first_harmonic_load(paper).at_spin, paper.motion).adaptive };
}

} // namespace stemware::pipeline
