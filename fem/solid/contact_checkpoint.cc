#include "fem/solid/contact_checkpoint.h"

#include "fem/solid/binary_stream.h"

#include <deal.II/base/mpi.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;
namespace fs = std::filesystem;

namespace
{

constexpr const char *latest = "latest";

/// Whole or not at all: under another name first. Returns whether it is there.
bool write_file(const fs::path &path, const std::string &content)
{
  const fs::path unfinished = path.string() + ".unfinished";
  {
    std::ofstream file(unfinished, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    if (!file.flush())
      return false;
  }
  std::error_code error;
  fs::rename(unfinished, path, error);
  return !error;
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

bool is_first_rank()
{
  return Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
}

std::string header_of(const std::string &problem)
{
  return "stemware checkpoint 2\nranks " + std::to_string(Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)) +
         "\n" + problem + "\n";
}

} // namespace

ContactCheckpoint::ContactCheckpoint(const fs::path &folder, const std::string &problem)
    : folder(folder)
    , header(header_of(problem))
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw std::invalid_argument("Contact/Checkpoint folder = " + folder.string() + " cannot be made (" +
                                error.message() + "); give a folder that can be written to.");
}

fs::path ContactCheckpoint::state_file(unsigned long state, unsigned int rank) const
{
  return folder / ("state_" + std::to_string(state) + "." + std::to_string(rank));
}

void ContactCheckpoint::save(const SolidBody &body, const ContactStart &start)
{
  const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  std::ostringstream state;
  const unsigned int counts[] = { body.n_unknowns(), start.n_steps };
  write_binary(state, counts, 2);
  write_binary(state, start.motion.data(), 3);
  write_binary(state, start.normal_displacement.data(),
               static_cast<std::size_t>(start.normal_displacement.size()));
  body.write_state(state);
  const std::string failure = "The checkpoint in " + folder.string() +
                              " cannot be written; make room, or leave Contact/Checkpoint folder empty.";
  // The states of all ranks are there before the first says so.
  require_everywhere(write_file(state_file(number + 1, rank), state.str()), failure);
  require_everywhere(rank != 0 || write_file(folder / latest, header + std::to_string(number + 1) + "\n" +
                                                                std::to_string(body.n_unknowns())),
                     failure);
  std::error_code ignored;
  fs::remove(state_file(number, rank), ignored);
  ++number;
}

std::optional<ContactStart> ContactCheckpoint::restore(SolidBody &body)
{
  // The first rank says what there is, so that all do the same.
  unsigned long found[2] = { 0, 0 };
  if (is_first_rank())
  {
    const std::string content = read_file(folder / latest);
    if (content.compare(0, header.size(), header) == 0)
      std::istringstream(content.substr(header.size())) >> found[0] >> found[1];
    if (found[0] == 0)
      clear();
  }
  MPI_Bcast(found, 2, MPI_UNSIGNED_LONG, 0, MPI_COMM_WORLD);
  if (found[0] == 0 || found[1] != body.n_unknowns())
    return std::nullopt;
  number = found[0];
  std::istringstream state(read_file(state_file(number, Utilities::MPI::this_mpi_process(MPI_COMM_WORLD))));
  unsigned int counts[2] = {};
  ContactStart start;
  read_binary(state, counts, 2);
  start.n_steps = counts[1];
  read_binary(state, start.motion.data(), 3);
  start.normal_displacement.resize(body.contact_surface().n_nodes());
  read_binary(state, start.normal_displacement.data(),
              static_cast<std::size_t>(start.normal_displacement.size()));
  body.read_state(state);
  const bool is_whole =
    state && counts[0] == body.n_unknowns() && state.peek() == std::istringstream::traits_type::eof();
  require_everywhere(is_whole,
                     "The checkpoint in " + folder.string() + " is damaged; remove it to begin anew.");
  return start;
}

void ContactCheckpoint::remove()
{
  if (is_first_rank())
    clear();
  MPI_Barrier(MPI_COMM_WORLD); // nothing is left when it returns
}

void ContactCheckpoint::clear() const
{
  static const std::regex of_checkpoints("(latest|state_[0-9]+\\.[0-9]+)(\\.unfinished)?");
  std::error_code error, ignored;
  fs::remove(folder / latest, ignored); // no state disappears that is still named
  for (fs::directory_iterator file(folder, error), end; !error && file != end; file.increment(error))
    if (std::regex_match(file->path().filename().string(), of_checkpoints))
      fs::remove(file->path(), ignored);
}

} // namespace stemware::fem
