#include "fem/solid/contact_checkpoint.h"

#include "fem/solid/binary_stream.h"
#include "fem/solid/solid_body.h"

#include <deal.II/base/mpi.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;
namespace fs = std::filesystem;

namespace
{

bool write_file(const fs::path &path, const std::string &content)
{
  std::ofstream file(path, std::ios::binary);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  return static_cast<bool>(file.flush());
}

/// Throws std::runtime_error with @p message on all ranks unless @p holds on all of them.
void require_everywhere(bool holds, const std::string &message)
{
  if (Utilities::MPI::min(holds ? 1 : 0, MPI_COMM_WORLD) == 0)
    throw std::runtime_error(message);
}

std::string read_file(const fs::path &path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

unsigned int this_rank()
{
  return Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
}

bool is_in(const fs::path &path)
{
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

fs::path unfinished(const fs::path &path)
{
  return path.string() + ".unfinished";
}

/// Number of values that a step of Newton's method has in the file.
constexpr std::size_t n_numbers_of_step = 6;

void write_history(std::ostream &stream, const std::vector<ContactIteration> &history)
{
  for (const ContactIteration &step : history)
  {
    const double numbers[n_numbers_of_step] = { double(step.number),    double(step.n_loaded),
                                                double(step.n_changed), step.residual,
                                                step.step_length,       double(step.linear_iterations) };
    write_binary(stream, numbers, n_numbers_of_step);
  }
}

std::vector<ContactIteration> read_history(std::istream &stream, std::size_t n_steps)
{
  std::vector<ContactIteration> history;
  for (std::size_t i = 0; i < n_steps && stream; ++i)
  {
    double numbers[n_numbers_of_step] = {};
    read_binary(stream, numbers, n_numbers_of_step);
    history.push_back({ static_cast<unsigned int>(numbers[0]), static_cast<unsigned int>(numbers[1]),
                        static_cast<unsigned int>(numbers[2]), numbers[3], numbers[4],
                        static_cast<unsigned int>(numbers[5]) });
  }
  return history;
}

} // namespace

ContactCheckpoint::ContactCheckpoint(const fs::path &folder, const std::string &owner,
                                     const std::string &problem)
    : folder(folder)
{
  manifest.owner = check_sum_of(owner);
  manifest.solve = check_sum_of(problem);
  manifest.n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  // The first rank says what there is, so that all do the same.
  const std::string reason = Utilities::MPI::broadcast(MPI_COMM_WORLD, this_rank() == 0 ? trouble() : "");
  if (!reason.empty())
    throw std::invalid_argument("Contact/Checkpoint folder = " + folder.string() + " " + reason);
  is_there = Utilities::MPI::broadcast(MPI_COMM_WORLD, is_there);
  is_ours = Utilities::MPI::broadcast(MPI_COMM_WORLD, is_ours);
  if (is_there && is_ours)
    manifest =
      checkpoint_manifest_in(Utilities::MPI::broadcast(MPI_COMM_WORLD, manifest_text(manifest))).value();
}

std::string ContactCheckpoint::trouble()
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    return "cannot be made (" + error.message() + "); give a folder that can be written to.";
  const fs::path file = folder / checkpoint_manifest_name;
  const std::string rest = "; give another folder, or move that file away.";
  if (is_in(file))
  {
    const auto found = checkpoint_manifest_in(fs::is_regular_file(file, error) ? read_file(file) : "");
    if (!found)
      return std::string("holds ") + checkpoint_manifest_name +
             ", which is not of a checkpoint of this version" + rest;
    if (found->owner != manifest.owner || found->n_ranks != manifest.n_ranks)
      return "keeps the state of another study or number of ranks (" + std::to_string(found->n_ranks) +
             "); run that one to its end, give another folder, or delete this one.";
    is_there = true;
    is_ours = found->solve == manifest.solve;
    if (is_ours)
      manifest = *found;
    return "";
  }
  for (unsigned int rank = 0; rank < manifest.n_ranks; ++rank)
    for (const unsigned long number : { 0ul, 1ul })
      if (const fs::path state = state_file(number, rank); is_in(state))
        return "holds " + state.filename().string() + ", which is not of a checkpoint" + rest;
  const fs::path half = unfinished(file); // of a program that was killed while it wrote
  if (is_in(half) && read_file(half).compare(0, 20, "stemware checkpoint ") != 0 &&
      fs::file_size(half, error) != 0)
    return "holds " + half.filename().string() + ", which is not of a checkpoint" + rest;
  return "";
}

fs::path ContactCheckpoint::state_file(unsigned long number, unsigned int rank) const
{
  return folder / ("state_" + std::to_string(number % 2) + "." + std::to_string(rank));
}

bool ContactCheckpoint::write_manifest() const
{
  // Whole or not at all: under another name first.
  const fs::path file = folder / checkpoint_manifest_name;
  std::error_code error;
  if (write_file(unfinished(file), manifest_text(manifest)))
    fs::rename(unfinished(file), file, error);
  else
    return false;
  return !error;
}

void ContactCheckpoint::save(const SolidBody &body, const ContactStart &start,
                             const std::vector<ContactIteration> &history)
{
  if (!is_ours)
    return;
  const unsigned int rank = this_rank();
  const std::string failure = "The checkpoint in " + folder.string() +
                              " cannot be written; make room, or leave Contact/Checkpoint folder empty.";
  if (!is_there) // the files are listed before they are made
    require_everywhere(rank != 0 || write_manifest(), failure);
  is_there = true;
  std::ostringstream state;
  const unsigned int counts[] = { body.n_unknowns(), start.n_steps, start.n_linear_iterations,
                                  static_cast<unsigned int>(history.size()) };
  write_binary(state, counts, 4);
  write_history(state, history);
  write_binary(state, start.motion.data(), 3);
  write_binary(state, start.normal_displacement.data(),
               static_cast<std::size_t>(start.normal_displacement.size()));
  body.write_state(state);
  const std::string content = state.str();
  // The states of all ranks are there before the first says so.
  require_everywhere(write_file(state_file(manifest.state + 1, rank), content), failure);
  const CheckpointManifest before = manifest;
  ++manifest.state;
  manifest.n_unknowns = body.n_unknowns();
  manifest.files.clear();
  const std::vector<std::uint64_t> own = { content.size(), check_sum_of(content) };
  for (const std::vector<std::uint64_t> &file : Utilities::MPI::all_gather(MPI_COMM_WORLD, own))
    manifest.files.push_back({ file[0], file[1] });
  const bool is_written = rank != 0 || write_manifest();
  if (Utilities::MPI::min(is_written ? 1 : 0, MPI_COMM_WORLD) == 0)
  {
    manifest = before;
    throw std::runtime_error(failure);
  }
  std::error_code ignored;
  fs::remove(state_file(manifest.state - 1, rank), ignored);
}

std::optional<ContactCheckpoint::Kept> ContactCheckpoint::restore(SolidBody &body)
{
  if (!is_there || !is_ours || manifest.state == 0 || manifest.n_unknowns != body.n_unknowns())
    return std::nullopt;
  const unsigned int rank = this_rank();
  const std::string content = read_file(state_file(manifest.state, rank));
  const CheckpointManifest::File &file = manifest.files.at(rank);
  const std::string failure =
    "The checkpoint in " + folder.string() + " is damaged; remove it to begin anew.";
  require_everywhere(content.size() == file.n_bytes && check_sum_of(content) == file.sum, failure);
  std::istringstream state(content);
  unsigned int counts[4] = {};
  Kept kept;
  read_binary(state, counts, 4);
  kept.start.n_steps = counts[1];
  kept.start.n_linear_iterations = counts[2];
  kept.history = read_history(state, counts[3]);
  read_binary(state, kept.start.motion.data(), 3);
  kept.start.normal_displacement.resize(body.contact_surface().n_nodes());
  read_binary(state, kept.start.normal_displacement.data(),
              static_cast<std::size_t>(kept.start.normal_displacement.size()));
  body.read_state(state);
  const bool is_whole =
    state && counts[0] == body.n_unknowns() && state.peek() == std::istringstream::traits_type::eof();
  require_everywhere(is_whole, failure);
  return kept;
}

void ContactCheckpoint::remove()
{
  if (is_there && is_ours && this_rank() == 0)
  {
    // The list last: what is left when the program is killed here is still a checkpoint, without a state.
    std::error_code ignored;
    manifest.state = 0;
    manifest.files.clear();
    write_manifest();
    for (unsigned int rank = 0; rank < manifest.n_ranks; ++rank)
      for (const unsigned long number : { 0ul, 1ul })
        fs::remove(state_file(number, rank), ignored);
    fs::remove(folder / checkpoint_manifest_name, ignored);
  }
  MPI_Barrier(MPI_COMM_WORLD); // nothing is left when it returns
}

} // namespace stemware::fem
