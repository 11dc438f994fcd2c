#include "fem/pipeline/coupling/foot_contact.h"
#include "fem/pipeline/coupling/orientation.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/ranks.h"
#include "fem/pipeline/support/text_file.h"
#include "fem/revolution/revolution_foot.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

fem::TableSupport support_of(TableKind kind)
{
  switch (kind)
  {
  case TableKind::rigid:
    return fem::TableSupport::rigid;
  case TableKind::mat:
    return fem::TableSupport::mat;
  case TableKind::rough:
    return fem::TableSupport::rough;
  case TableKind::elastic:
    return fem::TableSupport::elastic;
  }
  throw std::logic_error("a table without a support");
}

fem::RevolutionSetup setup_of(const Study &study)
{
  fem::RevolutionSetup setup;
  setup.profile = study.glass.profile;
  setup.material = study.glass.material;
  setup.support = support_of(study.table.kind);
  setup.foundation_modulus = study.table.foundation_modulus;
  setup.interface = study.table.roughness;
  setup.disc = study.table.disc;
  setup.disc_material = study.table.disc_material;
  if (study.friction_deforms_foot())
    setup.friction_coefficient = study.motion.orbit.friction_coefficient;
  setup.meridian.degree = study.contact.degree;
  setup.meridian.n_harmonics = study.contact.harmonics;
  setup.resolution.land_cells = study.contact.resolution.radial_cells;
  setup.resolution.land_grading = study.contact.land_grading;
  setup.resolution.refinements = study.contact.refinements;
  setup.n_lines = study.contact.azimuth_lines;
  setup.imperfection = imperfection_of(study);
  return setup.resolved_for(study.required_resultants().normal_force);
}

/// The points turned counter-clockwise by @p angle.
std::vector<fem::PointForce> turned(std::vector<fem::PointForce> points, double angle)
{
  for (fem::PointForce &point : points)
    point = { point.x * std::cos(angle) - point.y * std::sin(angle),
              point.x * std::sin(angle) + point.y * std::cos(angle), point.force };
  return points;
}

class RevolutionContact : public FootContact
{
public:
  RevolutionContact(const Study &study, fem::ComplianceStore &store)
      : foot(setup_of(study), store)
      , phase(phase_of_marks(study.motion.orbit, 0, 0))
  {
  }

  std::string name() const override { return "revolution"; }
  unsigned int n_unknowns() const override { return foot.body().n_unknowns(); }
  unsigned int n_contact_nodes() const override { return foot.body().contact_surface().n_nodes(); }

  FootContactResult solve(const fem::ContactLoad &load, double spin_per_speed,
                          const Progress & /*progress*/) override
  {
    FootContactResult result;
    result.load = foot.press(load, phase, spin_per_speed);
    result.solution = foot.solution();
    return result;
  }

  bool is_isotropic() const override { return foot.is_isotropic(); }

  std::vector<fem::PointForce> point_forces(const FootContactResult &result) const override
  {
    return turned(foot.law().point_forces(result.solution.approach), foot.direction());
  }
  fem::Footprint footprint(const FootContactResult &result) const override
  {
    return foot.law().footprint(result.solution.approach).turned(foot.direction());
  }

  bool write_fields(const std::string &folder, const FootContactResult & /*result*/) const override
  {
    std::ostringstream fields;
    foot.write_fields(fields);
    on_first_rank(
      [&]
      {
        write_text_file(folder + "/contact.vtu", fields.str());
        return std::string();
      });
    return true;
  }

  void turn_to(const fem::FootPhase &marks) override { phase = marks; }

private:
  fem::FootResponse foot;
  fem::FootPhase phase; ///< of the contacts to come
};

} // namespace

std::unique_ptr<FootContact> make_revolution_contact(const Study &study, fem::ComplianceStore &store)
{
  try
  {
    return std::make_unique<RevolutionContact>(study, store);
  }
  catch (const std::invalid_argument &error)
  {
    throw BadInput(error.what());
  }
}

} // namespace stemware::pipeline
