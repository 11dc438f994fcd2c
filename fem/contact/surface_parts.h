#pragma once

#include <Eigen/Core>

#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace stemware::fem
{

/// How the ranks that share a contact surface bring numbers together. All of them call a function at once.
class PartsExchange
{
public:
  virtual ~PartsExchange() = default;

  /// Replaces each of @p n @p values by its sum over the parts, the same on all of them to the last bit.
  virtual void sum(double *values, std::size_t n) const = 0;
  virtual double max(double value) const = 0;
  /// The @p values of all parts one after the other: on all of them if @p everywhere, else on the first, and
  /// nothing on the others.
  virtual std::vector<double> gather(const std::vector<double> &values, bool everywhere) const = 0;
};

/// Sums, extremes and lists of numbers on a whole contact surface of which each rank may have a part. By
/// default the surface is in one piece, and all functions give back what they are given.
class SurfaceParts
{
public:
  SurfaceParts() = default;
  explicit SurfaceParts(std::shared_ptr<const PartsExchange> exchange)
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
  /// The greatest of the entries; minus infinity where no part has one.
  template <typename Derived>
  double greatest(const Eigen::DenseBase<Derived> &part) const
  {
    return max(part.size() > 0 ? double(part.maxCoeff()) : -std::numeric_limits<double>::infinity());
  }

  std::vector<double> gather(std::vector<double> values) const
  {
    return exchange ? exchange->gather(values, false) : values;
  }
  std::vector<double> gather_everywhere(std::vector<double> values) const
  {
    return exchange ? exchange->gather(values, true) : values;
  }

private:
  void add_up(double *values, std::size_t n) const
  {
    if (exchange)
      exchange->sum(values, n);
  }

  std::shared_ptr<const PartsExchange> exchange;
};

} // namespace stemware::fem
