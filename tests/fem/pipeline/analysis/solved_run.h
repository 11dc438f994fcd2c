#pragma once

#include "fem/pipeline/analysis/study_answer.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/result/verb_results.h"

#include <memory>

namespace stemware::test
{

/// Analysis and results of the command `run`, without written files.
struct SolvedRun : pipeline::StudyAnswer
{
  explicit SolvedRun(const pipeline::Study &given, const pipeline::Model &model = {})
      : foot(pipeline::study_foot({ given, {}, model }, pipeline::foot_maker(cache)))
  {
    const pipeline::ThreadedExecutor executor(cache);
    pipeline::StudyAnswer::operator=(
      pipeline::answer_study({ given, foot, executor }, pipeline::Depth::full));
  }

  pipeline::Results results() const { return pipeline::run_results(*this); }
  pipeline::Json summary() const { return results().summary; }

  fem::ComplianceCache cache;
  std::shared_ptr<pipeline::ElasticFoot> foot;
};

} // namespace stemware::test
