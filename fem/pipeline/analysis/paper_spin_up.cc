#include "fem/pipeline/analysis/paper_spin_up.h"

#include "fem/pipeline/analysis/yaw_study.h"

namespace stemware::pipeline
{

std::vector<double> paper_spin_up(const Study &study)
{
  Study paper = study;
  paper.motion.closure = ring::Closure::paper;
  paper.load = {};
  paper.load.source = LoadSource::first_harmonic;
  return spin_up_curves(first_harmonic_load(paper).at_spin, paper.motion).adaptive;
}

} // namespace stemware::pipeline
