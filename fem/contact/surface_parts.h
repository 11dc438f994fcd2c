#pragma once

#include <Eigen/Core>

#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace stemware::fem
{

/// Communication between the ranks that share a contact surface. All ranks call a function together.
class SurfaceCommunicator
{
public:
  virtual ~SurfaceCommunicator() = default;

  /// Replaces each of @p n @p values by its sum over the parts, identical on all ranks to the last bit.
  virtual void sum(double *values, std::size_t n) const = 0;
  virtual double max(double value) const = 0;
  /// Concatenates the @p values of all parts, on all ranks if @p everywhere, else on the first rank.
  virtual std::vector<double> gather(const std::vector<double> &values, bool everywhere) const = 0;
};

/// Sums, extremes and lists over a contact surface that may be distributed over ranks. Default: one part.
class SurfaceParts
{
public:
  SurfaceParts() = default;
  explicit SurfaceParts(std::shared_ptr<const SurfaceCommunicator> exchange)
      : exchange(std::move(exchange))
  {
  }

  double sum(double value) const
  {
    add_up(&value, 1);
    return value;
  }
  unsigned int sum(std::size_t count) const
  {
    return static_cast<unsigned int>(sum(static_cast<double>(count)));
  }
  template <typename Derived>
  typename Derived::PlainObject sum(const Eigen::DenseBase<Derived> &part) const
  {
    typename Derived::PlainObject whole = part;
    add_up(whole.data(), static_cast<std::size_t>(whole.size()));
    return whole;
  }
  void sum_in_place(std::vector<double> &values) const { add_up(values.data(), values.size()); }

  double max(double value) const { return exchange ? exchange->max(value) : value; }
  double min(double value) const { return -max(-value); }
  bool any(bool condition) const { return max(condition ? 1 : 0) > 0; }
  /// Returns the largest entry of all parts; minus infinity without entries.
  template <typename Derived>
  double max_entry(const Eigen::DenseBase<Derived> &part) const
  {
    return max(part.size() > 0 ? double(part.maxCoeff()) : -std::numeric_limits<double>::infinity());
  }

  std::vector<double> gather(const std::vector<double> &values) const
  {
    return exchange ? exchange->gather(values, false) : values;
  }
  std::vector<double> all_gather(const std::vector<double> &values) const
  {
    return exchange ? exchange->gather(values, true) : values;
  }

private:
  void add_up(double *values, std::size_t n) const
  {
    if (exchange)
      exchange->sum(values, n);
  }

  std::shared_ptr<const SurfaceCommunicator> exchange;
};

} // namespace stemware::fem
