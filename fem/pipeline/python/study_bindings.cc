// stemware._study: Python bindings of Study and of the program's verbs. The bindings print nothing and set no
// signal handler. MPI starts for a solid foot only.

#include "fem/contact/contact_solution.h"
#include "fem/pipeline/analysis/solve.h"
#include "fem/pipeline/analysis/study_answer.h"
#include "fem/pipeline/analysis/sweep_case.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/base/console.h"
#include "fem/pipeline/base/program.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/coupling/failure_sentence.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/page/publish.h"
#include "fem/pipeline/result/curves.h"
#include "fem/pipeline/result/verb_results.h"
#include "fem/pipeline/study/presets.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/revolution/compliance_cache.h"
#include "ring_model/failures.h"
#include "ring_model/spin/curves.h"

#include <deal.II/base/multithread_info.h>

#include <mutex>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <utility>
#include <vector>

namespace py = pybind11;
using namespace py::literals;
using namespace stemware;
using namespace stemware::pipeline;

namespace
{

/// Exception of an interrupted Python call. The solver of variants catches std::exception, so Interrupted is
/// not derived from it.
struct Interrupted
{
  std::exception_ptr cause;
};

void check_signals()
{
  const py::gil_scoped_acquire gil;
  if (PyErr_CheckSignals() != 0)
    throw Interrupted{ std::make_exception_ptr(py::error_already_set()) };
}

/// Checks for Ctrl-C and calls the Python function f(stage, done, all), unless it is None. The members are
/// called by one thread at a time.
struct PythonProgress : Progress
{
  void stage_done(const std::string &stage) override { tell(stage, 1, 1); }
  void pieces_done(const std::string &what, std::size_t n_done, std::size_t n_all) override
  {
    tell(what, n_done, n_all);
  }
  void iteration(const fem::ContactIteration &) override { tell(); }
  void note(const std::string &, const std::string &) override { tell(); }

  template <typename... What>
  void tell(const What &...what)
  {
    const py::gil_scoped_acquire gil;
    try
    {
      if (cause)
        std::rethrow_exception(cause);
      if (PyErr_CheckSignals() != 0)
        throw py::error_already_set();
      if (sizeof...(what) > 0 && !listener.is_none())
        listener(what...);
    }
    catch (const py::error_already_set &)
    {
      cause = std::current_exception();
      throw Interrupted{ cause };
    }
  }

  py::object listener;
  std::exception_ptr cause; ///< first exception of Python, which also ends the work of other threads
};

/// Returns a cache for all studies. It is never destroyed, because threads may outlive the interpreter.
std::shared_ptr<fem::ComplianceCache> &cache()
{
  static auto *const one = new auto(std::make_shared<fem::ComplianceCache>(128, &check_signals));
  return *one;
}

template <typename Work>
auto solved(const py::object &listener, unsigned int n_threads, const Work &work)
{
  PythonProgress progress;
  progress.listener = listener;
  const auto in_use = cache();
  try
  {
    const py::gil_scoped_release released;
    return work(ThreadedExecutor(*in_use, n_threads, progress));
  }
  catch (const Interrupted &one)
  {
    std::rethrow_exception(one.cause);
  }
}

struct Start
{
  std::shared_ptr<ElasticFoot> foot;
};

struct Found
{
  std::string verb;
  Results results;
  std::shared_ptr<const StudyAnswer> answer = {}; ///< answer of `run`

  std::string document() const { return dump_utf8(summary_of(verb, results)); }

  /// Writes the result files to @p folder, as the program `stemware` does.
  void save(const std::string &folder) const
  {
    StudyOptions options;
    options.verb = verb;
    options.output = folder;
    options.quiet = true;
    direct_console(true, false);
    ResultsFolder place(folder);
    Stopwatch stopwatch;
    publish(options, results, place, stopwatch);
  }
};

/// Returns @p given with its files read again. Makes the checks that `stemware` makes at its start.
Study checked(Study given)
{
  Study study = with_values(std::move(given), "", {});
  require_no_tipping_at_rest(study);
  return study;
}

Found results_of(const std::string &verb, const Study &given, bool quick, unsigned int n_levels,
                 unsigned int n_threads, const py::object &listener, Start *start)
{
  const auto work = [&](const Executor &executor) -> Found
  {
    const Study study = checked(given);
    if (verb == "converge")
    {
      std::vector<RefinementAxis> axes = refinement_axes(study, n_levels);
      const ErrorBands bands = converge_study(study, axes, executor);
      return { verb, convergence_results(study, axes, bands) };
    }
    const bool truncates = verb == "truncate";
    const Depth depth = truncates ? Depth::rows : quick ? Depth::answer : Depth::full;
    const auto answer = std::make_shared<StudyAnswer>(
      answer_study(study, depth, executor, false, start ? &start->foot : nullptr));
    return { verb, truncates ? truncation_results(*answer) : run_results(*answer),
             truncates ? nullptr : answer };
  };
  return solved(listener, n_threads, work);
}

py::dict case_of(const Study &given, Start *start)
{
  const CaseResult found =
    solved(py::none(), 1,
           [&](const Executor &executor)
           { return case_result(checked(given), executor, start ? &start->foot : nullptr); });
  py::dict all;
  for (const Quantity &quantity : sweep_columns())
    all[quantity.key.c_str()] = found.value(quantity.key);
  return all;
}

/// Yaw torque without the grip torque, for spin-ups with various grip torques and yaw inertias.
class FreeTorque
{
public:
  FreeTorque(const Study &given, Start *start)
  {
    solved(py::none(), 1,
           [&](const Executor &executor)
           {
             study = checked(given);
             ensure(!study.motion.orbit_speeds, "A spin-up has a constant Motion/Orbit speed; leave out "
                                                "Motion/Orbit speed file.");
             const Variant variant = { { study, mesh_for_goal(study, executor).discretisation } };
             const auto foot = foot_of(variant, start ? start->foot : nullptr, executor);
             const BalancedLoad load = find_load(study, foot);
             ring::Question question = spin_question(study);
             question.grip_torque = 0;
             free = ring::answer(load, question).value();
             curve = ring::interpolated_for_curves(load, free, 0, 1.001 * free.last_spin().value());
             if (start)
               start->foot = foot;
           });
  }

  /// Returns spin [rad/s] and yaw angle [rad] of a spin-up from rest at the ascending @p times [s]; NaN after
  /// tipping. Units: @p grip [N m], @p yaw_inertia [kg m^2].
  std::pair<std::vector<double>, std::vector<double>> spin_up(const std::vector<double> &times, double grip,
                                                              double yaw_inertia)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    ring::Question question = spin_question(study);
    question.grip_torque = grip;
    question.motion.yaw_inertia = yaw_inertia;
    std::pair<std::vector<double>, std::vector<double>> found;
    for (const ring::YawSample &sample : ring::spin_up(*curve, question, times, free.fall))
    {
      found.first.push_back(sample.omega);
      found.second.push_back(sample.yaw_angle);
    }
    return found;
  }

private:
  Study study;
  ring::Answer free;
  std::optional<ring::Load> curve;
  std::mutex mutex;
};

/// Returns the columns with a key in Python as arrays.
py::dict arrays_of(const Fields<std::size_t> &columns, std::size_t n_points)
{
  py::dict arrays;
  for (const auto &[quantity, cells] : columns.table(points_of(n_points), Face::python).columns)
    arrays[quantity.array.c_str()] =
      py::array_t<double>(py::cast(std::vector<double>(cells.begin(), cells.end())));
  return arrays;
}

py::dict curves_in(const Found &found)
{
  const auto numpy_of = [](const auto &values)
  { return py::array(static_cast<py::ssize_t>(values.size()), values.data()); };
  if (!found.answer)
    return py::dict();
  const StudyAnswer &answer = *found.answer;
  std::vector<fem::PressurePoint> points;
  if (answer.contact.foot)
    for (const auto &cut : answer.contact.foot->footprint.cuts)
      points.insert(points.end(), cut.begin(), cut.end());
  const StudyCurves &curves = answer.spin;
  return py::dict("torque"_a = arrays_of(torque_columns(curves.torque), curves.torque.omega.size()),
                  "spin_up"_a = arrays_of(spin_up_columns(curves.spin_up), curves.spin_up.time.size()),
                  "load"_a = numpy_of(answer.contact.load.pointwise), "pressure"_a = numpy_of(points));
}

/// Translates @p Failure and its derived classes into the exception @p raised.
template <typename Failure>
void translate(const py::object &raised)
{
  static const py::handle kind = py::object(raised).release(); // a reference that outlives the interpreter
  py::register_local_exception_translator(
    [](std::exception_ptr failure)
    {
      try
      {
        std::rethrow_exception(failure);
      }
      catch (const Failure &)
      {
        PyErr_SetString(kind.ptr(), failure_sentence().c_str());
      }
    });
}

/// Registers the exceptions of the module, base classes first. If several translations match, the translation
/// that was registered last is used.
void bind_failures(py::module_ &m)
{
  const py::module_ ring = py::module_::import("stemware._ring");
  translate<ring::NoBalance>(ring.attr("NoBalance"));
  translate<ring::BalanceLost>(ring.attr("BalanceLost"));
  translate<ring::NoTerminalSpin>(ring.attr("NoTerminalSpin"));
  translate<ring::Tipping>(ring.attr("Tipping"));
  translate<fem::ContactFailure>(py::exception<void>(m, "ContactFailure", ring.attr("NoBalance")));
  static const py::handle tipping = ring.attr("Tipping").cast<py::object>().release();
  py::register_local_exception_translator(
    [](std::exception_ptr failure)
    {
      try
      {
        std::rethrow_exception(failure);
      }
      catch (const fem::ContactFailure &contact)
      {
        if (contact.outcome != fem::ContactOutcome::tipping)
          throw;
        PyErr_SetString(tipping.ptr(), failure_sentence().c_str());
      }
    });
  translate<OutputFailure>(py::exception<void>(m, "OutputFailure", PyExc_OSError));
  translate<BadInput>(ring.attr("BadInput"));
}

} // namespace

PYBIND11_MODULE(_study, m)
{
  dealii::MultithreadInfo::set_thread_limit(
    1); // deal.II's own threads would compete with the studies' threads
  bind_failures(m);
  py::class_<Study>(m, "Study")
    .def(py::init(
      [](const std::string &file, const std::optional<std::string> &text)
      {
        static const Study standard = read_study("");
        return text ? read_study_text("the text", *text) : file.empty() ? standard : read_study(file);
      }))
    .def("assign", [](Study &study, const std::string &path, const std::string &text)
         { assign(study_entries(study), "", path, text); })
    .def("value", [](const Study &study, const std::string &path)
         { return entry_at(entries_of(study), "", path).value(); })
    .def_property_readonly("is_collective", &Study::is_collective)
    .def("entries",
         [](const Study &study)
         {
           py::list all;
           for (const StudyEntry &one : entries_of(study))
             all.append(py::dict("path"_a = one.path(), "value"_a = one.value(), "unit"_a = one.unit,
                                 "allowed"_a = one.allowed, "help"_a = one.help, "given"_a = one.is_given));
           return all;
         })
    .def("check", [](const Study &study) { checked(study); })
    .def("notes", [](const Study &study) { return implausible_notes(entries_of(study)); })
    .def_readwrite("name", &Study::name)
    .def("prm", &study_as_prm)
    .def("answer", &case_of, "start"_a);
  py::class_<Start>(m, "Start",
                    R"(Initial guess (warm start) of the next Study.answer(start=...) or run(start=...):
the contacts of the last one. For one thread.)")
    .def(py::init<>());
  py::class_<FreeTorque>(m, "FreeTorque")
    .def(py::init<const Study &, Start *>(), "study"_a, "start"_a)
    .def("spin_up", &FreeTorque::spin_up, py::call_guard<py::gil_scoped_release>());
  m.def("limit_cache",
        [](std::size_t n) { cache() = std::make_shared<fem::ComplianceCache>(n, &check_signals); });

  PYBIND11_NUMPY_DTYPE_EX(fem::AzimuthValue, azimuth, "theta", value, "density");
  PYBIND11_NUMPY_DTYPE_EX(fem::PressurePoint, radius, "r", azimuth, "theta", pressure, "p");
  py::class_<Found>(m, "Found")
    .def(py::init(&results_of))
    .def("document", &Found::document)
    .def("curves", &curves_in)
    .def("save", &Found::save, "folder"_a, py::call_guard<py::gil_scoped_release>());

  py::class_<MpiSession>(m, "MpiSession").def(py::init<>());
  m.def("unit", [](const std::string &key, const std::string &part) { return unit_in_summary(part, key); });
  m.def("unit_of_entry", &unit_of);
  m.def("case_keys",
        []
        {
          std::vector<std::string> keys;
          for (const Quantity &quantity : sweep_columns())
            keys.push_back(quantity.key);
          return keys;
        });
  py::class_<Preset>(m, "Preset")
    .def_readonly("name", &Preset::name)
    .def_readonly("words", &Preset::words)
    .def_readonly("entries", &Preset::text);
  m.def("glass_presets", &glass_presets);
  m.def("table_presets", &table_presets);
  m.def("preset_of", &preset_of);
  m.def("new_study_text", &new_study_text);
  m.attr("version") = program_version();
}
