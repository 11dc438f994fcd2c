#pragma once

#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/coupling/study_load.h"

#include <memory>

namespace stemware::test
{

/// A study with its foot, its load and its terminal spin. Throws what these throw.
struct SolvedStudy
{
  explicit SolvedStudy(const pipeline::Study &given)
      : study(given)
      , foot(pipeline::study_foot(study, cache))
      , shared_load(pipeline::find_load(study, foot))
      , load(*shared_load)
  {
    pipeline::SpinQuestion question = pipeline::spin_question(study);
    question.with_minima = false;
    row = pipeline::spin_row(load, question);
  }

  double omega() const { return row.terminal->omega; }

  pipeline::Study study;
  fem::ComplianceCache cache;
  std::shared_ptr<pipeline::ElasticFoot> foot;
  pipeline::SharedLoad shared_load;
  const pipeline::BalancedLoad &load;
  pipeline::SpinRow row;
};

} // namespace stemware::test
