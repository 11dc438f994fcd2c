#include "fem/revolution/meridian_problem.h"

#include "fem/revolution/meridian_space.h"

#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>

namespace stemware::fem
{

using namespace dealii;

namespace
{

void solve_harmonics(const MeridianSpace &space, unsigned int n_threads,
                     std::vector<HarmonicCompliance> &harmonics)
{
  std::atomic<unsigned int> next{ 0 };
  std::vector<std::exception_ptr> errors(n_threads);
  const auto work = [&](unsigned int thread)
  {
    try
    {
      for (unsigned int n = next++; n < harmonics.size(); n = next++)
        harmonics[n] = space.compliance(n);
    }
    catch (...)
    {
      errors[thread] = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  for (unsigned int t = 1; t < n_threads; ++t)
    threads.emplace_back(work, t);
  work(0);
  for (std::thread &thread : threads)
    thread.join();
  for (const std::exception_ptr &error : errors)
    if (error)
      std::rethrow_exception(error);
}

} // namespace

ContactCompliance compute_compliance(const Triangulation<2> &triangulation, const ElasticMaterial &material,
                                     const MeridianOptions &options)
{
  material.validate();
  if (options.degree < 1 || options.degree > 4)
    throw std::invalid_argument("Degree = " + std::to_string(options.degree) +
                                " is not allowed for a body of revolution; give 1, 2, 3 or 4.");
  const MeridianSpace space(triangulation, material, options.degree);
  ContactCompliance result;
  result.degree = options.degree;
  result.n_meridian_unknowns = space.n_dofs();
  result.radii.resize(space.n_contact_nodes());
  for (unsigned int i = 0; i < space.n_contact_nodes(); ++i)
    result.radii(i) = space.contact_radius(i);
  result.harmonics.resize(options.n_harmonics + 1);
  const unsigned int allowed = options.n_threads > 0 ? options.n_threads : MultithreadInfo::n_threads();
  solve_harmonics(space, std::min(allowed, options.n_harmonics + 1), result.harmonics);
  return result;
}

} // namespace stemware::fem
