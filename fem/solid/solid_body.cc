#include "fem/solid/solid_body.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstring>

namespace stemware::fem
{

using namespace dealii;

namespace
{

std::unique_ptr<BodyStiffness> make_stiffness(const Triangulation<3> &triangulation,
                                              const ElasticMaterial &material, const SolidOptions &options)
{
  material.validate();
  const unsigned int mapping_degree = options.straight_edges ? 1 : options.degree;
  const auto hierarchy =
    std::make_shared<MeshHierarchy>(levels_of(triangulation, options.degree), mapping_degree, material);
  return std::make_unique<BodyStiffness>(hierarchy, hierarchy->n_levels() - 1, material);
}

} // namespace

SolidBody::SolidBody(const Triangulation<3> &triangulation, const ElasticMaterial &material,
                     const SolidGap &gap, const SolidOptions &options, const SolidBody *similar)
    : SolidBody(similar ? std::make_unique<BodyStiffness>(*similar->stiffness)
                        : make_stiffness(triangulation, material, options),
                gap, options.line_factor)
{
}

SolidBody::SolidBody(std::unique_ptr<BodyStiffness> of_body, const SolidGap &gap, unsigned int line_factor)
    : stiffness(std::move(of_body))
    , gap(gap)
    , line_factor(line_factor)
    , contact(stiffness->contact_nodes())
    , zone(describe_contact_zone(mesh(), contact.nodes(), gap, line_factor * default_lines_per_face))
    , horizontal(horizontal_places(mesh(), contact.nodes()))
{
  for (Vector *vector : { &displacement, &elastic_forces })
    stiffness->initialize(*vector);
  for (FloatVector &column : eliminated_border)
    column.reinit(displacement);
}

std::unique_ptr<SolidBody> SolidBody::coarser() const
{
  if (!has_coarser_mesh())
    return nullptr;
  auto body = std::make_unique<SolidBody>(stiffness->coarser(), gap, line_factor);
  body->linear_tolerance = linear_tolerance;
  body->set_sliding(sliding);
  return body;
}

void SolidBody::interpolate_from(const SolidBody &coarse)
{
  stiffness->prolongate(displacement, coarse.displacement);
  stiffness->vmult(elastic_forces, displacement);
  residual_before = 0;
  border_matters = coarse.border_matters;
  border_stiffness = coarse.border_stiffness;
  if (border_matters)
    for (unsigned int i = 0; i < 3; ++i)
      stiffness->prolongate(eliminated_border[i], coarse.eliminated_border[i]);
}

void SolidBody::set_sliding(const SlidingTraction &traction)
{
  traction.validate();
  sliding = traction;
  if (!has_friction())
    return;
  friction.resize(zone.surface.n_nodes(), 2);
  for (Eigen::Index i = 0; i < friction.rows(); ++i)
  {
    const double x = zone.surface.node_position(i, 0), y = zone.surface.node_position(i, 1);
    const double azimuth = std::atan2(y, x);
    const Eigen::Vector2d direction = traction.direction(std::hypot(x, y), azimuth);
    friction.row(i) = Eigen::Rotation2Dd(azimuth) * direction;
  }
}

SolidBody::Vector SolidBody::contact_load(const Eigen::VectorXd &forces) const
{
  Vector load;
  stiffness->initialize(load);
  const Eigen::VectorXd own = contact.nodes().summed(forces);
  for (unsigned int i = 0; i < own.size(); ++i)
    load.local_element(contact.nodes().owned_positions()[i]) = own(i);
  if (has_friction())
    for (const auto &[node, x, y] : horizontal)
    {
      load.local_element(x) += friction(node, 0) * own(node);
      load.local_element(y) += friction(node, 1) * own(node);
    }
  return load;
}

void SolidBody::set_displacement(const Vector &vector)
{
  displacement.copy_locally_owned_data_from(vector);
  stiffness->vmult(elastic_forces, displacement);
  residual_before = 0;
}

SolidBody::Vector SolidBody::residual(const Eigen::VectorXd &forces) const
{
  Vector result = contact_load(forces);
  result -= elastic_forces;
  return result;
}

void SolidBody::update(double step_length)
{
  displacement.add(step_length, increment);
  elastic_forces.add(step_length, increment_forces);
}

void SolidBody::reset()
{
  displacement = 0;
  elastic_forces = 0;
  residual_before = 0;
}

double SolidBody::equilibrium_residual(const Eigen::VectorXd &forces) const
{
  return residual(forces).l2_norm() / contact.nodes().norm(forces);
}

template <typename Body, typename Use>
void SolidBody::for_each_state(Body &body, const Use &use)
{
  for (auto *vector : { &body.displacement, &body.elastic_forces })
    use(vector->begin(), vector->locally_owned_size());
  for (auto &column : body.eliminated_border)
    use(column.begin(), column.locally_owned_size());
  use(&body.residual_before, 1);
  use(&body.border_matters, 1);
  use(&body.border_stiffness, 1);
}

std::string SolidBody::state() const
{
  std::string bytes;
  for_each_state(*this, [&](const auto *numbers, std::size_t n)
                 { bytes.append(reinterpret_cast<const char *>(numbers), n * sizeof *numbers); });
  return bytes;
}

void SolidBody::set_state(const std::string &bytes)
{
  const char *next = bytes.data();
  for_each_state(*this,
                 [&](auto *numbers, std::size_t n)
                 {
                   std::memcpy(numbers, next, n * sizeof *numbers);
                   next += n * sizeof *numbers;
                 });
}

} // namespace stemware::fem
