// stemware._ring: Python bindings of ring_model. Arguments are arrays of equal shape (broadcast by
// stemware/ring.py), and results have the same shape. All quantities are in SI units.

#include "ring_model/friction_functionals.h"
#include "ring_model/friction_kernels.h"
#include "ring_model/load/require.h"
#include "ring_model/self_consistent_ring.h"
#include "ring_model/sliding_body.h"
#include "ring_model/spin/answer.h"
#include "ring_model/spin/curves.h"
#include "ring_model/yaw_motion.h"

#include <Eigen/Geometry>

#include <chrono>
#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace py = pybind11;
using namespace py::literals;
using namespace stemware::ring;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Row = std::vector<double>;

namespace
{

/// Returns a check for Ctrl-C, at most 20 times a second, for loops that run without the GIL.
auto interruption()
{
  return [next = std::chrono::steady_clock::now()]() mutable
  {
    const auto now = std::chrono::steady_clock::now();
    if (now < next)
      return;
    next = now + std::chrono::milliseconds(50);
    const py::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
  };
}

template <typename Result, typename... Arguments>
std::function<Result(Arguments...)> interruptible(std::function<Result(Arguments...)> function)
{
  return [function = std::move(function), check = interruption()](Arguments... values) mutable
  {
    check();
    return function(values...);
  };
}

template <typename Work>
auto without_gil(const Work &work)
{
  const py::gil_scoped_release released;
  return work();
}

template <typename Value>
py::array_t<Value> numpy_of(const std::vector<Value> &values)
{
  return py::array_t<Value>(static_cast<py::ssize_t>(values.size()), values.data());
}

/// Returns an array (..., n): @p values(entries...) returns n numbers for each entry of the arrays.
template <typename Values, typename... Arrays>
Array filled(py::ssize_t n, const Values &values, const Array &first, const Arrays &...others)
{
  require(((others.size() == first.size()) && ...), "the arrays differ in size; broadcast them first");
  std::vector<py::ssize_t> shape(first.shape(), first.shape() + first.ndim());
  shape.push_back(n);
  Array out(shape);
  double *to = out.mutable_data();
  const py::gil_scoped_release released;
  auto check = interruption();
  for (py::ssize_t i = 0; i < first.size(); ++i)
  {
    check();
    for (const double value : values(first.data()[i], others.data()[i]...))
      *to++ = value;
  }
  return out;
}

Array kernels(const Array &rim_speed, const Array &speed, unsigned int n_max)
{
  const auto values = [n_max](double u, double v)
  {
    const FrictionKernels one(u, v, n_max);
    Row all;
    for (unsigned int n = 0; n <= n_max; ++n)
      all.insert(all.end(), { one.P(n), one.K(n), one.U(n) });
    return all;
  };
  return filled(3 * (static_cast<py::ssize_t>(n_max) + 1), values, rim_speed, speed);
}

struct LawInPython : FrictionLaw
{
  double coefficient(double slip_speed) const override
  {
    PYBIND11_OVERRIDE_PURE(double, FrictionLaw, coefficient, slip_speed); // takes the GIL
  }
};

Sample stack_of(const Row &radii, const std::vector<Row> &a, const std::vector<Row> &b,
                const Eigen::Vector2d &tilt)
{
  require(radii.size() == a.size() && a.size() == b.size(), "there are ", radii.size(), " radii, ", a.size(),
          " rows of a and ", b.size(), " of b; give equally many");
  std::vector<RingStack::Ring> rings;
  for (std::size_t j = 0; j < radii.size(); ++j)
    rings.push_back({ radii[j], a[j], b[j] });
  return { RingStack(std::move(rings)), tilt };
}

/// Returns @p member of all J rings as an array (J,), or (J, n_max + 1) for coefficients.
template <auto member>
py::array of_rings(const Sample &load)
{
  py::list all;
  for (const RingStack::Ring &ring : load.rings())
    all.append(ring.*member);
  return py::array(all);
}

/// Friction wrench as a function of velocity and spin. The velocity (v_x, v_y) [m/s] is in the frame of the
/// load, the spin omega in [rad/s]. The friction law must outlive the object.
struct Friction
{
  Friction(const Sample &load, const FrictionLaw &law)
  {
    at = [load, &law](double x, double y, double omega) { return wrench(law, load, { x, y }, omega); };
  }
  /// @p limit is the maximum friction force mu N [N].
  Friction(const SlidingBody &body, double limit)
      : at([body, limit](double speed, double, double omega) { return body.friction(limit, speed, omega); })
  {
  }
  explicit Friction(const SelfConsistentRing &ring)
      : at([ring](double, double, double omega) { return ring.at(omega).friction; })
  {
  }

  /// Returns the array (..., 3) of T_x, T_y, tau_z.
  Array wrenches(const Array &v_x, const Array &v_y, const Array &omega) const
  {
    const auto values = [this](auto... slip)
    {
      const Wrench one = at(slip...);
      return std::array{ one.force_x, one.force_y, one.torque };
    };
    return filled(3, values, v_x, v_y, omega);
  }

  std::function<Wrench(double, double, double)> at;
};

SelfConsistentRing balanced_ring(const Motion &motion, const std::string &closure, double radius)
{
  for (const Closure one : { Closure::paper, Closure::hand, Closure::full })
    if (to_string(one) == closure)
      return { one, motion, radius };
  throw std::invalid_argument("closure = \"" + closure + "\" is not allowed; give paper, hand or full");
}

std::function<Sample(double)> load_function(const py::object &load)
{
  if (py::isinstance<SelfConsistentRing>(load))
    return [ring = load.cast<SelfConsistentRing>()](double omega) { return ring.at(omega).load; };
  if (py::isinstance<Sample>(load))
    return [stack = load.cast<Sample>()](double) { return stack; };
  return load.cast<std::function<Sample(double)>>();
}

/// Throws Tipping if no compressive pressure within the outermost ring of @p load has the moment of @p load.
void require_a_pressure(const RingStack &load, double omega)
{
  double outer = 0;
  for (const RingStack::Ring &ring : load.rings())
    outer = std::max(outer, ring.radius);
  const double moment = load.moment().norm(), limit = load.normal_force() * outer;
  if (moment >= limit)
    throw Tipping(sentence("the glass tips: at ", omega, " rad/s the moment is ", moment,
                           " N m, but the normal force has ", limit,
                           " N m at most, at the outermost ring; lower the hand or the speed"));
}

/// Returns the terminal spin, all terminal spins (an empty list unless @p all is true), the torque at rest [N
/// m], the spin unit v / R [rad/s] and the spin-up.
py::tuple answer_about(const py::object &given, const Motion &motion, double grip_torque, bool all,
                       const Row &times)
{
  motion.validate();
  const Load load(interruptible(load_function(given)));
  Question question{ motion, grip_torque };
  question.with_slope = true;
  const Answer found = without_gil([&] { return answer(load, question); });
  if (found.fall && times.empty())
    throw BalanceLost(found.reason, found.fall->omega, true);
  found.value();
  require_a_pressure(found.at_rest->load, 0);
  if (found.terminal)
    require_a_pressure(found.at_terminal->load, found.terminal->omega);
  const auto spins =
    without_gil([&] { return all ? terminal_spins(load, question, found) : std::vector<TerminalSpin>(); });
  const auto motion_from_rest = without_gil(
    [&] { return times.empty() ? std::vector<YawSample>() : spin_up(load, question, times, found.fall); });
  return py::make_tuple(
    numpy_of(std::vector<TerminalSpin>(found.terminal ? 1 : 0, found.terminal.value_or(TerminalSpin()))),
    numpy_of(spins), found.at_rest->friction.torque + found.at_rest->lean_torque, load.spin_scale(motion),
    numpy_of(motion_from_rest));
}

py::array motion_of(const PhasedTorqueFunction &torque, double yaw_inertia, const Row &times,
                    double initial_spin, double accuracy, double spin_scale, double grip_torque)
{
  const auto at = interruptible(torque);
  return numpy_of(without_gil(
    [&] { return yaw_motion(at, yaw_inertia, initial_spin, times, accuracy, spin_scale, grip_torque); }));
}

/// Registers the exceptions of the module. If several translators match, the translator that is registered
/// last (BalanceLost) is called.
void bind_failures(py::module_ &m)
{
  py::register_exception<std::invalid_argument>(m, "BadInput", PyExc_ValueError).doc() =
    "Value that is not allowed; the message names it, the allowed values and the remedy.";
  const auto base = py::register_exception<NoBalance>(m, "NoBalance", PyExc_RuntimeError);
  base.doc() = "Failure of a balance of forces, moments or torques: the result does not exist.";
  py::register_exception<Tipping>(m, "Tipping", base).doc() = "The required moment tips the glass.";
  py::register_exception<NoTerminalSpin>(m, "NoTerminalSpin", base).doc() = "The torque vanishes at no spin.";
  static const py::handle lost = py::exception<BalanceLost>(m, "BalanceLost", base).release();
  lost.doc() = "The balance of moments is lost during the spin-up, after last_spin [rad/s].";
  py::register_exception_translator(
    [](std::exception_ptr failure)
    {
      try
      {
        std::rethrow_exception(failure);
      }
      catch (const BalanceLost &one)
      {
        const py::object raised = lost(one.what());
        raised.attr("last_spin") = one.last_spin;
        PyErr_SetObject(lost.ptr(), raised.ptr());
      }
    });
}

void bind_motion(py::module_ &m)
{
  using M = Motion;
  PYBIND11_NUMPY_DTYPE_EX(
    M, mass, "mass", yaw_inertia, "yaw_inertia", centre_of_mass_height, "centre_of_mass_height", force_offset,
    "force_offset", orbit_radius, "orbit_radius", orbit_speed, "orbit_speed", orbit_acceleration,
    "orbit_acceleration", orbit_sense, "clockwise", friction_coefficient, "friction_coefficient",
    friction_law, "stribeck", static_coefficient, "static_coefficient", friction_decay_speed,
    "friction_decay_speed", viscous_friction, "viscous_friction", gravity, "gravity", liquid.mass,
    "liquid_mass", liquid.density, "liquid_density", liquid.bowl_radius, "bowl_radius", liquid.bowl_height,
    "bowl_height", liquid.bowl_depth, "bowl_depth", liquid.surface_leans, "surface_leans");
  const py::object names = py::dtype::of<M>().attr("names");
  static constexpr auto flags = { "clockwise", "stribeck" }; // enumerations of two values become bool
  const auto as_dict = [=](const M &one)
  {
    py::dict all(py::module_::import("builtins").attr("zip")(names, py::array_t<M>(1, &one).attr("item")()));
    for (const char *flag : flags)
      all[flag] = py::bool_(all[flag]);
    return all;
  };
  const auto motion_of = [=](const py::kwargs &values)
  {
    py::array_t<M> record = numpy_of(std::vector<M>(1));
    for (const auto &[name, value] : values)
      if (!names.contains(name))
        throw py::type_error("a motion has no " + std::string(py::str(name)) + "; see Motion().as_dict()");
      else
        record[name] = value;
    for (const char *flag : flags)
      record[flag] = record[flag].attr("astype")("?");
    record.data()->validate();
    return *record.data();
  };
  py::class_<M> motion(m, "Motion",
                       R"(Glass, liquid, orbit and friction, read-only: Motion(mass=0.3, ...).

mass [kg], yaw_inertia [kg m^2], centre_of_mass_height [m]: without liquid. liquid_mass [kg], liquid_density [kg/m^3],
bowl_radius, bowl_height (of the bowl's bottom above the table), bowl_depth [m]; surface_leans (bool): False for a
surface that stays level. force_offset [m]: height of the hand's force above the centre of mass. orbit_radius [m],
orbit_speed [m/s], orbit_acceleration [m/s^2], clockwise (bool, seen from above). friction_coefficient; with
stribeck=True (bool) the kinetic one, beside static_coefficient, friction_decay_speed [m/s], viscous_friction [s/m].
gravity [m/s^2]. Motion().as_dict() has the defaults; replace(mass=0.25) returns a copy with other values.)");
  motion.def(py::init(motion_of))
    .def("as_dict", as_dict, "Returns the arguments of Motion() with their values.")
    .def_property_readonly("normal_force", &M::normal_force, "m g of glass and liquid [N]");
  for (const auto &name : names)
    motion.def_property_readonly(py::str(name).cast<std::string>().c_str(),
                                 [=](const M &one) -> py::object { return as_dict(one)[name]; });
}

void bind_loads(py::module_ &m)
{
  using R = Sample;
  py::class_<R>(
    m, "RingStack",
    R"(Normal load on concentric rings, lambda_j(theta) = sum_n a_jn cos n theta + b_jn sin n theta [N/rad].

theta: counter-clockwise from the direction of travel. radii [m]: (J,); a, b [N/rad]: (J, n_max + 1); tilt [rad]: (2,)
of the table about x and y in the frame of the glass, which gives the lean torque -tilt.moment [N m] on the glass.)")
    .def(py::init(&stack_of), "radii"_a, "a"_a, "b"_a, "tilt"_a = Eigen::Vector2d(Eigen::Vector2d::Zero()))
    .def_static(
      "first_harmonic",
      [](double force, const Eigen::Vector2d &moment, double radius)
      { return R{ RingStack::first_harmonic(force, moment, radius) }; },
      py::kw_only(), "normal_force"_a, "moment"_a, "radius"_a,
      "Returns one ring with harmonics 0 and 1 for the normal force [N] and the moment (M_x, M_y) [N m].")
    .def_property_readonly("radii", &of_rings<&RingStack::Ring::radius>, "[m], (J,)")
    .def_property_readonly("a", &of_rings<&RingStack::Ring::a>, "[N/rad], (J, n_max + 1)")
    .def_property_readonly("b", &of_rings<&RingStack::Ring::b>, "[N/rad], (J, n_max + 1)")
    .def_readonly("tilt", &R::tilt, "[rad], (2,)")
    .def_property_readonly("lean_torque", &R::lean_torque, "-tilt.moment [N m]")
    .def_property_readonly("n_harmonics", &R::n_harmonics, "Highest harmonic n_max")
    .def_property_readonly("normal_force", &R::normal_force, "[N]")
    .def_property_readonly("radius", &R::radius, "Of one ring with the same force, moment, harmonic 1 [m]")
    .def_property_readonly("moment", &R::moment, "(M_x, M_y) of the normal forces about the centre [N m]")
    .def_property_readonly("minimum", &R::minimum, "Minimum over theta of the sum of the rings [N/rad]")
    .def_property_readonly("pulling_force", &R::pulling_force, "Integral of the tension, max(0, -lambda) [N]")
    .def("truncated", &R::truncated, "n_max"_a, "Returns a copy with the harmonics up to n_max.")
    .def(
      "rotated",
      [](const R &one, double angle) {
        return R{ one.RingStack::rotated(angle), Eigen::Rotation2Dd(angle) * one.tilt };
      },
      "angle"_a, "Returns a copy rotated counter-clockwise by the angle [rad].")
    .def("at", py::vectorize([](const R *one, double theta) { return (*one)(theta); }), "theta"_a,
         "Returns the sum of the rings at theta [rad], an array [N/rad].");

  py::class_<SelfConsistentRing>(m, "SelfConsistentRing")
    .def(py::init(&balanced_ring), "motion"_a, "closure"_a, "radius"_a)
    .def(
      "load", [](const SelfConsistentRing &ring, double omega) { return Sample(ring.at(omega).load); },
      "omega"_a, "Returns the RingStack in balance at a spin [rad/s].");

  using B = SlidingBody;
  py::class_<B>(m, "Pressure", py::dynamic_attr(),
                R"(Axisymmetric normal pressure p(r) between the radii inner and outer [m].

p takes an array of radii [m], or one radius, and returns the pressure in any unit; only its shape counts. Gauss points cluster
at both radii and at v / |omega|, where friction is singular; a RingStack of as many rings is off by 1e-4 there.)")
    .def(py::init(
           [](const std::function<py::object(const py::array &)> &p, double inner, double outer)
           {
             const auto at = [p](const Row &radii)
             {
               const py::gil_scoped_acquire gil;
               return p(numpy_of(radii)).cast<Row>();
             };
             return B::with_pressure(at, inner, outer);
           }),
         "p"_a, "inner"_a, "outer"_a)
    .def_static("ring", &B::ring, "radius"_a, "Returns a thin ring.")
    .def_static("annulus", &B::annulus, "inner"_a, "outer"_a, "Returns a uniform pressure on an annulus.")
    .def_static("disc", &B::disc, "radius"_a, "Returns a uniform pressure on a disc.")
    .def_property_readonly("radius", &B::outer_radius, "Outer radius [m]")
    .def("mean_power", &B::mean_power, "exponent"_a,
         "Returns the mean of r^exponent weighted with the normal force [m^exponent].");
}

} // namespace

PYBIND11_MODULE(_ring, m)
{
  m.attr("__version__") = STEMWARE_VERSION;
  bind_failures(m);
  bind_motion(m);
  bind_loads(m);
  py::class_<FrictionLaw, LawInPython>(m, "FrictionLaw",
                                       "Base class of friction laws: override coefficient(self, slip_speed).")
    .def(py::init<>())
    .def("coefficient", &FrictionLaw::coefficient, "slip_speed"_a, "Returns mu at a slip speed [m/s].");
  py::class_<StribeckLaw, FrictionLaw>(
    m, "Stribeck",
    R"(Friction law mu(u) = kinetic + (static - kinetic) exp(-(u / decay_speed)^decay_exponent) + viscous u.

u: slip speed [m/s]; decay_speed [m/s], viscous [s/m].)")
    .def(py::init<double, double, double, double, double>(), py::kw_only(), "static"_a, "kinetic"_a,
         "decay_speed"_a, "viscous"_a = 0., "decay_exponent"_a = 2.);
  m.def("kernels", &kernels);
  py::class_<Friction>(m, "Friction")
    .def(py::init<const Sample &, const FrictionLaw &>(), py::keep_alive<1, 3>())
    .def(py::init<const SlidingBody &, double>())
    .def(py::init<const SelfConsistentRing &>())
    .def("wrench", &Friction::wrenches);

  PYBIND11_NUMPY_DTYPE(TerminalSpin, omega, torque_slope, time_constant, stable, held);
  PYBIND11_NUMPY_DTYPE(YawSample, time, yaw_angle, omega);
  m.def("answer", &answer_about);
  m.def("yaw_motion", &motion_of);
}
