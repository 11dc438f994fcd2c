#include "fem/pipeline/study/friction_coupling.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/number_text.h"

#include <filesystem>

namespace stemware::pipeline
{

namespace
{

/// What only one of the two bodies can do.
void require_able_body(const Study &study)
{
  const ContactSection &contact = study.contact;
  if (contact.body == BodyKind::revolution)
  {
    require(contact.mesh_file.empty(), "Contact/Mesh file = " + contact.mesh_file +
                                         " is read by a solid body only; set Contact/Body = solid, or leave "
                                         "Mesh file empty.");
    return;
  }
  require(contact.degree <= 2,
          "Contact/Degree = " + std::to_string(contact.degree) +
            " is not allowed for Contact/Body = solid; give 1 or 2, or set Contact/Body = "
            "revolution.");
  require(study.table.kind != TableKind::elastic,
          "Table/Kind = elastic needs a body of revolution; set Contact/Body = revolution.");
  require(contact.friction_coupling != FrictionCoupling::elastic,
          "Contact/Friction coupling = elastic needs a body of revolution; set Contact/Body = revolution.");
}

std::string name_of(LoadCoupling coupling)
{
  return coupling == LoadCoupling::frozen ? "frozen" : coupling == LoadCoupling::exact ? "exact" : "response";
}

/// A load in balance with the closure has no moment given beforehand.
void require_one_moment(const LoadSection &load)
{
  const std::string coupling = "Load/Coupling = " + name_of(load.coupling);
  require(load.coupling == LoadCoupling::frozen || !load.is_static(),
          "Load/Moment ratio = " + to_text(load.moment_ratio) + " contradicts " + coupling +
            ", where the closure sets the moment; leave Moment ratio at -1, or set Coupling = frozen.");
  require(load.coupling == LoadCoupling::frozen || load.source != LoadSource::file,
          coupling +
            " contradicts Load/Source = file, whose load cannot follow the spin; set Coupling = frozen.");
}

/// A curve over the moment ratio holds where the load depends on nothing else.
void require_one_parameter(const Study &study)
{
  if (study.load.coupling != LoadCoupling::response)
    return;
  require(study.contact.body == BodyKind::revolution,
          "Load/Coupling = response needs a foot that answers a moment in all directions alike, which a mesh "
          "of cells does not; set Contact/Body = revolution, or Coupling = exact.");
  require(
    used_friction_coupling(study) == FrictionCoupling::none,
    "Load/Coupling = response needs a load that depends on the moment ratio alone, but Contact/Friction "
    "coupling = " +
      to_string(study.contact.friction_coupling) +
      (study.contact.friction_coupling == FrictionCoupling::automatic ? " (elastic on this table)" : "") +
      " makes it depend on the spin too; set Coupling = exact, or Friction coupling = none.");
}

void require_steps(const MotionSection &motion)
{
  constexpr double most_steps = 1e7;
  require(motion.end_time / motion.euler_step <= most_steps,
          "Motion/End time = " + to_text(motion.end_time) +
            " s in steps of Motion/Euler step = " + to_text(motion.euler_step) +
            " s makes more than 1e7 steps of the forward Euler method; use longer steps.");
}

void require_load_file(const LoadSection &load)
{
  if (load.source != LoadSource::file)
  {
    require(load.file.empty(),
            "Load/File = " + load.file +
              " is read only with Load/Source = file; set that, or leave Load/File empty.");
    return;
  }
  require(!load.file.empty(),
          "Load/Source = file needs Load/File; name a file with the load's Fourier coefficients.");
  require(!load.is_static(),
          "Load/Moment ratio = " + to_text(load.moment_ratio) +
            " contradicts Load/Source = file, whose load has a moment of its own; leave Moment ratio at -1.");
}

/// Missing files are found here, before anything is computed; what is in them is found when they are read.
void require_readable(const std::string &entry, const std::string &file)
{
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  require(std::filesystem::exists(status), entry + " = " + file +
                                             " does not exist; give a path that starts at the study file "
                                             "(with --set: where the program is started).");
  require(std::filesystem::is_regular_file(status),
          entry + " = " + file + " is not a file; give the path of a file.");
}

/// An out-of-flat rim or table needs a body whose gap can turn, a contact to feel it, and a response fine
/// enough.
void require_known_waviness(const Study &study)
{
  const auto check = [&](const std::string &entry, const Waviness &waviness)
  {
    if (waviness.empty())
      return;
    require(study.contact.body == BodyKind::revolution,
            entry + " needs a body of revolution; set Contact/Body = revolution, or leave " + entry +
              " empty and draw the foot in a mesh file.");
    require(study.load.source == LoadSource::contact,
            entry + " needs Load/Source = contact; set that, or leave " + entry + " empty.");
    require(study.load.coupling != LoadCoupling::response,
            entry +
              " makes the load depend on more than the moment, which Load/Coupling = response does not know; "
              "set Coupling = exact or frozen.");
    for (const WavinessHarmonic &harmonic : waviness)
      require(harmonic.n <= study.contact.harmonics,
              entry + " has a harmonic n = " + std::to_string(harmonic.n) + ", but the foot answers to " +
                std::to_string(study.contact.harmonics) + "; give at least as many Contact/Harmonics.");
  };
  check("Glass/Rim waviness", study.glass.waviness);
  check("Table/Waviness", study.table.waviness);
}

} // namespace

void check_study(const Study &study)
{
  require_able_body(study);
  require_known_waviness(study);
  require_one_moment(study.load);
  require_one_parameter(study);
  require_steps(study.motion);
  require_load_file(study.load);
  if (study.load.source == LoadSource::file)
    require_readable("Load/File", study.load.file);
  if (!study.contact.mesh_file.empty())
    require_readable("Contact/Mesh file", study.contact.mesh_file);
  try
  {
    study.motion.orbit.validate();
    study.glass.material.validate();
    if (study.contact.mesh_file.empty())
    {
      study.glass.profile.validate();
      study.contact.resolution.validate();
    }
  }
  catch (const std::invalid_argument &error)
  {
    throw BadInput(error.what());
  }
}

} // namespace stemware::pipeline
