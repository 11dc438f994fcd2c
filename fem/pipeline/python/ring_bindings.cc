// stemware._ring: Python bindings of ring_model. Arguments are arrays of equal shape, which stemware/ring.py
// broadcasts; results have that shape. SI units.

#include "ring_model/free_sliding.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/friction_kernels.h"
#include "ring_model/load/require.h"
#include "ring_model/self_consistent_ring.h"
#include "ring_model/spin/answer.h"
#include "ring_model/unilateral_foundation.h"
#include "ring_model/yaw_motion.h"

#include <Eigen/Geometry>

#include <chrono>
#include <map>
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

/// Returns a check for Ctrl-C, at most 20 times a second, for loops without the GIL.
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

/// Returns @p function with a check for Ctrl-C before each call.
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

/// Returns numbers, or plain structs as a structured array.
template <typename Value>
py::array_t<Value> numpy_of(const std::vector<Value> &values)
{
  return py::array_t<Value>(static_cast<py::ssize_t>(values.size()), values.data());
}

/// Returns an array (..., n): @p write(to, values...) sets n numbers for each entry of the arrays.
template <typename Write, typename... Arrays>
Array filled(py::ssize_t n, const Write &write, const Array &first, const Arrays &...others)
{
  require(((others.size() == first.size()) && ...), "the arrays differ in size; broadcast them first");
  std::vector<py::ssize_t> shape(first.shape(), first.shape() + first.ndim());
  shape.push_back(n);
  Array out(shape);
  double *to = out.mutable_data();
  const py::gil_scoped_release released;
  auto check = interruption();
  for (py::ssize_t i = 0; i < first.size(); ++i, to += n)
  {
    check();
    write(to, first.data()[i], others.data()[i]...);
  }
  return out;
}

/// Returns the array (..., 3) of T_x, T_y, tau_z.
template <typename WrenchAt, typename... Arrays>
Array wrenches(const WrenchAt &wrench_at, const Arrays &...arrays)
{
  const auto write = [&](double *to, auto... values)
  {
    const Wrench one = wrench_at(values...);
    for (const double value : { one.force_x, one.force_y, one.torque })
      *to++ = value;
  };
  return filled(3, write, arrays...);
}

/// Returns P_n, K_n, U_n for n = 0...n_max, shape (..., 3 (n_max + 1)).
Array kernels(const Array &rim_speed, const Array &speed, unsigned int n_max)
{
  const auto write = [n_max](double *to, double u, double v)
  {
    const FrictionKernels one(u, v, n_max);
    for (unsigned int n = 0; n <= n_max; ++n)
      for (const double value : { one.P(n), one.K(n), one.U(n) })
        *to++ = value;
  };
  return filled(3 * (static_cast<py::ssize_t>(n_max) + 1), write, rim_speed, speed);
}

/// Friction law written in Python.
struct LawInPython : FrictionLaw
{
  double coefficient(double slip_speed) const override
  {
    PYBIND11_OVERRIDE_PURE(double, FrictionLaw, coefficient, slip_speed); // takes the GIL
  }
};

LeaningLoad stack_of(const Row &radii, const std::vector<Row> &a, const std::vector<Row> &b,
                     const Eigen::Vector2d &tilt)
{
  require(radii.size() == a.size() && a.size() == b.size(), "there are ", radii.size(), " radii, ", a.size(),
          " rows of a and ", b.size(), " of b; give equally many");
  std::vector<RingStack::Ring> rings;
  for (std::size_t j = 0; j < radii.size(); ++j)
    rings.push_back({ radii[j], a[j], b[j] });
  return { RingStack(std::move(rings)), tilt };
}

/// Returns the coefficients a or b of all rings, shape (J, n_max + 1).
template <Row RingStack::Ring::*row>
py::array rows(const LeaningLoad &load)
{
  std::vector<Row> all;
  for (const RingStack::Ring &ring : load.rings())
    all.push_back(ring.*row);
  return py::cast(all);
}

/// Self-consistent ring with its motion and radius, which are private there.
struct BalancedRing
{
  Motion motion;
  double radius;
  SelfConsistentRing ring;

  LeaningLoad load(double omega) const { return ring.at(omega).load; }
};

/// Friction on a load with the velocity (v_x, v_y) [m/s] in the load's frame and the spin omega [rad/s].
struct Friction
{
  /// @p law must outlive this object. The kernels need a velocity along x: the load is rotated.
  Friction(const LeaningLoad &load, const FrictionLaw &law)
  {
    at = [load, &law](double v_x, double v_y, double omega)
    {
      const double speed = std::hypot(v_x, v_y), angle = std::atan2(v_y, v_x);
      const auto friction = friction_functionals(law, load.radii(), load.n_harmonics(), omega, speed);
      const Wrench one = friction(load.RingStack::rotated(-angle));
      const Eigen::Vector2d force = Eigen::Rotation2Dd(angle) * Eigen::Vector2d(one.force_x, one.force_y);
      return Wrench{ one.torque, force.x(), force.y() };
    };
  }
  Friction(const SlidingBody &body, double mu, double mass, double yaw_inertia, double gravity, double height)
  {
    const FreeSlider one{ body, mass, yaw_inertia, mu, gravity, height };
    one.validate();
    at = [one](double speed, double, double omega) { return sliding_friction(one, speed, omega); };
  }
  explicit Friction(const BalancedRing &one)
      : at([ring = one.ring](double, double, double omega) { return ring.at(omega).friction; })
  {
  }
  std::function<Wrench(double, double, double)> at;
};

BalancedRing balanced_ring(const Motion &motion, const std::string &closure, double radius,
                           std::optional<double> exponent, unsigned int n_harmonics)
{
  std::shared_ptr<const LoadModel> model = std::make_shared<FirstHarmonicModel>(radius);
  if (exponent)
    model = std::make_shared<UnilateralFoundation>(radius, *exponent, n_harmonics);
  for (const Closure one : { Closure::paper, Closure::hand, Closure::full })
    if (to_string(one) == closure)
      return { motion, radius, SelfConsistentRing(one, motion, model) };
  throw std::invalid_argument("the closure is \"" + closure + "\", but must be paper, hand or full");
}

/// Returns the load function of the spin [rad/s] for a RingStack, a SelfConsistentRing or a function.
std::function<LeaningLoad(double)> load_function(const py::object &load)
{
  if (py::isinstance<LeaningLoad>(load))
    return [stack = load.cast<LeaningLoad>()](double) { return stack; };
  if (py::isinstance<BalancedRing>(load))
    return [ring = load.cast<BalancedRing>()](double omega) { return ring.load(omega); };
  return load.cast<std::function<LeaningLoad(double)>>();
}

/// Returns the terminal spin, all balances, the torque of friction and lean at rest [N m], v / R [rad/s] and
/// the spin-up.
py::tuple answer_about(const py::object &given, const Motion &motion, double grip_torque, bool all,
                       const Row &times)
{
  motion.validate();
  const LoadFromFunction load(interruptible(load_function(given)));
  Question question{ motion, grip_torque };
  question.with_slope = true;
  question.with_minima = false;
  question.all_spins = all;
  question.times = times;
  const Answer found = without_gil([&] { return answer(load, question); });
  if (found.fall && times.empty())
    throw BalanceLost(found.reason, found.fall->omega, true);
  found.value();
  return py::make_tuple(
    numpy_of(std::vector<TerminalSpin>(found.terminal ? 1 : 0, found.terminal.value_or(TerminalSpin()))),
    numpy_of(found.all_spins), found.at_rest->friction.torque + found.at_rest->lean_torque,
    load.spin_scale(motion), numpy_of(found.spin_up));
}

py::array motion_of(const PhasedTorqueFunction &torque, double yaw_inertia, const Row &times,
                    double initial_spin, double accuracy, double spin_scale)
{
  const auto at = interruptible(torque);
  return numpy_of(
    without_gil([&] { return yaw_motion(at, yaw_inertia, initial_spin, times, accuracy, spin_scale); }));
}

py::tuple slide(const Friction &friction, double mass, double yaw_inertia, double radius, double speed,
                double omega, double accuracy)
{
  const auto along = interruptible(SlidingFriction([&](double v, double w) { return friction.at(v, 0, w); }));
  const SlidingInertia inertia = { mass, yaw_inertia, radius };
  const SlidingPath path = without_gil([&] { return slide_to_stop(inertia, along, speed, omega, accuracy); });
  return py::make_tuple(numpy_of(path.states), path.final_slip_ratio);
}

/// Defines the exceptions; the translator of BalanceLost, registered last, is called first.
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
  static const std::map<std::string, double &(*)(M &)> numbers = {
    { "mass", [](M &one) -> double & { return one.mass; } },
    { "yaw_inertia", [](M &one) -> double & { return one.yaw_inertia; } },
    { "centre_of_mass_height", [](M &one) -> double & { return one.centre_of_mass_height; } },
    { "force_offset", [](M &one) -> double & { return one.force_offset; } },
    { "orbit_radius", [](M &one) -> double & { return one.orbit_radius; } },
    { "orbit_speed", [](M &one) -> double & { return one.orbit_speed; } },
    { "orbit_acceleration", [](M &one) -> double & { return one.orbit_acceleration; } },
    { "friction_coefficient", [](M &one) -> double & { return one.friction_coefficient; } },
    { "static_coefficient", [](M &one) -> double & { return one.static_coefficient; } },
    { "friction_decay_speed", [](M &one) -> double & { return one.friction_decay_speed; } },
    { "viscous_friction", [](M &one) -> double & { return one.viscous_friction; } },
    { "gravity", [](M &one) -> double & { return one.gravity; } },
    { "liquid_mass", [](M &one) -> double & { return one.liquid.mass; } },
    { "liquid_density", [](M &one) -> double & { return one.liquid.density; } },
    { "bowl_radius", [](M &one) -> double & { return one.liquid.bowl_radius; } },
    { "bowl_height", [](M &one) -> double & { return one.liquid.bowl_height; } },
    { "bowl_depth", [](M &one) -> double & { return one.liquid.bowl_depth; } }
  };
  const auto as_dict = [](M one)
  {
    py::dict all("clockwise"_a = one.orbit_sense == OrbitSense::clockwise,
                 "stribeck"_a = one.friction_law == FrictionLawKind::stribeck);
    for (const auto &[name, number] : numbers)
      all[name.c_str()] = number(one);
    return all;
  };
  const auto changed = [](M one, const py::dict &values)
  {
    for (const auto &[key, value] : values)
      if (const std::string name = py::str(key); name == "clockwise")
        one.orbit_sense = value.cast<bool>() ? OrbitSense::clockwise : OrbitSense::counterclockwise;
      else if (name == "stribeck")
        one.friction_law = value.cast<bool>() ? FrictionLawKind::stribeck : FrictionLawKind::coulomb;
      else if (const auto number = numbers.find(name); number != numbers.end())
        number->second(one) = value.cast<double>();
      else
        throw py::type_error("a motion has no " + name + "; see Motion().as_dict()");
    one.validate();
    return one;
  };
  py::class_<M> motion(m, "Motion",
                       R"(Glass, liquid, orbit and friction, read-only: Motion(mass=0.3, ...).

mass [kg], yaw_inertia [kg m^2] about the axis, centre_of_mass_height [m]: of the glass without liquid. liquid_mass [kg],
liquid_density [kg/m^3], bowl_radius, bowl_height (of the bowl's bottom above the table), bowl_depth [m]. force_offset [m]:
height of the hand's force above the centre of mass. orbit_radius [m], orbit_speed [m/s], orbit_acceleration [m/s^2], clockwise
(bool, seen from above). friction_coefficient; with stribeck=True (bool) the kinetic one, beside static_coefficient,
friction_decay_speed [m/s] and viscous_friction [s/m]. gravity [m/s^2]. Defaults: the values of Motion().as_dict().)");
  motion.def(py::init([=](const py::kwargs &values) { return changed(M(), values); }))
    .def(
      "replace", [=](const M &one, const py::kwargs &values) { return changed(one, values); },
      "Returns a copy with other values: replace(mass=0.25).")
    .def("as_dict", as_dict, "Returns the arguments of Motion() with their values.")
    .def_property_readonly("normal_force", &M::normal_force, "m g of glass and liquid [N]")
    .def("__repr__", [=](const M &one) { return "Motion(**" + std::string(py::str(as_dict(one))) + ")"; })
    .def(py::pickle(as_dict, [=](const py::dict &values) { return changed(M(), values); }));
  for (const auto &[name, number] : numbers)
    motion.def_property_readonly(name.c_str(), [number = number](M one) { return number(one); });
}

void bind_loads(py::module_ &m)
{
  using R = LeaningLoad;
  py::class_<R>(
    m, "RingStack",
    R"(Normal load on concentric rings, lambda_j(theta) = sum_n a_jn cos n theta + b_jn sin n theta [N/rad].

theta: counter-clockwise from the direction of travel. radii [m]: (J,); a, b [N/rad]: (J, n_max + 1); tilt [rad]: (2,), tilts of
the table about x and y in the frame of the glass, which give the lean torque -tilt.moment [N m] on the glass.)")
    .def(py::init(&stack_of), py::kw_only(), "radii"_a, "a"_a, "b"_a,
         "tilt"_a = Eigen::Vector2d(Eigen::Vector2d::Zero()))
    .def_static(
      "first_harmonic",
      [](double force, const Eigen::Vector2d &moment, double radius)
      { return R{ RingStack::first_harmonic(force, moment, radius) }; },
      py::kw_only(), "normal_force"_a, "moment"_a, "radius"_a,
      "Returns one ring with harmonics 0 and 1 for the normal force [N] and the moment (M_x, M_y) [N m].")
    .def_property_readonly(
      "radii", [](const R &one) { return numpy_of(one.radii()); }, "[m], (J,)")
    .def_property_readonly("a", &rows<&RingStack::Ring::a>, "[N/rad], (J, n_max + 1)")
    .def_property_readonly("b", &rows<&RingStack::Ring::b>, "[N/rad], (J, n_max + 1)")
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
         "Returns the sum of the rings at theta [rad], an array [N/rad].")
    .def("__repr__", [](const R &one)
         { return sentence("RingStack(", one.rings().size(), " rings, ", one.normal_force(), " N)"); });

  py::class_<BalancedRing>(m, "SelfConsistentRing",
                           R"(Rigid ring whose load, friction and hand force balance at every spin.

closure: moments in the balance: "paper" (centripetal part of the hand force), "hand" (whole hand force), "full" (friction too).
radius [m]. exponent: None for harmonics 0 and 1 only, exact for a linear support in full contact; 1 for a flat rim that may lift off
a mat, 1.5 for a round rim, with n_harmonics.)")
    .def(py::init(&balanced_ring), py::kw_only(), "motion"_a, "closure"_a = "full", "radius"_a = 0.03,
         "exponent"_a = py::none(), "n_harmonics"_a = 128)
    .def_readonly("motion", &BalancedRing::motion)
    .def_readonly("radius", &BalancedRing::radius)
    .def("load", &BalancedRing::load, "omega"_a, "Returns the RingStack in balance at a spin [rad/s].");

  using B = SlidingBody;
  using Profile = std::function<Eigen::VectorXd(const Eigen::VectorXd &)>;
  py::class_<B>(m, "Pressure", R"(Axisymmetric normal pressure p(r) between the radii inner and outer [m].

p takes an array of radii [m] and returns an array in any unit: only its shape counts. Gauss points are clustered at both radii
and at v / |omega|, where friction is singular; a RingStack of as many rings has an error of 1e-4 there.)")
    .def(py::init(
           [](const Profile &p, double inner, double outer)
           {
             const auto at = [p](const Row &radii)
             {
               const Eigen::VectorXd values =
                 p(Eigen::Map<const Eigen::VectorXd>(radii.data(), static_cast<Eigen::Index>(radii.size())));
               return Row(values.begin(), values.end());
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
  bind_failures(m);
  bind_motion(m);
  bind_loads(m);
  py::class_<FrictionLaw, LawInPython>(m, "FrictionLaw",
                                       "Base class of friction laws: override coefficient(self, slip_speed).")
    .def(py::init<>())
    .def("coefficient", &FrictionLaw::coefficient, "slip_speed"_a, "Returns mu at a slip speed [m/s].");
  py::class_<StribeckLaw, FrictionLaw>(m, "Stribeck",
                                       "Friction law mu(u) = kinetic + (static - kinetic) exp(-(u / "
                                       "decay_speed)^decay_exponent) + viscous u.\n\n"
                                       "u: slip speed [m/s]; decay_speed [m/s], viscous [s/m].")
    .def(py::init(
           [](double s, double k, double v, double c, double p) {
             return StribeckLaw({ s, k, v, c, p });
           }),
         py::kw_only(), "static"_a, "kinetic"_a, "decay_speed"_a, "viscous"_a = 0., "decay_exponent"_a = 2.);
  m.def("kernels", &kernels);
  py::class_<Friction>(m, "Friction")
    .def(py::init<const LeaningLoad &, const FrictionLaw &>(), py::keep_alive<1, 3>())
    .def(py::init<const SlidingBody &, double, double, double, double, double>())
    .def(py::init<const BalancedRing &>())
    .def("wrench", [](const Friction &one, const Array &x, const Array &y, const Array &omega)
         { return wrenches(one.at, x, y, omega); })
    .def("slide", &slide);

  PYBIND11_NUMPY_DTYPE(TerminalSpin, omega, torque_slope, time_constant, stable, held);
  PYBIND11_NUMPY_DTYPE(YawSample, time, yaw_angle, omega);
  PYBIND11_NUMPY_DTYPE(SlidingState, time, x, y, yaw, speed, heading, omega, friction_loss, distance);
  m.def("answer", &answer_about);
  m.def("yaw_motion", &motion_of);
}
