#include "fem/contact/foot.h"
#include "fem/solid/solid_body.h"

#include <deal.II/base/mpi.h>
#include <deal.II/grid/filtered_iterator.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/stream.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace stemware::fem
{

using namespace dealii;

namespace
{

using Interpretation = DataComponentInterpretation::DataComponentInterpretation;

/// Output fields: elastic displacement relative to the stem's cut [m]; rigid motion of the glass [m] (upward
/// q0 + q1 x + q2 y, and the horizontal part of this small rotation); stress [Pa]; elastic strain; von Mises
/// stress [Pa].
class GlassFields : public DataPostprocessor<3>
{
public:
  GlassFields(const ElasticMaterial &material, const Eigen::Vector3d &motion)
      : material(material)
      , motion(motion)
  {
  }

  std::vector<std::string> get_names() const override
  {
    return of_each<std::string>("displacement", "rigid_motion", "stress", "strain", "von_mises_stress");
  }

  std::vector<Interpretation> get_data_component_interpretation() const override
  {
    using namespace DataComponentInterpretation;
    return of_each<Interpretation>(component_is_part_of_vector, component_is_part_of_vector,
                                   component_is_part_of_tensor, component_is_part_of_tensor,
                                   component_is_scalar);
  }

  UpdateFlags get_needed_update_flags() const override
  {
    return update_values | update_gradients | update_quadrature_points;
  }

  void evaluate_vector_field(const DataPostprocessorInputs::Vector<3> &input,
                             std::vector<Vector<double>> &fields) const override
  {
    const double lambda = material.lame_lambda(), shear = material.shear_modulus();
    for (unsigned int p = 0; p < input.solution_values.size(); ++p)
    {
      const Point<3> &x = input.evaluation_points[p];
      const auto &displacement = input.solution_values[p];
      const auto &gradient = input.solution_gradients[p];
      Vector<double> &field = fields[p];
      for (unsigned int i = 0; i < 3; ++i)
        field(i) = displacement(i);
      field(first_of_motion) = -motion(1) * x[2];
      field(first_of_motion + 1) = -motion(2) * x[2];
      field(first_of_motion + 2) = motion(0) + motion(1) * x[0] + motion(2) * x[1];
      const double divergence = gradient[0][0] + gradient[1][1] + gradient[2][2];
      SymmetricTensor<2, 3> strain;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
        {
          const double both = gradient[i][j] + gradient[j][i];
          strain[i][j] = both / 2;
          field(first_of_stress + 3 * i + j) = shear * both + (i == j ? lambda * divergence : 0);
          field(first_of_strain + 3 * i + j) = both / 2;
        }
      field(place_of_von_mises) = 2 * shear * std::sqrt(1.5) * deviator(strain).norm();
    }
  }

private:
  static constexpr unsigned int first_of_motion = 3, first_of_stress = 6, first_of_strain = 15,
                                place_of_von_mises = 24;

  template <typename Word>
  static std::vector<Word> of_each(Word displacement, Word rigid_motion, Word stress, Word strain,
                                   Word von_mises)
  {
    std::vector<Word> words(first_of_motion, displacement);
    words.resize(first_of_stress, rigid_motion);
    words.resize(first_of_strain, stress);
    words.resize(place_of_von_mises, strain);
    words.push_back(von_mises);
    return words;
  }

  const ElasticMaterial material;
  const Eigen::Vector3d motion;
};

/// Scalar field on the contact nodes, stored as the vertical component of a vector field.
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

/// Output of this rank's cells, written piece by piece, because all cells at once would need more memory than
/// the system of equations.
class Picture : public DataOut<3>
{
public:
  Picture(const Mapping<3> &mapping, const DoFHandler<3> &dof_handler)
      : mapping(mapping)
      , dof_handler(dof_handler)
  {
    flags.write_higher_order_cells = dof_handler.get_fe().degree > 1;
    flags.compression_level = decltype(flags.compression_level)::best_speed;
    flags.print_date_and_time = false; // for reproducible files
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        cells.push_back(cell->active_cell_index());
  }

  bool has_cells() const { return !cells.empty(); }

  /// Returns the text of the .vtu file. Memory is reserved for uncompressed numbers, because a growing string
  /// would hold its old buffer and a buffer of twice the size while it copies.
  std::string vtu_text()
  {
    constexpr std::size_t n_bytes_a_node = 200, n_cells_a_piece = 2000;
    std::string text;
    text.reserve(n_bytes_a_node * cells.size() * dof_handler.get_fe().n_dofs_per_cell() / 3);
    boost::iostreams::stream<boost::iostreams::back_insert_device<std::string>> stream(
      boost::iostreams::back_inserter(text));
    DataOutBase::write_vtu_header(stream, flags);
    for (std::size_t first = 0; first < cells.size(); first += n_cells_a_piece)
    {
      const unsigned int from = cells[first], to = cells[std::min(first + n_cells_a_piece, cells.size()) - 1];
      const auto is_in_piece = [from, to](const cell_iterator &cell)
      {
        return cell->is_active() && cell->is_locally_owned() && cell->active_cell_index() >= from &&
               cell->active_cell_index() <= to;
      };
      set_cell_selection(FilteredIterator<cell_iterator>(is_in_piece));
      build_patches(mapping, dof_handler.get_fe().degree, curved_inner_cells);
      DataOutBase::write_vtu_main(get_patches(), get_dataset_names(), get_nonscalar_data_ranges(), flags,
                                  stream);
    }
    DataOutBase::write_vtu_footer(stream);
    stream.flush();
    return text;
  }

private:
  const Mapping<3> &mapping;
  const DoFHandler<3> &dof_handler;
  DataOutBase::VtkFlags flags;
  std::vector<unsigned int> cells;
};

std::string name_of_piece(unsigned int rank)
{
  return "contact_" + std::to_string(rank) + ".vtu";
}

/// Returns @p record without deal.II's comment with the time, so that files are reproducible.
std::string without_comment(std::string record)
{
  const std::string begin = "<!--", end = "-->\n";
  const std::size_t first = record.find(begin);
  if (first != std::string::npos)
    record.erase(first, record.find(end, first) + end.size() - first);
  return record;
}

/// Returns the files of this rank. A rank without cells has no file, because ParaView rejects empty pieces.
std::vector<FieldFile> pieces_on_ranks(Picture &picture, const MPI_Comm &communicator)
{
  std::vector<FieldFile> files;
  if (picture.has_cells())
    files.push_back({ name_of_piece(Utilities::MPI::this_mpi_process(communicator)), picture.vtu_text() });
  const std::vector<bool> have_cells = Utilities::MPI::gather(communicator, picture.has_cells());
  std::vector<std::string> pieces;
  // `have_cells` is empty on every rank but the first.
  for (unsigned int rank = 0; rank < have_cells.size(); ++rank)
    if (have_cells[rank])
      pieces.push_back(name_of_piece(rank));
  if (!pieces.empty())
  {
    std::ostringstream record;
    picture.write_pvtu_record(record, pieces);
    files.push_back({ "contact.pvtu", without_comment(record.str()) });
  }
  return files;
}

} // namespace

std::vector<FieldFile> SolidBody::fields(const Eigen::Vector3d &motion,
                                         const Eigen::VectorXd &nodal_pressure) const
{
  const DoFHandler<3> &dof_handler = dofs();
  const Vector distributed = displacement_for_output();
  Vector pressure;
  pressure.reinit(distributed);
  const ContactNodes &nodes = contact.nodes();
  for (unsigned int i = 0; i < nodes.n_owned_nodes(); ++i)
    pressure(nodes.dofs()[i]) = nodal_pressure(i);
  pressure.update_ghost_values();

  const GlassFields glass_fields(glass(), motion);
  const ContactPressure contact_pressure;
  Picture picture(mesh().mapping, dof_handler);
  picture.add_data_vector(dof_handler, distributed, glass_fields);
  picture.add_data_vector(dof_handler, pressure, contact_pressure);
  const MPI_Comm &communicator = dof_handler.get_communicator();
  if (Utilities::MPI::n_mpi_processes(communicator) == 1)
    return { { "contact.vtu", picture.vtu_text() } };
  return pieces_on_ranks(picture, communicator);
}

} // namespace stemware::fem
