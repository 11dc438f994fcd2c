#pragma once

#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"

#include <memory>

namespace stemware::test
{

/// Foot, load and terminal spin of a study. The constructor throws if one of them cannot be computed.
struct SolvedStudy
{
  explicit SolvedStudy(const pipeline::Study &given, const pipeline::Model &model = {})
      : study(given)
      , foot(pipeline::study_foot({ study, {}, model }, pipeline::foot_maker(cache)))
      , load(pipeline::find_load(study, foot))
  {
    ring::Question question = pipeline::spin_question(study);
    row = ring::answer(load, question).value();
  }

  double omega() const { return row.terminal->omega; }

  pipeline::Study study;
  fem::ComplianceCache cache;
  std::shared_ptr<pipeline::ElasticFoot> foot;
  pipeline::BalancedLoad load;
  ring::Answer row;
};

inline pipeline::Model rigid_foot()
{
  pipeline::Model model;
  model.foot_is_rigid = true;
  return model;
}

inline pipeline::SpinStudy whole_spin_study(const pipeline::Study &study, const pipeline::Executor &executor)
{
  const auto foot = pipeline::study_foot(study, executor.make_foot);
  return pipeline::study_spin({ study, foot, executor }, pipeline::find_load(study, foot));
}

} // namespace stemware::test
