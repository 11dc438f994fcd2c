// Fields of a solid foot for ParaView.
#include "fem/contact/foot.h"
#include "fem/solid/solid_system.h"

#include <deal.II/base/mpi.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <sstream>
#include <string>
#include <vector>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Stress of isotropic elasticity from displacement gradients [Pa].
class Stress : public DataPostprocessorTensor<3>
{
public:
  explicit Stress(const ElasticMaterial &material)
      : DataPostprocessorTensor<3>("stress", update_gradients)
      , material(material)
  {
  }

  void evaluate_vector_field(const DataPostprocessorInputs::Vector<3> &input,
                             std::vector<Vector<double>> &stresses) const override
  {
    for (unsigned int p = 0; p < input.solution_gradients.size(); ++p)
    {
      const auto &gradient = input.solution_gradients[p];
      const double divergence = gradient[0][0] + gradient[1][1] + gradient[2][2];
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          stresses[p](Tensor<2, 3>::component_to_unrolled_index(TableIndices<2>(i, j))) =
            material.shear_modulus() * (gradient[i][j] + gradient[j][i]) +
            (i == j ? material.lame_lambda() * divergence : 0);
    }
  }

private:
  const ElasticMaterial material;
};

/// Strain from displacement gradients.
class Strain : public DataPostprocessorTensor<3>
{
public:
  Strain()
      : DataPostprocessorTensor<3>("strain", update_gradients)
  {
  }

  void evaluate_vector_field(const DataPostprocessorInputs::Vector<3> &input,
                             std::vector<Vector<double>> &strains) const override
  {
    for (unsigned int p = 0; p < input.solution_gradients.size(); ++p)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          strains[p](Tensor<2, 3>::component_to_unrolled_index(TableIndices<2>(i, j))) =
            (input.solution_gradients[p][i][j] + input.solution_gradients[p][j][i]) / 2;
  }
};

/// Stress of von Mises from displacement gradients [Pa].
class VonMises : public DataPostprocessorScalar<3>
{
public:
  explicit VonMises(const ElasticMaterial &material)
      : DataPostprocessorScalar<3>("von_mises_stress", update_gradients)
      , material(material)
  {
  }

  void evaluate_vector_field(const DataPostprocessorInputs::Vector<3> &input,
                             std::vector<Vector<double>> &stresses) const override
  {
    for (unsigned int p = 0; p < input.solution_gradients.size(); ++p)
    {
      SymmetricTensor<2, 3> strain;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j)
          strain[i][j] = (input.solution_gradients[p][i][j] + input.solution_gradients[p][j][i]) / 2;
      stresses[p](0) = 2 * material.shear_modulus() * std::sqrt(1.5) * deviator(strain).norm();
    }
  }

private:
  const ElasticMaterial material;
};

/// The vertical component of a vector field whose other two are not used: a scalar that lives on the contact
/// nodes.
class ContactPressure : public DataPostprocessorScalar<3>
{
public:
  ContactPressure()
      : DataPostprocessorScalar<3>("contact_pressure", update_values)
  {
  }

  void evaluate_vector_field(const DataPostprocessorInputs::Vector<3> &input,
                             std::vector<Vector<double>> &pressures) const override
  {
    for (unsigned int p = 0; p < input.solution_values.size(); ++p)
      pressures[p](0) = input.solution_values[p](2);
  }
};

/// The table's motion given back to the glass: q0 + q1 x + q2 y upward, and what a small rotation does to the
/// rest.
class RestoredMotion : public DataPostprocessorVector<3>
{
public:
  explicit RestoredMotion(const Eigen::Vector3d &motion)
      : DataPostprocessorVector<3>("displacement", update_values | update_quadrature_points)
      , motion(motion)
  {
  }

  void evaluate_vector_field(const DataPostprocessorInputs::Vector<3> &input,
                             std::vector<Vector<double>> &displacements) const override
  {
    for (unsigned int p = 0; p < input.solution_values.size(); ++p)
    {
      const Point<3> &x = input.evaluation_points[p];
      displacements[p](0) = input.solution_values[p](0) - motion(1) * x[2];
      displacements[p](1) = input.solution_values[p](1) - motion(2) * x[2];
      displacements[p](2) = input.solution_values[p](2) + motion(0) + motion(1) * x[0] + motion(2) * x[1];
    }
  }

private:
  const Eigen::Vector3d motion;
};

std::string vtu_text(const DataOut<3> &data_out)
{
  std::ostringstream text;
  data_out.write_vtu(text);
  return text.str();
}

std::string name_of_piece(unsigned int rank)
{
  return "contact_" + std::to_string(rank) + ".vtu";
}

/// @p record without the comment in which deal.II puts the time: equal runs give equal files.
std::string without_comment(std::string record)
{
  const std::string begin = "<!--", end = "-->\n";
  const std::size_t first = record.find(begin);
  if (first != std::string::npos)
    record.erase(first, record.find(end, first) + end.size() - first);
  return record;
}

/// Files that this rank has to write of a picture that several ranks have parts of. A rank without cells
/// writes no piece, which ParaView could not read.
std::vector<FieldFile> pieces_on_ranks(const DataOut<3> &data_out, bool has_cells,
                                       const MPI_Comm &communicator)
{
  std::vector<FieldFile> files;
  if (has_cells)
    files.push_back({ name_of_piece(Utilities::MPI::this_mpi_process(communicator)), vtu_text(data_out) });
  const std::vector<bool> have_cells = Utilities::MPI::gather(communicator, has_cells);
  std::vector<std::string> pieces;
  for (unsigned int rank = 0; rank < have_cells.size(); ++rank) // none but on the first
    if (have_cells[rank])
      pieces.push_back(name_of_piece(rank));
  if (!pieces.empty())
  {
    std::ostringstream record;
    data_out.write_pvtu_record(record, pieces);
    files.push_back({ "contact.pvtu", without_comment(record.str()) });
  }
  return files;
}

} // namespace

std::vector<FieldFile> SolidBody::fields(const Eigen::Vector3d &motion,
                                         const Eigen::VectorXd &nodal_pressure) const
{
  const DoFHandler<3> &dof_handler = system->dofs();
  const LinearAlgebra::distributed::Vector<double> displacement = system->displacement_for_output();
  LinearAlgebra::distributed::Vector<double> pressure;
  pressure.reinit(displacement);
  const ContactNodes &nodes = *system->contact_zone().nodes;
  for (unsigned int i = 0; i < nodes.n_own_nodes(); ++i)
    pressure(nodes.dofs()[i]) = nodal_pressure(i);
  pressure.update_ghost_values();

  const RestoredMotion restored(motion);
  const Stress stress(system->glass());
  const Strain strain;
  const VonMises von_mises(system->glass());
  const ContactPressure contact_pressure;
  DataOut<3> data_out;
  DataOutBase::VtkFlags flags;
  flags.write_higher_order_cells = dof_handler.get_fe().degree > 1;
  flags.compression_level = decltype(flags.compression_level)::best_speed;
  flags.print_date_and_time = false; // equal runs give equal files
  data_out.set_flags(flags);
  data_out.add_data_vector(dof_handler, displacement, restored);
  data_out.add_data_vector(dof_handler, displacement, stress);
  data_out.add_data_vector(dof_handler, displacement, strain);
  data_out.add_data_vector(dof_handler, displacement, von_mises);
  data_out.add_data_vector(dof_handler, pressure, contact_pressure);
  data_out.build_patches(system->mapping(), dof_handler.get_fe().degree, DataOut<3>::curved_inner_cells);
  const MPI_Comm &communicator = dof_handler.get_communicator();
  if (Utilities::MPI::n_mpi_processes(communicator) == 1)
    return { { "contact.vtu", vtu_text(data_out) } };
  bool has_cells = false;
  for (const auto &cell : dof_handler.active_cell_iterators())
    has_cells = has_cells || cell->is_locally_owned();
  return pieces_on_ranks(data_out, has_cells, communicator);
}

} // namespace stemware::fem
