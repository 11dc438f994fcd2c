// stemware._study: a study as the program solves it, for Python, by the functions that the verbs call. No
// console, no signals; MPI starts for a solid foot only.

#include "fem/contact/contact_solution.h"
#include "fem/pipeline/analysis/study_answer.h"
#include "fem/pipeline/analysis/sweep/sweep_case.h"
#include "fem/pipeline/coupling/failure_sentence.h"
#include "fem/pipeline/document/json.h"
#include "fem/pipeline/document/table.h"
#include "fem/pipeline/report/convergence_results.h"
#include "fem/pipeline/report/publish.h"
#include "fem/pipeline/report/run_results.h"
#include "fem/pipeline/report/truncation_results.h"
#include "fem/pipeline/study/presets.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/program.h"
#include "fem/pipeline/support/ranks.h"
#include "fem/revolution/compliance_cache.h"
#include "ring_model/no_balance.h"

#include <chrono>
#include <dlfcn.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace py = pybind11;
using namespace py::literals;
using namespace stemware;
using namespace stemware::pipeline;

namespace
{

/// The work has ended because Python raised: no std::exception, which a model without an answer would
/// swallow.
struct Interrupted
{
};

/// Progress for Python: Ctrl-C, and a function (what, done, all) or None. The pipeline calls it from one
/// thread at a time.
class PythonProgress : public Progress
{
public:
  explicit PythonProgress(py::object listener)
      : listener(std::move(listener))
  {
  }
  void stage_done(const std::string &stage) override { tell(stage, 1, 1); }
  void pieces_done(const std::string &what, std::size_t n_done, std::size_t n_all) override
  {
    tell(what, n_done, n_all);
  }
  void iteration(const fem::ContactIteration &) override { check(); }
  void note(const std::string &, const std::string &) override { check(); }

  /// Raises in Python what has ended the work.
  [[noreturn]] void raise() { throw py::error_already_set(*raised); }

private:
  template <typename Work>
  void with_python(const Work &work)
  {
    const py::gil_scoped_acquire gil;
    try
    {
      if (!raised && PyErr_CheckSignals() != 0)
        throw py::error_already_set();
      if (!raised)
        work();
    }
    catch (py::error_already_set &error)
    {
      raised = std::make_unique<py::error_already_set>(std::move(error));
    }
    if (raised)
      throw Interrupted();
  }
  void check()
  {
    const auto now = std::chrono::steady_clock::now();
    if (now < next)
      return;
    next = now + std::chrono::milliseconds(50);
    with_python([] {});
  }
  void tell(const std::string &what, std::size_t n_done, std::size_t n_all)
  {
    with_python(
      [&]
      {
        if (!listener.is_none())
          listener(what, n_done, n_all);
      });
  }

  py::object listener;
  std::unique_ptr<py::error_already_set> raised;
  std::chrono::steady_clock::time_point next = std::chrono::steady_clock::now();
};

/// Calls @p work(progress, executor) without Python's lock.
template <typename Work>
auto solved(const py::object &listener, unsigned int n_threads, const Work &work)
{
  // Compliances that equal feet share: 128 at most. Never destroyed: threads may outlive the interpreter.
  static auto *const cache = new fem::ComplianceCache;
  PythonProgress progress(listener);
  try
  {
    const py::gil_scoped_release released;
    return work(progress, Executor(*cache, n_threads));
  }
  catch (const Interrupted &)
  {
    progress.raise();
  }
}

/// Results of a verb, with what Python asks of them.
struct Found
{
  std::string verb;
  Study study;
  Results results;
  std::shared_ptr<const StudyAnswer> answer = {}; ///< of run

  std::string document() const { return valid_text(summary_of(verb, study, results.findings)); }

  /// Writes the folder that the program would write.
  void save(const std::string &folder) const
  {
    StudyOptions options;
    options.verb = verb;
    options.output = folder;
    options.quiet = true;
    direct_console(true, false);
    ResultsFolder place(folder);
    Stopwatch stopwatch;
    publish(options, study, results, place, stopwatch);
  }
};

/// @p given, read again with its files and checked as the program does at its start.
Study checked(const Study &given)
{
  Study study = with_values(given, "", {});
  require_standing_glass(study);
  return study;
}

Found run_study(const Study &given, bool quick, unsigned int n_threads, const py::object &listener)
{
  return solved(listener, n_threads,
                [&](Progress &progress, const Executor &executor)
                {
                  auto answer = std::make_shared<StudyAnswer>(answer_study(
                    checked(given), quick ? Depth::answer : Depth::full, executor, progress, false));
                  Results results =
                    tabulate(answer->study, answer->contact, answer->spin, answer->bands, answer->goal);
                  return Found{ "run", answer->study, std::move(results), answer };
                });
}

Found truncated(const Study &given, unsigned int n_threads, const py::object &listener)
{
  return solved(
    listener, n_threads,
    [&](Progress &progress, const Executor &executor)
    {
      const TruncatedStudy answer = truncate_study(checked(given), executor, progress);
      return Found{ "truncate", answer.study, tabulate_truncations(answer.study, answer.load, answer.rows) };
    });
}

Found converged(const Study &given, unsigned int n_levels, unsigned int n_threads, const py::object &listener)
{
  return solved(listener, n_threads,
                [&](Progress &progress, const Executor &executor)
                {
                  const Study study = checked(given);
                  std::vector<RefinementAxis> axes = refinement_axes(study, n_levels);
                  const ErrorBands bands = converge_study(study, axes, executor, progress);
                  return Found{ "converge", study, tabulate(study, axes, bands) };
                });
}

py::dict case_of(const Study &given, const py::object &listener)
{
  const CaseResult found = solved(
    listener, 1, [&](Progress &, const Executor &executor) { return case_result(checked(given), executor); });
  py::dict all;
  for (const std::string &key : sweep_keys())
    all[key.c_str()] = found.value(key);
  return all;
}

template <typename Rows, typename Value>
py::array_t<double> column(const Rows &rows, Value value)
{
  py::array_t<double> values(static_cast<py::ssize_t>(rows.size()));
  double *to = values.mutable_data();
  for (const auto &row : rows)
    *to++ = std::invoke(value, row);
  return values;
}

/// The curves of run by the names of their members: torque, spin_up, load, pressure.
py::dict curves_of(const StudyAnswer &answer)
{
  const auto same = [](double value) { return value; };
  const TorqueCurve &torque = answer.spin.torque;
  const SpinUpCurves &up = answer.spin.spin_up;
  py::dict curves;
  curves["torque"] = py::dict(
    "omega"_a = column(torque.omega, same), "slip_ratio"_a = column(torque.slip_ratio, same),
    "sum"_a = column(torque.sum, same), "friction"_a = column(torque.friction, &ring::Wrench::torque),
    "force_x"_a = column(torque.friction, &ring::Wrench::force_x),
    "force_y"_a = column(torque.friction, &ring::Wrench::force_y),
    "lean"_a = column(torque.lean_torque, same), "grip"_a = column(torque.grip_torque, same));
  curves["spin_up"] =
    py::dict("time"_a = column(up.time, same), "omega"_a = column(up.adaptive, same),
             "yaw_angle"_a = column(up.yaw_angle, same), "first_harmonic"_a = column(up.first_harmonic, same),
             "paper"_a = column(up.paper, same));
  const std::vector<fem::AzimuthLoad> &load = answer.contact.load.pointwise;
  curves["load"] = py::dict("theta"_a = column(load, &fem::AzimuthLoad::azimuth),
                            "density"_a = column(load, &fem::AzimuthLoad::density));
  std::vector<fem::PressurePoint> points;
  if (answer.contact.foot)
    for (const auto &cut : answer.contact.foot->footprint.cuts)
      points.insert(points.end(), cut.begin(), cut.end());
  curves["pressure"] = py::dict("r"_a = column(points, &fem::PressurePoint::radius),
                                "theta"_a = column(points, &fem::PressurePoint::azimuth),
                                "p"_a = column(points, &fem::PressurePoint::pressure));
  return curves;
}

/// Row of an entry in a table of all.
py::dict facts_of(const StudyEntry &entry)
{
  return py::dict("path"_a = entry.path(), "value"_a = entry.value(), "unit"_a = entry.unit,
                  "allowed"_a = entry.allowed, "help"_a = entry.help, "given"_a = entry.is_given);
}

/// The program's classes of failure as those of stemware.ring, with the program's sentences. Exceptions of
/// other modules are told from ours by their names alone.
void bind_failures(py::module_ &m)
{
  static const py::handle ring = py::module_::import("stemware._ring").release(); // outlives the interpreter
  static const py::handle no_contact =
    py::exception<fem::ContactFailure>(m, "ContactFailure", py::object(ring.attr("NoBalance"))).release();
  static const py::handle output = py::exception<OutputFailure>(m, "OutputFailure", PyExc_OSError).release();
  py::register_exception_translator(
    [](std::exception_ptr failure)
    {
      const auto raise = [](py::handle kind) { PyErr_SetString(kind.ptr(), failure_sentence().c_str()); };
      try
      {
        std::rethrow_exception(failure);
      }
      catch (const BadInput &)
      {
        raise(ring.attr("BadInput"));
      }
      catch (const OutputFailure &)
      {
        raise(output);
      }
      catch (const fem::ContactFailure &)
      {
        raise(no_contact);
      }
      catch (const ring::Tipping &)
      {
        raise(ring.attr("Tipping"));
      }
      catch (const ring::NoTerminalSpin &)
      {
        raise(ring.attr("NoTerminalSpin"));
      }
      catch (const ring::BalanceLost &)
      {
        raise(ring.attr("BalanceLost"));
      }
      catch (const ring::NoBalance &)
      {
        raise(ring.attr("NoBalance"));
      }
    });
}

/// Python loads a module for itself alone; the program's own modules look for their symbols in it.
void show_symbols()
{
  Dl_info self;
  if (::dladdr(reinterpret_cast<const void *>(&show_symbols), &self) != 0)
    ::dlopen(self.dli_fname, RTLD_NOW | RTLD_NOLOAD | RTLD_GLOBAL);
}

} // namespace

PYBIND11_MODULE(_study, m)
{
  show_symbols();
  bind_failures(m);
  static auto *const mpi = new std::optional<MpiSession>; // ends before the interpreter
  py::module_::import("atexit").attr("register")(py::cpp_function([] { mpi->reset(); }));

  py::class_<Study>(m, "Study")
    .def(py::init([](const std::string &file) { return read_study(file); }), "file"_a)
    .def_static("of_text", &read_study_text, "origin"_a, "text"_a)
    .def("assign",
         [](Study &study, const std::string &path, const std::string &text)
         {
           const std::vector<StudyEntry> entries = study_entries(study);
           assign(entries, "", whole_path(entries, path), text);
         })
    .def("value", [](const Study &study, const std::string &path)
         { return entry_at(entries_of(study), "", whole_path(entries_of(study), path)).value(); })
    .def("entries",
         [](const Study &study)
         {
           py::list all;
           for (const StudyEntry &entry : entries_of(study))
             all.append(facts_of(entry));
           return all;
         })
    .def("check", [](const Study &study) { checked(study); })
    .def("notes", &implausible_notes)
    .def_readwrite("name", &Study::name)
    .def_property_readonly("needs_mpi",
                           [](const Study &study) { return study.contact.body == BodyKind::solid; })
    .def("prm", &study_as_prm)
    .def("run", &run_study, py::kw_only(), "quick"_a, "n_threads"_a, "progress"_a)
    .def("truncate", &truncated, py::kw_only(), "n_threads"_a, "progress"_a)
    .def("converge", &converged, py::kw_only(), "n_levels"_a, "n_threads"_a, "progress"_a)
    .def("answer", &case_of, py::kw_only(), "progress"_a);

  py::class_<Found>(m, "Found")
    .def("document", &Found::document)
    .def("curves", [](const Found &found) { return found.answer ? curves_of(*found.answer) : py::dict(); })
    .def("tilt",
         [](const Found &found, bool at_rest)
         {
           const Eigen::Vector2d tilt = !found.answer ? Eigen::Vector2d(0, 0)
                                        : at_rest     ? found.answer->contact.load.tilt
                                                      : found.answer->contact.load_at_end.tilt;
           return std::pair(tilt.x(), tilt.y());
         })
    .def("save", &Found::save, "folder"_a, py::call_guard<py::gil_scoped_release>());

  m.def("start_session",
        []
        {
          if (!*mpi)
            mpi->emplace();
        });
  m.def("unit",
        [](const std::string &key, const std::string &section) { return quantity_named(key, section).unit; });
  m.def("unit_of_entry", &unit_of);
  m.def("case_keys", &sweep_keys);
  m.def("presets",
        []
        {
          py::list all;
          for (const auto &[kind, presets] :
               { std::pair("glass", &glass_presets()), std::pair("table", &table_presets()) })
            for (const Preset &one : *presets)
              all.append(py::dict("kind"_a = kind, "name"_a = one.name, "words"_a = one.words,
                                  "entries"_a = one.text));
          return all;
        });
  m.def("preset_study",
        [](const std::string &glass, const std::string &table)
        {
          return new_study_text(preset_of(glass_presets(), "glass", glass),
                                preset_of(table_presets(), "table", table), "study.prm");
        });
  m.attr("version") = program_version();
}
