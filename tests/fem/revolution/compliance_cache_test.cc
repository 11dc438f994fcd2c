#include "fem/revolution/compliance_cache.h"
#include "tests/fem/revolution/revolution_case.h"

#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <thread>

using namespace stemware::revolution_tests;

namespace
{

MeridianOptions quick_options()
{
  MeridianOptions options;
  options.degree = 1;
  options.n_harmonics = 1;
  return options;
}

std::shared_ptr<const ContactCompliance> foot_of(ComplianceCache &cache, const GlassProfile &profile,
                                                 const ElasticMaterial &material,
                                                 const MeridianOptions &options)
{
  dealii::Triangulation<2> mesh;
  make_meridian_mesh(profile, {}, mesh);
  return cache.get(mesh, material, options);
}

TEST(ComplianceCache, ReturnsTheUncachedComplianceAndComputesItOnce)
{
  ComplianceCache cache;
  const auto first = foot_of(cache, {}, {}, quick_options());
  EXPECT_EQ(foot_of(cache, {}, {}, quick_options()), first);
  EXPECT_EQ(cache.n_computed(), 1u);

  dealii::Triangulation<2> mesh;
  make_meridian_mesh(GlassProfile(), {}, mesh);
  const ContactCompliance alone = compute_compliance(mesh, {}, quick_options());
  EXPECT_EQ(first->harmonics[1].normal, alone.harmonics[1].normal);
  EXPECT_EQ(first->harmonics[1].azimuthal, alone.harmonics[1].azimuthal);
}

TEST(ComplianceCache, DistinguishesProfilesMaterialsAndOptions)
{
  ComplianceCache cache;
  const auto standard = foot_of(cache, {}, {}, quick_options());
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
  EXPECT_NE(foot_of(cache, thicker, {}, quick_options()), standard);
  EXPECT_NE(foot_of(cache, wider, {}, quick_options()), standard);
  EXPECT_NE(foot_of(cache, {}, rubbery, quick_options()), standard);
  EXPECT_NE(foot_of(cache, {}, {}, finer), standard);
  EXPECT_NE(foot_of(cache, {}, {}, longer), standard);
  const auto stiff = foot_of(cache, {}, stiffer, quick_options());
  EXPECT_EQ(cache.n_computed(), 7u);
  // Displacements are inversely proportional to Young's modulus.
  EXPECT_TRUE((2 * stiff->harmonics[0].normal).isApprox(standard->harmonics[0].normal, 1e-11));
}

TEST(ComplianceCache, ConcurrentRequestsShareOneComputation)
{
  ComplianceCache cache;
  std::vector<std::shared_ptr<const ContactCompliance>> found(8);
  std::vector<std::thread> threads;
  for (auto &compliance : found)
    threads.emplace_back([&] { compliance = foot_of(cache, {}, {}, quick_options()); });
  for (std::thread &thread : threads)
    thread.join();
  EXPECT_EQ(cache.n_computed(), 1u);
  for (const auto &compliance : found)
    EXPECT_EQ(compliance, found.front());
}

TEST(ComplianceCache, EvictsEntriesBeyondItsCapacity)
{
  ComplianceCache cache(2);
  const auto with_modulus = [&](double modulus) {
    return foot_of(cache, {}, { modulus, 0.22 }, quick_options());
  };
  const auto first = with_modulus(1e9);
  with_modulus(2e9);
  EXPECT_EQ(with_modulus(1e9), first);
  const auto third = with_modulus(3e9); // a full cache is emptied
  EXPECT_EQ(with_modulus(3e9), third);
  EXPECT_EQ(cache.n_computed(), 3u);
  EXPECT_NE(with_modulus(1e9), first);
  EXPECT_EQ(cache.n_computed(), 4u);
}

} // namespace
