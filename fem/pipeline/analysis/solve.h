#pragma once

#include "fem/pipeline/analysis/variant.h"
#include "fem/pipeline/base/progress.h"
#include "fem/pipeline/coupling/elastic_foot.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Maker of the feet of variants, threads to solve them, and progress; no effect on results. One caller at a
/// time.
struct Executor
{
  using Work = std::function<void(std::size_t)>;

  /// Creates an executor with one thread. @p progress must outlive the executor.
  explicit Executor(FootMaker make_foot, Progress &progress = silent_progress())
      : make_foot(std::move(make_foot))
      , progress(progress)
  {
  }

  /// Calls @p work(i) for every i < @p n, in parallel unless @p sequential, started in order; waits for all.
  /// After an exception no further call starts, and the exception of the smallest i is rethrown. Parallel
  /// loops within @p work may use idle threads.
  void for_each(std::size_t n, const Work &work, bool sequential = false) const
  {
    if (run_in_parallel && !sequential)
      return run_in_parallel(n, work);
    for (std::size_t i = 0; i < n; ++i)
      work(i);
  }

  FootMaker make_foot;
  Progress &progress;
  /// True if every failure affects its own variant only. On several ranks this holds for
  /// is_variant_failure(), which occurs on all ranks; other failures end the work.
  bool keeps_all_failures = true;

protected:
  /// for_each() on several threads; empty: one thread.
  std::function<void(std::size_t n, const Work &work)> run_in_parallel;
};

/// Answer to a variant, or its failure.
template <typename Answer>
struct Solved
{
  std::optional<Answer> answer = {};
  std::exception_ptr failure = nullptr;

  /// Returns the answer, or throws the failure.
  const Answer &value() const
  {
    if (failure)
      std::rethrow_exception(failure);
    return *answer;
  }
};

/// Returns true for bad input, and for a contact or a balance that does not exist: the variant has no value.
bool is_variant_failure(const std::exception &failure);

/// Returns true if @p failure, of a contact or of a balance at one spin, means that the glass tips.
bool is_tipping(const std::exception &failure);

/// Study on its foot, with the executor that solves its variants. Study and executor must outlive the
/// analysis.
struct Analysis
{
  const Study &study;
  std::shared_ptr<ElasticFoot> foot; ///< study_foot() of the study; nullptr for a load without a contact
  const Executor &executor;

  /// Returns the study itself as a variant.
  Variant own() const { return { foot ? foot->specification() : FootSpecification(study) }; }
};

/// Returns the foot of @p variant: a clone of @p foot, the study's foot, if the variant uses it; else a new
/// foot, with initial guesses predicted from @p foot, if given, and its rings for Shared::rings. Throws
/// ring::Tipping if the variant tips at rest, and BadInput if it is not to be solved or if its foot cannot be
/// made (mesh, factorisation).
std::shared_ptr<ElasticFoot> foot_of(const Variant &variant, const std::shared_ptr<ElasticFoot> &foot,
                                     const Executor &executor);

/// Returns the relative cost of @p variant, used to start expensive variants first.
inline std::pair<int, unsigned int> cost_of(const Variant &variant)
{
  return { (variant.shared > Shared::rings ? 0 : 1) + (variant.study.table.is_hard() ? 2 : 0),
           variant.study.contact.degree + variant.discretisation.halvings_beyond_zone };
}

/// Returns a callback that reports the number of finished @p pieces of @p n_all to @p progress.
inline auto counting_callback(Progress &progress, const std::string &pieces, std::size_t n_all)
{
  return [&progress, pieces, n_all, n_done = std::size_t(0)](std::size_t, const auto &) mutable
  { progress.pieces_done(pieces, ++n_done, n_all); };
}

/// Calls @p question(variant, its foot) for each of @p variants (Variant or a derived type), in any order or
/// in parallel; collective feet one after another. Initial guesses come from @p foot, never from another
/// variant, so that answers depend on the list only. @p done(i, solved) is called after each, one at a time;
/// its exceptions end the work.
template <typename AnyVariant, typename Question, typename Done>
auto solve(const std::vector<AnyVariant> &variants, const std::shared_ptr<ElasticFoot> &foot,
           const Question &question, const Executor &executor, Done done)
{
  using Answer = decltype(question(variants[0], foot));
  std::vector<Solved<Answer>> solved(variants.size());
  std::mutex mutex;
  const auto solve_one = [&](std::size_t i)
  {
    try
    {
      solved[i].answer = question(variants[i], foot_of(variants[i], foot, executor));
    }
    catch (const std::exception &failure)
    {
      if (!executor.keeps_all_failures && !is_variant_failure(failure))
        throw;
      solved[i].failure = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(mutex);
    done(i, solved[i]);
  };
  std::vector<std::size_t> order(variants.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  // Expensive variants start first, so that others are solved in parallel with them.
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t one, std::size_t other)
                   { return cost_of(variants[one]) > cost_of(variants[other]); });
  const bool is_collective = std::any_of(
    variants.begin(), variants.end(), [](const Variant &variant) { return variant.study.is_collective(); });
  executor.for_each(
    order.size(), [&](std::size_t i) { solve_one(order[i]); }, is_collective);
  return solved;
}

} // namespace stemware::pipeline
