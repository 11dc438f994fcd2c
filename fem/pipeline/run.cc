#include "fem/pipeline/run.h"

#include "fem/pipeline/contact_demand.h"
#include "fem/pipeline/coupled_load.h"
#include "fem/pipeline/foot_contact.h"
#include "fem/pipeline/interruption.h"
#include "fem/pipeline/program.h"
#include "fem/pipeline/ranks.h"
#include "fem/pipeline/result_tables.h"
#include "fem/pipeline/results_folder.h"
#include "fem/pipeline/stopwatch.h"
#include "fem/pipeline/study_file.h"
#include "fem/pipeline/summary.h"
#include "fem/pipeline/terminal_report.h"
#include "fem/pipeline/text_file.h"

#include <filesystem>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

/// The results folder as all ranks see it; the first one owns it.
class SharedFolder
{
public:
  explicit SharedFolder(const fs::path &target)
      : partial(on_first_rank(
          [&]
          {
            owned = std::make_unique<ResultsFolder>(target);
            return owned->working_folder().string();
          }))
  {
  }

  const fs::path &working_folder() const { return partial; }

  /// Runs @p work on the first rank.
  void write(const std::function<void(ResultsFolder &)> &work)
  {
    on_first_rank(
      [&]
      {
        work(*owned);
        return std::string();
      });
  }

private:
  std::unique_ptr<ResultsFolder> owned;
  const fs::path partial;
};

/// Contact at rest and fields of a study whose load comes from the finite elements.
ContactFigures solve_foot_contact(const fem::ContactLoad &demand, FootContact &contact, SharedFolder &folder,
                                  Stopwatch &stopwatch)
{
  ProgressTable progress;
  ContactFigures figures;
  figures.body = contact.name();
  figures.n_cells = contact.n_cells();
  figures.n_unknowns = contact.n_unknowns();
  figures.n_contact_nodes = contact.n_contact_nodes();
  figures.mesh_report = contact.mesh_report();
  figures.result =
    contact.solve(demand, 0, [&](const fem::ContactIteration &iteration) { progress.add(iteration); });
  stopwatch.finish("contact");

  const fs::path fields = folder.working_folder() / "fields";
  folder.write([&](ResultsFolder &) { fs::create_directory(fields); });
  if (!contact.write_fields(fields.string(), figures.result))
    folder.write([&](ResultsFolder &) { fs::remove(fields); });
  stopwatch.finish("fields");
  return figures;
}

/// The load on the ring, from wherever the study wants it; a contact and its figures are kept in @p foot and
/// @p contact.
RingLoad find_load(const Study &study, SharedFolder &folder, Stopwatch &stopwatch,
                   std::shared_ptr<FootContact> &foot, std::optional<ContactFigures> &contact)
{
  switch (study.load.source)
  {
  case LoadSource::contact:
    foot = make_foot_contact(study);
    print_mesh(*foot);
    stopwatch.finish("mesh_and_stiffness");
    contact = solve_foot_contact(demanded_load(study), *foot, folder, stopwatch);
    if (study.load.coupling == LoadCoupling::exact)
      return coupled_contact_load(study, foot, contact->result.load, print_balance);
    return frozen_contact_load(contact->result.load, study.glass.profile.contact_radius);
  case LoadSource::first_harmonic:
    return first_harmonic_load(study);
  case LoadSource::file:
    return load_from_file(study);
  }
  throw std::logic_error("a load source without a load");
}

/// Friction of the pressure where it lies, beside that of the ring.
void resolve_friction(const Study &study, const RingLoad &load, double omega_terminal, FootContact &foot,
                      ContactFigures &contact)
{
  const ring::Motion &motion = study.motion.orbit;
  const auto friction = [&](const std::vector<fem::PointForce> &forces, double omega)
  { return fem::resolved_friction(forces, motion.friction_coefficient, omega, motion.orbit_speed); };
  contact.friction_at_rest = friction(contact.result.point_forces, 0);
  if (study.load.coupling == LoadCoupling::frozen)
  {
    contact.friction_at_terminal = friction(contact.result.point_forces, omega_terminal);
    return;
  }
  const ring::AngularLoad terminal = load.at_spin(omega_terminal);
  const FootContactResult result =
    foot.solve({ terminal.normal_force(), terminal.moment().x(), terminal.moment().y() },
               omega_terminal / motion.orbit_speed, {});
  contact.friction_at_terminal = friction(result.point_forces, omega_terminal);
}

/// Everything that follows from the load: spin, truncations, closures.
StudyResult study_ring(const Study &study, const RingLoad &load, FootContact *foot,
                       std::optional<ContactFigures> contact)
{
  const ring::Motion &motion = study.motion.orbit;
  StudyResult result = { load,
                         std::move(contact),
                         study_yaw(load.at_spin, motion),
                         torque_curve(load.at_spin, motion),
                         spin_up_curves(load.at_spin, study.motion),
                         compare_closures(motion, study.glass.profile.contact_radius) };
  if (result.contact)
    resolve_friction(study, load, result.yaw.terminal.omega, *foot, *result.contact);
  return result;
}

void write_results(const Study &study, const StudyResult &result, Stopwatch &stopwatch, ResultsFolder &folder)
{
  const fs::path &place = folder.working_folder();
  const Study echo = with_paths_from(folder.final_folder(), study);
  write_text_file(place / "parameters.prm", study_as_prm(echo));
  write_result_tables(result, place);
  std::vector<std::string> files = folder.contents();
  files.insert(files.end(), { "summary.json", "timings.json" });
  std::sort(files.begin(), files.end());
  write_text_file(place / "summary.json", summary(echo, result, files).dump(2) + "\n");
  stopwatch.finish("tables");
  write_text_file(place / "timings.json", stopwatch.times().dump(2) + "\n");
  folder.publish();
}

} // namespace

void run(const RunOptions &options)
{
  // 1. What is asked for; everything that can be refused is refused here.
  Stopwatch stopwatch;
  const Study study = read_study(options.study_file, options.overrides);
  const fem::ContactLoad demand = demanded_load(study);
  if (study.load.source == LoadSource::contact)
    start_mpi();
  watch_for_interruption(); // after MPI, which puts handlers of its own in place
  const fs::path output = options.output.empty() ? fs::path("results") / fs::path(options.study_file).stem()
                                                 : fs::path(options.output);
  SharedFolder folder(output);
  console() << "Stemware  " << program_version() << " (" << program_revision() << ")\n"
            << "Study     " << options.study_file << std::endl;
  if (study.load.source == LoadSource::file)
    console() << "Load      " << study.load.file << std::endl;
  else
    print_demand(study, demand);
  stopwatch.finish("input");

  // 2. The load on the table.
  std::shared_ptr<FootContact> foot;
  std::optional<ContactFigures> contact;
  const RingLoad load = find_load(study, folder, stopwatch, foot, contact);

  // 3. What it does to the ring.
  const StudyResult result = study_ring(study, load, foot.get(), std::move(contact));
  stopwatch.finish("ring");

  // 4. The results, all at once, and the answer.
  folder.write([&](ResultsFolder &results) { write_results(study, result, stopwatch, results); });
  print_answer(study, result);
  console() << "Results   " << output.string() << std::endl;
}

} // namespace stemware::pipeline
