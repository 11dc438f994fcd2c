#pragma once

#include "fem/pipeline/analysis/study_rows.h"
#include "tests/fem/pipeline/mat_study.h"

namespace stemware::test
{

inline ring::RingStack rich_load()
{
  return { { 0.47, 0.1, 0.09, 0, -0.02, 0, 0.004, 0, -0.001, 0 },
           { 0, -0.3, 0, 0.04, 0, 0.01, 0, -0.003, 0, 0.001 },
           0.03 };
}

inline pipeline::Study study_of_given_load()
{
  pipeline::Study study = mat_study();
  study.motion.end_time = 0.5;
  study.load.source = pipeline::LoadSource::file;
  study.load.coupling = pipeline::LoadCoupling::one_way;
  return study;
}

/// Returns a study with few azimuth lines and harmonics, whose contact is solved in milliseconds.
inline pipeline::Study quick_contact_study()
{
  pipeline::Study study = mat_study();
  study.motion.end_time = 0.2;
  study.contact.harmonics = 4;
  study.contact.azimuth_lines = 32;
  study.contact.load_harmonics = 8;
  return study;
}

/// Returns a flat land on a mat in full contact, without deformation by friction. Its pressure has no
/// harmonics above the first (docs/theory/load_models.md).
inline pipeline::Study flat_land_on_a_mat(pipeline::LoadCoupling coupling)
{
  pipeline::Study study = quick_contact_study();
  study.glass.profile.crown_radius = 0;
  study.motion.orbit.centre_of_mass_height = 0.06; // moment ratio 0.34
  study.contact.friction_coupling = pipeline::FrictionCoupling::none;
  study.load.coupling = coupling;
  return study;
}

} // namespace stemware::test
