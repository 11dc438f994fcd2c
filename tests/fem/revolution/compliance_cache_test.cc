// Feet that share their compliances: computed once, for all threads, and with the same digits.
#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/revolution_foot.h"
#include "tests/fem/revolution/revolution_case.h"

#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <thread>

using namespace stemware::revolution_tests;

namespace
{

/// A small problem: one harmonic beyond the mean.
MeridianOptions quick_options()
{
  MeridianOptions options;
  options.degree = 1;
  options.n_harmonics = 1;
  return options;
}

std::shared_ptr<const ContactCompliance> foot_of(ComplianceStore &store, const GlassProfile &profile,
                                                 const ElasticMaterial &material,
                                                 const MeridianOptions &options)
{
  dealii::Triangulation<2> mesh;
  make_meridian_mesh(profile, {}, mesh);
  return store.get(mesh, material, options);
}

TEST(ComplianceStore, ComputesWhatItIsAskedForOnce)
{
  ComplianceStore store;
  const auto first = foot_of(store, {}, {}, quick_options());
  EXPECT_EQ(foot_of(store, {}, {}, quick_options()), first);
  EXPECT_EQ(store.n_computed(), 1u);

  dealii::Triangulation<2> mesh;
  make_meridian_mesh(GlassProfile(), {}, mesh);
  const ContactCompliance alone = compute_compliance(mesh, {}, quick_options());
  EXPECT_EQ(first->harmonics[1].normal, alone.harmonics[1].normal);
  EXPECT_EQ(first->harmonics[1].azimuthal, alone.harmonics[1].azimuthal);
}

TEST(ComplianceStore, TellsApartWhateverTheComplianceDependsOn)
{
  ComplianceStore store;
  const auto standard = foot_of(store, {}, {}, quick_options());
  GlassProfile thicker;
  thicker.foot_thickness *= 1 + 1e-15;
  GlassProfile wider;
  wider.foot_radius += 1e-3;
  ElasticMaterial stiffer;
  stiffer.young_modulus *= 2;
  ElasticMaterial rubbery;
  rubbery.poisson_ratio = 0.4;
  MeridianOptions finer = quick_options();
  finer.degree = 2;
  MeridianOptions longer = quick_options();
  longer.n_harmonics = 2;
  EXPECT_NE(foot_of(store, thicker, {}, quick_options()), standard);
  EXPECT_NE(foot_of(store, wider, {}, quick_options()), standard);
  EXPECT_NE(foot_of(store, {}, rubbery, quick_options()), standard);
  EXPECT_NE(foot_of(store, {}, {}, finer), standard);
  EXPECT_NE(foot_of(store, {}, {}, longer), standard);
  const auto stiff = foot_of(store, {}, stiffer, quick_options());
  EXPECT_EQ(store.n_computed(), 7u);
  // Displacements are inverse to Young's modulus.
  EXPECT_TRUE((2 * stiff->harmonics[0].normal).isApprox(standard->harmonics[0].normal, 1e-12));
}

TEST(ComplianceStore, ThreadsThatAskAtOnceShareOneComputation)
{
  ComplianceStore store;
  std::vector<std::shared_ptr<const ContactCompliance>> found(8);
  std::vector<std::thread> threads;
  for (auto &compliance : found)
    threads.emplace_back([&] { compliance = foot_of(store, {}, {}, quick_options()); });
  for (std::thread &thread : threads)
    thread.join();
  EXPECT_EQ(store.n_computed(), 1u);
  for (const auto &compliance : found)
    EXPECT_EQ(compliance, found.front());
}

TEST(ComplianceStore, ForgetsWhatHasNotBeenUsedForLongest)
{
  const unsigned int n_nodes =
    foot_of(*std::make_unique<ComplianceStore>(), {}, {}, quick_options())->n_nodes();
  ComplianceStore store(2 * (2 * 3 * n_nodes * n_nodes * sizeof(double))); // room for two
  const auto with_modulus = [&](double modulus) {
    return foot_of(store, {}, { modulus, 0.22 }, quick_options());
  };
  with_modulus(1e9);
  const auto second = with_modulus(2e9);
  with_modulus(1e9);
  with_modulus(3e9); // the one of 2e9 goes
  with_modulus(1e9);
  EXPECT_EQ(store.n_computed(), 3u);
  EXPECT_NE(with_modulus(2e9), second);
  EXPECT_EQ(store.n_computed(), 4u);
}

TEST(ComplianceStore, FailuresReachEverybodyWhoAsks)
{
  ComplianceStore store;
  const ElasticMaterial impossible = { 70e9, 0.7 };
  EXPECT_THROW(foot_of(store, {}, impossible, quick_options()), std::invalid_argument);
  EXPECT_THROW(foot_of(store, {}, impossible, quick_options()), std::invalid_argument);
}

TEST(ComplianceStore, FeetThatShareAnswerLikeFeetThatDoNot)
{
  ComplianceStore store;
  RevolutionSetup setup;
  setup.support = TableSupport::elastic;
  setup.meridian = quick_options();
  setup.resolution.focus_levels = 1;
  FootResponse alone(setup);
  FootResponse sharing(setup, store);
  FootResponse sharing_too(setup, store);
  EXPECT_EQ(store.n_computed(), 2u); // foot and disc
  const ContactLoad load = { weight, 0, -0.3 * weight * 0.015 };
  const LoadHarmonics expected = alone.press(load);
  EXPECT_EQ(sharing.press(load).a, expected.a);
  EXPECT_EQ(sharing_too.press(load).a, expected.a);
}

} // namespace
