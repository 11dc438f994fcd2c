// Random studies with contact problems that are difficult for Newton's method.
#include "fem/contact/hard_interface.h"
#include "fem/contact/rough_interface.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "tests/fem/revolution/revolution_case.h"

#include <gtest/gtest.h>

#include <vector>

using namespace stemware::revolution_tests;

namespace
{

using Interface = std::shared_ptr<const InterfaceLaw>;

Interface winkler(double modulus)
{
  return std::make_shared<WinklerInterface>(modulus);
}
Interface rough(double reference_pressure, double decay_length)
{
  return std::make_shared<RoughInterface>(reference_pressure, decay_length);
}
Interface hard()
{
  return std::make_shared<HardInterface>();
}

struct RandomStudy
{
  unsigned int number;
  double mass; ///< [kg]
  GlassProfile profile;
  ElasticMaterial glass;
  Table table;
  std::vector<WavinessHarmonic> waviness;
  double friction_coefficient; ///< of the friction that deforms the foot; 0: none
  unsigned int degree;
  std::vector<double> moment_ratios = { 0.3, 0.9, 1.5 };
};

const RandomStudy random_studies[] = {
  { 7,
    0.380165,
    { GlassShape::foot, 0.0330913, 0.0405269, 0.00266522, 0.0055475, 0.000763414, 0.00792567, 0.0074774,
      0.0400448, 0.000848055, 0.000859881, 0 },
    { 9.12543e+10, 0.11249 },
    { winkler(4.65528e+12), {} },
    {},
    0.202187,
    2 },
  { 92,
    1.31587,
    { GlassShape::step, 0.043451, 0.0479878, 0.00350395, 0.00453679, 0.0017974, 0.00561108, 0.00470149,
      0.0317336, 0.003, 0.0015, 0.005 },
    { 1.65554e+09, 0.185656 },
    { rough(1.09776e+07, 1.13694e-07), {} },
    {},
    0,
    2 },
  { 9,
    0.24878,
    { GlassShape::foot, 0.0266311, 0.0286601, 0.00491078, 0.000780154, 0.000317422, 0.011262, 0.00524983,
      0.00645202, 0.000707376, 0.0028878, 0.00410753 },
    { 6.8883e+10, 0.0914012 },
    { hard(), {} },
    {},
    0,
    3 },
  { 6,
    0.0801788,
    { GlassShape::foot, 0.023818, 0.0283417, 0.00198768, 0.0012212, 0.00040668, 0.0180924, 0.00753937,
      0.0225505, 0.00398692, 0.00260073, 0.0046597 },
    { 1.8959e+09, 0.281746 },
    { hard(), Substrate{ { 0.122413, 0.0228615 }, { 2.1e+11, 0.3 } } },
    {},
    1.03366,
    2 },
  { 22,
    0.109653,
    { GlassShape::foot, 0.0423454, 0.0467776, 0.00501288, 0.00182433, 0.000802429, 0.00206759, 0.00700729,
      0.0147562, 0.00130124, 0.00184254, 0 },
    { 6.41801e+10, 0.0635669 },
    { rough(8.22316e+07, 1.30801e-07), {} },
    { { 4, 3.09e-06, 1.73 } },
    0.0323423,
    2 },
  { 130,
    0.293192,
    { GlassShape::foot, 0.0421377, 0.0471537, 0.00230189, 0.00240317, 0.00033139, 0.019047, 0.00761733,
      0.00684685, 0.00300338, 0.00257085, 0 },
    { 1.41944e+09, 0.297629 },
    { hard(), Substrate{ { 0.219167, 0.0552764 }, { 1e+10, 0.3 } } },
    {},
    0.0252862,
    2,
    { 1.98888 } },
  { 128,
    0.743534,
    { GlassShape::step, 0.0588548, 0.0592899, 0.00747321, 0.000725217, 0.000792951, 0.00127972, 0.00681094,
      0.0408653, 0.003, 0.0015, 0.005 },
    { 3.25761e+09, 0.124045 },
    { hard(), {} },
    { { 2, 7.08e-06, 1.93 } },
    0.0659479,
    2,
    { 0 } }
};

class DifficultContact : public testing::TestWithParam<RandomStudy>
{
};

void PrintTo(const RandomStudy &study, std::ostream *stream)
{
  *stream << "study " << study.number;
}

INSTANTIATE_TEST_SUITE_P(Review, DifficultContact, testing::ValuesIn(random_studies),
                         [](const auto &info) { return std::to_string(info.param.number); });

} // namespace

TEST_P(DifficultContact, ConvergesUnderEveryMoment)
{
  const RandomStudy &study = GetParam();
  const double force = study.mass * 9.81;
  RevolutionSetup setup;
  setup.profile = study.profile;
  setup.material = study.glass;
  setup.table = study.table;
  setup.imperfection.table = study.waviness;
  setup.friction_coefficient = study.friction_coefficient;
  setup.meridian.degree = study.degree;
  MeshedRevolutionFoot foot(setup.resolved_for(force));
  // The projection onto two rings preserves force and moment exactly.
  const double radius = study.profile.contact_radius;
  const std::vector<double> rings = { 0.95 * radius, 1.05 * radius };
  for (const double m : study.moment_ratios)
    for (const double spin_per_speed :
         study.friction_coefficient > 0 ? std::vector<double>{ 0, -8 } : std::vector<double>{ 0 })
    {
      SCOPED_TRACE("moment ratio " + std::to_string(m));
      const double moment = m * force * radius / 2;
      const ContactState state =
        foot.solve({ force, 0.8 * moment, -0.6 * moment }, { spin_per_speed, { 0, 0.7 } });
      const ContactLoad load = foot.project_onto_rings(state, rings, 8);
      EXPECT_NEAR(load.normal_force() / force, 1, 1e-9);
      EXPECT_NEAR(load.moment().x() / (0.8 * moment + (m == 0)), m > 0, 1e-8);
      EXPECT_LT(state.solution.equilibrium_residual, 1e-9);
      EXPECT_LE(state.solution.n_iterations, 40u);
    }
}
