// stemware._ring: the Coulomb ring for Python, of ring_model, pybind11 and numpy alone. Arrays of equal shape
// come in (stemware/ring.py broadcasts them), arrays of that shape go out. SI units.

#include "ring_model/free_sliding.h"
#include "ring_model/friction_kernels.h"
#include "ring_model/friction_law.h"
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

/// A function that lets Ctrl-C through 20 times a second, in loops without the GIL.
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

/// @p function that lets Ctrl-C through at each call.
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

/// Numbers, or plain structs as a structured array.
template <typename Value>
py::array_t<Value> numpy_of(const std::vector<Value> &values)
{
  return py::array_t<Value>(static_cast<py::ssize_t>(values.size()), values.data());
}

/// Array (..., n): @p write(to, values...) fills its n numbers for each entry of the arrays, which are of one
/// size.
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

/// Array (..., 3) of T_x, T_y, tau_z.
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

/// P_n, K_n, U_n: (..., 3 (n_max + 1)).
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

/// Law of friction written in Python: slow, but any.
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

/// The coefficients a or b, ring by ring.
template <Row RingStack::Ring::*row>
py::array rows(const LeaningLoad &load)
{
  std::vector<Row> all;
  for (const RingStack::Ring &ring : load.rings())
    all.push_back(ring.*row);
  return py::cast(all);
}

/// Friction on a load that moves with the velocity (v_x, v_y) [m/s] in its own frame and spins [rad/s].
struct Friction
{
  /// The law has to outlive it. Kernels want the slip along x.
  Friction(const LeaningLoad &load, const FrictionLaw &law)
  {
    at = [load, &law](double v_x, double v_y, double omega)
    {
      const double speed = std::hypot(v_x, v_y), angle = std::atan2(v_y, v_x);
      const auto friction = friction_functionals(law, load.radii(), load.n_harmonics(), omega, speed);
      if (v_y == 0. && v_x >= 0.)
        return friction(load);
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
  std::function<Wrench(double, double, double)> at;
};

/// Rigid ring that still has its motion and radius, which the C++ class keeps to itself.
struct BalancedRing
{
  Motion motion;
  double radius;
  SelfConsistentRing ring;
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

/// Load of a Question: a stack, which does not react to the spin, a ring in balance, or a function.
struct AskedLoad : LoadFromFunction
{
  using Function = std::function<LeaningLoad(double)>;
  explicit AskedLoad(const Function &load)
      : LoadFromFunction(interruptible(load))
  {
  }
};

/// The spin reached from rest, all balances, torque of table and lean at rest [N m], v / R [rad/s], spin-up.
py::tuple answer_about(const AskedLoad &load, const Motion &motion, double grip_torque, bool all,
                       const Row &times)
{
  motion.validate();
  Question question{ motion, grip_torque };
  question.with_slope = true;
  question.with_minima = false;
  question.all_spins = all;
  question.times = times;
  const Answer found = without_gil([&] { return answer(load, question); });
  if (found.fall && times.empty())
    throw BalanceLost(found.reason, found.fall->omega, true);
  found.value();
  std::vector<TerminalSpin> reached;
  if (found.terminal)
    reached.push_back(*found.terminal);
  return py::make_tuple(numpy_of(reached), numpy_of(found.all_spins),
                        found.at_rest->friction.torque + found.at_rest->lean_torque, load.spin_scale(motion),
                        numpy_of(found.spin_up));
}

py::array motion_of(const PhasedTorqueFunction &torque, double yaw_inertia, const Row &times,
                    double initial_spin, double accuracy, double spin_scale)
{
  const auto at = interruptible(torque);
  return numpy_of(
    without_gil([&] { return yaw_motion(at, yaw_inertia, initial_spin, times, accuracy, spin_scale); }));
}

py::tuple slide(const Friction &friction, const SlidingInertia &inertia, double speed, double omega,
                double accuracy)
{
  const auto along = interruptible(SlidingFriction([&](double v, double w) { return friction.at(v, 0, w); }));
  const SlidingPath path = without_gil([&] { return slide_to_stop(inertia, along, speed, omega, accuracy); });
  return py::make_tuple(numpy_of(path.states), path.final_slip_ratio);
}

/// Exceptions of physics; what() is the sentence. BalanceLost keeps its last spin: that takes a translator of
/// its own, which pybind11 asks first because it comes last.
void bind_failures(py::module_ &m)
{
  py::register_exception<std::invalid_argument>(m, "BadInput", PyExc_ValueError).doc() =
    "A value that is not allowed; the message says which, what is allowed and what to do.";
  const auto base = py::register_exception<NoBalance>(m, "NoBalance", PyExc_RuntimeError);
  py::register_exception<Tipping>(m, "Tipping", base);
  py::register_exception<NoTerminalSpin>(m, "NoTerminalSpin", base);
  static const py::handle lost = py::exception<BalanceLost>(m, "BalanceLost", base).release();
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
  static const std::map<std::string, double M::*> numbers = {
    { "mass", &M::mass },
    { "yaw_inertia", &M::yaw_inertia },
    { "centre_of_mass_height", &M::centre_of_mass_height },
    { "force_offset", &M::force_offset },
    { "orbit_radius", &M::orbit_radius },
    { "orbit_speed", &M::orbit_speed },
    { "orbit_acceleration", &M::orbit_acceleration },
    { "friction_coefficient", &M::friction_coefficient },
    { "static_coefficient", &M::static_coefficient },
    { "friction_decay_speed", &M::friction_decay_speed },
    { "viscous_friction", &M::viscous_friction },
    { "gravity", &M::gravity }
  };
  static const std::map<std::string, double Liquid::*> of_liquid = { { "liquid_mass", &Liquid::mass },
                                                                     { "liquid_density", &Liquid::density },
                                                                     { "bowl_radius", &Liquid::bowl_radius },
                                                                     { "bowl_height", &Liquid::bowl_height },
                                                                     { "bowl_depth", &Liquid::bowl_depth } };
  const auto as_dict = [](const M &one)
  {
    py::dict all("clockwise"_a = one.orbit_sense == OrbitSense::clockwise,
                 "stribeck"_a = one.friction_law == FrictionLawKind::stribeck);
    for (const auto &[name, member] : numbers)
      all[name.c_str()] = one.*member;
    for (const auto &[name, member] : of_liquid)
      all[name.c_str()] = one.liquid.*member;
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
        one.*(number->second) = value.cast<double>();
      else if (const auto entry = of_liquid.find(name); entry != of_liquid.end())
        one.liquid.*(entry->second) = value.cast<double>();
      else
        throw py::type_error("a motion has no " + name + "; see Motion().as_dict()");
    one.validate();
    return one;
  };
  py::class_<M> motion(m, "Motion",
                       "The glass and how the hand leads it: Motion(mass=0.3, ...) in SI units, as listed by "
                       "as_dict(); clockwise and stribeck are True or False. Defaults: the paper's glass.");
  motion.def(py::init([=](const py::kwargs &values) { return changed(M(), values); }))
    .def("replace", [=](const M &one, const py::kwargs &values) { return changed(one, values); })
    .def("as_dict", as_dict)
    .def_property_readonly("normal_force", &M::normal_force, "m g of glass and liquid [N]")
    .def("__repr__", [=](const M &one) { return "Motion(**" + std::string(py::str(as_dict(one))) + ")"; })
    .def(py::pickle(as_dict, [=](const py::dict &values) { return changed(M(), values); }));
  for (const auto &[name, member] : numbers)
    motion.def_readonly(name.c_str(), member);
  for (const auto &[name, member] : of_liquid)
    motion.def_property_readonly(name.c_str(),
                                 [member = member](const M &one) { return one.liquid.*member; });
}

void bind_loads(py::module_ &m)
{
  using R = LeaningLoad;
  py::class_<R>(
    m, "RingStack",
    "Normal load on concentric rings, lambda_j(theta) = sum_n a_jn cos n theta + b_jn sin n theta "
    "[N/rad], theta counter-clockwise from the direction of travel.\n\nradii [m]: (J,); a, b [N/rad]: "
    "(J, n_max + 1); tilt [rad]: of the table in the frame of the glass, which turns the glass by "
    "the lean torque -tilt.moment.")
    .def(py::init(&stack_of), py::kw_only(), "radii"_a, "a"_a, "b"_a,
         "tilt"_a = Eigen::Vector2d(Eigen::Vector2d::Zero()))
    .def_static(
      "first_harmonic",
      [](double force, const Eigen::Vector2d &moment, double radius)
      { return R{ RingStack::first_harmonic(force, moment, radius) }; },
      py::kw_only(), "normal_force"_a, "moment"_a, "radius"_a,
      "One ring whose first harmonic carries the normal force [N] with the moment (M_x, M_y) [N m].")
    .def_property_readonly(
      "radii", [](const R &one) { return numpy_of(one.radii()); }, "[m], (J,)")
    .def_property_readonly("a", &rows<&RingStack::Ring::a>, "[N/rad], (J, n_max + 1)")
    .def_property_readonly("b", &rows<&RingStack::Ring::b>, "[N/rad], (J, n_max + 1)")
    .def_readonly("tilt", &R::tilt, "[rad], (2,)")
    .def_property_readonly("lean_torque", &R::lean_torque, "-tilt.moment [N m]")
    .def_property_readonly("n_harmonics", &R::n_harmonics)
    .def_property_readonly("normal_force", &R::normal_force, "[N]")
    .def_property_readonly("radius", &R::radius, "Of the one ring of equal force, moment, harmonic 1 [m]")
    .def_property_readonly("moment", &R::moment, "(M_x, M_y) of the normal forces about the centre [N m]")
    .def_property_readonly("minimum", &R::minimum, "Least value of the sum of the rings [N/rad]")
    .def_property_readonly("pulling_force", &R::pulling_force, "[N]")
    .def("truncated", &R::truncated)
    .def("rotated",
         [](const R &one, double angle) {
           return R{ one.RingStack::rotated(angle), Eigen::Rotation2Dd(angle) * one.tilt };
         })
    .def("at", py::vectorize([](const R *one, double theta) { return (*one)(theta); }), "theta"_a,
         "Sum of the rings at theta [rad]: [N/rad].")
    .def("__repr__", [](const R &one)
         { return sentence("RingStack(", one.rings().size(), " rings, ", one.normal_force(), " N)"); });

  py::class_<BalancedRing>(
    m, "SelfConsistentRing",
    "Rigid ring whose load, friction and hand force balance at every spin. closure: paper, "
    "hand or full. exponent: None for a first harmonic (exact where the whole rim is on a "
    "linear support), 1 for a flat rim that may lift off a mat, 1.5 for a round one.")
    .def(py::init(&balanced_ring), py::kw_only(), "motion"_a, "closure"_a = "full", "radius"_a = 0.03,
         "exponent"_a = py::none(), "n_harmonics"_a = 128)
    .def_readonly("motion", &BalancedRing::motion)
    .def_readonly("radius", &BalancedRing::radius)
    .def("load", [](const BalancedRing &one, double omega) { return LeaningLoad{ one.ring.at(omega).load }; })
    .def("wrench", [](const BalancedRing &one, const Array &omega)
         { return wrenches([&](double w) { return one.ring.at(w).friction; }, omega); });

  using B = SlidingBody;
  using Profile = std::function<Eigen::VectorXd(const Eigen::VectorXd &)>;
  py::class_<B>(
    m, "Pressure",
    "Normal pressure p(r) that is the same all round, between two radii [m], of any unit: only its shape "
    "counts. p takes an array of radii. Integrated by Gauss points that lie closest at both radii and at "
    "v / |omega|, where points of the contact rest and friction is singular; a RingStack of as many rings "
    "has an error of 1e-4 there.")
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
    .def_static("ring", &B::ring, "radius"_a)
    .def_static("annulus", &B::annulus, "inner"_a, "outer"_a)
    .def_static("disc", &B::disc, "radius"_a)
    .def_property_readonly("radius", &B::outer_radius, "Outer radius [m]")
    .def("mean_power", &B::mean_power, "exponent"_a,
         "Mean of r^exponent over the normal force [m^exponent].");
}

} // namespace

PYBIND11_MODULE(_ring, m)
{
  bind_failures(m);
  bind_motion(m);
  bind_loads(m);
  py::class_<FrictionLaw, LawInPython>(m, "FrictionLaw",
                                       "Subclasses have coefficient(self, slip_speed [m/s]).")
    .def(py::init<>())
    .def("coefficient", &FrictionLaw::coefficient, "slip_speed"_a);
  py::class_<StribeckLaw, FrictionLaw>(
    m, "Stribeck",
    "kinetic + (static - kinetic) exp(-(u / decay_speed)^decay_exponent) + viscous u, u: slip speed [m/s]")
    .def(py::init(
           [](double s, double k, double v, double c, double p) {
             return StribeckLaw({ s, k, v, c, p });
           }),
         py::kw_only(), "static"_a, "kinetic"_a, "decay_speed"_a, "viscous"_a = 0., "decay_exponent"_a = 2.);
  m.def("kernels", &kernels);
  py::class_<Friction>(m, "Friction")
    .def(py::init<const LeaningLoad &, const FrictionLaw &>(), py::keep_alive<1, 3>())
    .def(py::init<const SlidingBody &, double, double, double, double, double>())
    .def("wrench", [](const Friction &one, const Array &x, const Array &y, const Array &omega)
         { return wrenches(one.at, x, y, omega); })
    .def("slide",
         [](const Friction &one, double mass, double yaw_inertia, double radius, double v, double omega,
            double accuracy) {
           return slide(one, { mass, yaw_inertia, radius }, v, omega, accuracy);
         });

  PYBIND11_NUMPY_DTYPE(TerminalSpin, omega, torque_slope, time_constant, stable, held);
  PYBIND11_NUMPY_DTYPE(YawSample, time, yaw_angle, omega);
  PYBIND11_NUMPY_DTYPE(SlidingState, time, x, y, yaw, speed, heading, omega, friction_loss, distance);
  py::class_<AskedLoad, std::shared_ptr<AskedLoad>>(m, "AskedLoad")
    .def(py::init([](const LeaningLoad &load) { return AskedLoad([=](double) { return load; }); }))
    .def(py::init(
      [](const BalancedRing &one)
      { return AskedLoad([ring = one.ring](double omega) -> LeaningLoad { return ring.at(omega).load; }); }))
    .def(py::init<const AskedLoad::Function &>());
  m.def("answer", &answer_about);
  m.def("yaw_motion", &motion_of);
}
