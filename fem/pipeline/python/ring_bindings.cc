// stemware._ring: the Coulomb ring for Python. Needs ring_model (Eigen, Boost), pybind11 and numpy; no
// deal.II, no files. Arrays of equal shape come in (stemware/ring.py broadcasts them), arrays of that shape
// go out. SI units.

#include "ring_model/free_sliding.h"
#include "ring_model/friction_kernels.h"
#include "ring_model/friction_law.h"
#include "ring_model/load/require.h"
#include "ring_model/self_consistent_ring.h"
#include "ring_model/unilateral_foundation.h"
#include "ring_model/yaw_motion.h"

#include <Eigen/Geometry>

#include <chrono>
#include <map>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <variant>

namespace py = pybind11;
using namespace py::literals;
using namespace stemware::ring;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Row = std::vector<double>;
using Shape = std::vector<py::ssize_t>;
using WithoutGil = py::gil_scoped_release;

namespace
{

/// Lets Ctrl-C through 20 times a second, in loops without the GIL.
class Interruption
{
public:
  void check()
  {
    using namespace std::chrono_literals;
    const auto now = std::chrono::steady_clock::now();
    if (now < next)
      return;
    next = now + 50ms;
    const py::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
  }

private:
  std::chrono::steady_clock::time_point next = std::chrono::steady_clock::now();
};

/// @p function that lets Ctrl-C through at each call.
template <typename Result, typename... Arguments>
std::function<Result(Arguments...)> interruptible(std::function<Result(Arguments...)> function)
{
  return [function = std::move(function), interruption = Interruption()](Arguments... values) mutable
  {
    interruption.check();
    return function(values...);
  };
}

Array numpy_of(const Row &row)
{
  return Array(static_cast<py::ssize_t>(row.size()), row.data());
}

/// (T_x, T_y, tau_z), arrays of the common shape of @p values; @p wrench_at takes as many numbers.
template <typename WrenchAt, typename... Arrays>
py::tuple wrenches(const WrenchAt &wrench_at, const Array &first, const Arrays &...others)
{
  const auto n = static_cast<std::size_t>(first.size());
  require(((others.size() == first.size()) && ...), "the arrays differ in size; broadcast them first");
  const Shape shape(first.shape(), first.shape() + first.ndim());
  Array x(shape), y(shape), torque(shape);
  double *to[] = { x.mutable_data(), y.mutable_data(), torque.mutable_data() };
  {
    const WithoutGil released;
    Interruption interruption;
    for (std::size_t i = 0; i < n; ++i)
    {
      interruption.check();
      const Wrench one = wrench_at(first.data()[i], others.data()[i]...);
      to[0][i] = one.force_x;
      to[1][i] = one.force_y;
      to[2][i] = one.torque;
    }
  }
  return py::make_tuple(x, y, torque);
}

/// P_n, K_n, U_n: (..., n_max + 1, 3).
Array kernels(const Array &rim_speed, const Array &speed, unsigned int n_max)
{
  const auto n_values = static_cast<std::size_t>(rim_speed.size());
  require(speed.size() == rim_speed.size(), "the arrays differ in size; broadcast them first");
  Shape shape(rim_speed.shape(), rim_speed.shape() + rim_speed.ndim());
  shape.insert(shape.end(), { static_cast<py::ssize_t>(n_max) + 1, 3 });
  Array out(shape);
  double *to = out.mutable_data();
  const WithoutGil released;
  Interruption interruption;
  for (std::size_t i = 0; i < n_values; ++i)
  {
    interruption.check();
    const FrictionKernels one(rim_speed.data()[i], speed.data()[i], n_max);
    for (unsigned int n = 0; n <= n_max; ++n, to += 3)
    {
      to[0] = one.P(n);
      to[1] = one.K(n);
      to[2] = one.U(n);
    }
  }
  return out;
}

/// Law of friction written in Python: slow, but any.
struct LawInPython : FrictionLaw
{
  double coefficient(double slip_speed) const override
  {
    PYBIND11_OVERRIDE_PURE(double, FrictionLaw, coefficient, slip_speed); // takes the GIL
  }
};

/// Rings of a load, and the lean of the glass on it, whose torque belongs to the load.
struct Stack : RingStack
{
  Stack(RingStack rings, const Eigen::Vector2d &tilt = Eigen::Vector2d::Zero())
      : RingStack(std::move(rings))
      , tilt(tilt)
  {
  }
  Eigen::Vector2d tilt; ///< (q1, q2) of the table in the frame of the glass [rad]
  double lean_torque() const { return -tilt.dot(moment()); }
};

Stack stack_of(const Row &radii, const std::vector<Row> &a, const std::vector<Row> &b,
               const std::pair<double, double> &tilt)
{
  require(radii.size() == a.size() && a.size() == b.size(), "there are ", radii.size(), " radii, ", a.size(),
          " rows of a and ", b.size(), " of b; give equally many");
  std::vector<RingStack::Ring> rings;
  for (std::size_t j = 0; j < radii.size(); ++j)
    rings.push_back({ radii[j], a[j], b[j] });
  return Stack(RingStack(std::move(rings)), { tilt.first, tilt.second });
}

std::pair<double, double> pair_of(const Eigen::Vector2d &vector)
{
  return { vector.x(), vector.y() };
}

/// Friction on @p load that moves with the velocity (v_x, v_y) in its own frame: kernels want the slip along
/// x.
Wrench moving_wrench(const RingStack &load, const FrictionLaw &law, double velocity_x, double velocity_y,
                     double omega)
{
  const double speed = std::hypot(velocity_x, velocity_y), angle = std::atan2(velocity_y, velocity_x);
  const auto friction = friction_functionals(law, load.radii(), load.n_harmonics(), omega, speed);
  if (velocity_y == 0. && velocity_x >= 0.)
    return friction(load);
  const Wrench one = friction(load.rotated(-angle));
  const double c = std::cos(angle), s = std::sin(angle);
  return { one.torque, c * one.force_x - s * one.force_y, s * one.force_x + c * one.force_y };
}

Closure closure_named(const std::string &name)
{
  for (const Closure one : { Closure::paper, Closure::hand, Closure::full })
    if (to_string(one) == name)
      return one;
  throw std::invalid_argument("the closure is \"" + name + "\", but must be paper, hand or full");
}

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
  return { motion, radius, SelfConsistentRing(closure_named(closure), motion, model) };
}

/// Loads whose spin is asked for. A stack does not react to the spin, a ring in balance does, a function of
/// omega [rad/s] gives the torque [N m] by itself. (pybind11 makes the first alternative by default, which a
/// stack does not allow; a function must come last: anything with __call__ would be taken for one.)
using Load = std::variant<std::monostate, Stack, BalancedRing, TorqueFunction>;

TorqueFunction torque_of(const Load &load, const Motion &motion)
{
  if (const auto *stack = std::get_if<Stack>(&load))
    return interruptible(TorqueFunction(
      [stack, motion](double omega) { return wrench(motion, *stack, omega).torque + stack->lean_torque(); }));
  if (const auto *ring = std::get_if<BalancedRing>(&load))
    return interruptible(TorqueFunction([ring](double omega) { return ring->ring.torque(omega); }));
  require(load.index() == 3,
          "the load is None; give a RingStack, a SelfConsistentRing or a function of omega");
  return interruptible(std::get<TorqueFunction>(load));
}

double radius_of(const Load &load, std::optional<double> radius)
{
  require(radius || load.index() != 3, "a torque that is a function has no radius; give one");
  if (const auto *stack = std::get_if<Stack>(&load); stack && !radius)
    return stack->radius();
  return radius ? *radius : std::get<BalancedRing>(load).radius;
}

py::dict as_dict(const TerminalSpin &spin)
{
  return py::dict("omega"_a = spin.omega, "torque_slope"_a = spin.torque_slope,
                  "time_constant"_a = spin.time_constant, "stable"_a = spin.stable, "held"_a = spin.held);
}

/// Last of @p n_steps equal steps from rest to @p end at which the load is in balance.
double reach(const TorqueFunction &torque, double end)
{
  const int n_steps = 48;
  int i = 1;
  try
  {
    for (; i <= n_steps; ++i)
      torque(end * i / n_steps);
  }
  catch (const NoBalance &)
  {
  }
  return end * (i - 1) / n_steps;
}

/// The spin reached from rest, and all balances within 1.5 v / R where @p all.
py::dict answer(const Load &load, const Motion &motion, double grip_torque, bool all,
                std::optional<double> radius)
{
  motion.validate();
  const TorqueFunction torque = torque_of(load, motion);
  const SpinSearch search{ motion.orbit_speed / radius_of(load, radius), {}, grip_torque };
  std::vector<TerminalSpin> spins;
  TerminalSpin spin;
  double at_rest = 0;
  {
    const WithoutGil released;
    at_rest = torque(0.);
    spin = terminal_spin(torque, motion.yaw_inertia, search);
    for (const double sense : all ? Row{ -1., 1. } : Row()) // the grip jumps at rest
    {
      const double near = sense * 1e-12 * search.spin_scale,
                   far = reach(torque, sense * 1.5 * search.spin_scale);
      const auto on_one_side = [&](double w) { return torque(w) - sense * grip_torque; };
      if (std::abs(far) > std::abs(near))
        for (const TerminalSpin &one : all_terminal_spins(on_one_side, motion.yaw_inertia,
                                                          std::min(near, far), std::max(near, far), 200))
          spins.push_back(one);
      if (sense < 0 && spin.held)
        spins.push_back(spin);
    }
  }
  py::dict found = as_dict(spin);
  found["torque_at_rest"] = at_rest;
  found["spin_scale"] = search.spin_scale;
  found["all"] = py::list();
  for (const TerminalSpin &one : spins)
    found["all"].attr("append")(as_dict(one));
  return found;
}

/// The members of plain structs as arrays by their names.
template <typename Struct>
py::dict columns(const std::vector<Struct> &rows,
                 const std::vector<std::pair<const char *, double Struct::*>> &members)
{
  py::dict all;
  for (const auto &[name, member] : members)
  {
    Array column(static_cast<py::ssize_t>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
      column.mutable_at(static_cast<py::ssize_t>(i)) = rows[i].*member;
    all[name] = column;
  }
  return all;
}

py::dict motion_of(const PhasedTorqueFunction &torque, double yaw_inertia, const Row &times,
                   double initial_spin, double accuracy, double spin_scale)
{
  std::vector<YawSample> samples;
  {
    const WithoutGil released;
    samples = yaw_motion(interruptible(torque), yaw_inertia, initial_spin, times, accuracy, spin_scale);
  }
  return columns<YawSample>(
    samples,
    { { "time", &YawSample::time }, { "yaw_angle", &YawSample::yaw_angle }, { "omega", &YawSample::omega } });
}

py::dict spin_up(const Load &load, const Motion &motion, const Row &times, double grip, double initial_spin,
                 double accuracy, std::optional<double> radius)
{
  const TorqueFunction torque = torque_of(load, motion);
  const auto sum = [&](double, double, double omega)
  {
    const double of_table = torque(omega);
    return of_table - (omega == 0. ? std::clamp(of_table, -grip, grip) : std::copysign(grip, omega));
  };
  return motion_of(sum, motion.yaw_inertia, times, initial_spin, accuracy,
                   motion.orbit_speed / radius_of(load, radius));
}

py::dict slide(const SlidingFriction &friction, const SlidingInertia &inertia, double speed, double omega,
               double accuracy)
{
  SlidingPath path;
  {
    const WithoutGil released;
    path = slide_to_stop(inertia, interruptible(friction), speed, omega, accuracy);
  }
  using S = SlidingState;
  py::dict all = columns<S>(path.states, { { "time", &S::time },
                                           { "x", &S::x },
                                           { "y", &S::y },
                                           { "yaw", &S::yaw },
                                           { "speed", &S::speed },
                                           { "heading", &S::heading },
                                           { "omega", &S::omega },
                                           { "friction_loss", &S::friction_loss },
                                           { "distance", &S::distance } });
  all["final_slip_ratio"] = path.final_slip_ratio;
  return all;
}

/// Exceptions of physics; what() is the sentence. BalanceLost keeps its last spin, and the failure behind it
/// as __cause__: that takes a translator of its own, which pybind11 asks first because it comes last.
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
        try
        {
          std::rethrow_if_nested(one);
        }
        catch (const std::exception &cause)
        {
          raised.attr("__cause__") = py::handle(PyExc_RuntimeError)(cause.what());
        }
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
  const auto as_dict = [](const M &one)
  {
    py::dict all("clockwise"_a = one.orbit_sense == OrbitSense::clockwise,
                 "stribeck"_a = one.friction_law == FrictionLawKind::stribeck);
    for (const auto &[name, member] : numbers)
      all[name.c_str()] = one.*member;
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
      else
        throw py::type_error("a motion has no " + name + "; see Motion().as_dict()");
    one.validate();
    return one;
  };
  py::class_<M> motion(m, "Motion",
                       "The glass and how the hand leads it: Motion(mass=0.3, ...) in SI units, as listed by "
                       "as_dict(); clockwise and stribeck are True or False. Defaults: the paper's glass.");
  motion.def(py::init([changed](const py::kwargs &values) { return changed(M(), values); }))
    .def(
      "replace", [changed](const M &one, const py::kwargs &values) { return changed(one, values); },
      "The same motion with other values.")
    .def("as_dict", as_dict, "All values by name.")
    .def_property_readonly("normal_force", &M::normal_force, "m g [N]")
    .def("__repr__",
         [as_dict](const M &one) { return "Motion(**" + std::string(py::str(as_dict(one))) + ")"; })
    .def(py::pickle(as_dict, [changed](const py::dict &values) { return changed(M(), values); }));
  for (const auto &[name, member] : numbers)
    motion.def_readonly(name.c_str(), member);
}

/// Body under a pressure that Python gives: arrays go in and out.
SlidingBody pressure_of(const std::function<Array(const Array &)> &p, double inner, double outer)
{
  const auto pressure = [p](const Row &radii)
  {
    const py::gil_scoped_acquire gil;
    const Array values = p(numpy_of(radii));
    return Row(values.data(), values.data() + values.size());
  };
  return SlidingBody::with_pressure(pressure, inner, outer);
}

void bind_loads(py::module_ &m)
{
  using R = Stack;
  const auto rows = [](const R &one, bool cosines)
  {
    std::vector<Row> all;
    for (const RingStack::Ring &ring : one.rings())
      all.push_back(cosines ? ring.a : ring.b);
    return py::array(py::cast(all));
  };
  py::class_<R>(
    m, "RingStack",
    "Normal load on concentric rings, lambda_j(theta) = sum_n a_jn cos n theta + b_jn sin n theta "
    "[N/rad], theta counter-clockwise from the direction of travel.\n\nradii [m]: (J,); a, b [N/rad]: "
    "(J, n_max + 1); tilt [rad]: of the table in the frame of the glass, which turns the glass by "
    "the lean torque -tilt.moment.")
    .def(py::init(&stack_of), py::kw_only(), "radii"_a, "a"_a, "b"_a, "tilt"_a = std::pair(0., 0.))
    .def_static(
      "first_harmonic",
      [](double force, const std::pair<double, double> &moment, double radius) {
        return R(RingStack::first_harmonic(force, { moment.first, moment.second }, radius));
      },
      py::kw_only(), "normal_force"_a, "moment"_a, "radius"_a,
      "One ring whose first harmonic carries the normal force [N] with the moment (M_x, M_y) [N m].")
    .def_property_readonly(
      "radii", [](const R &one) { return numpy_of(one.radii()); }, "[m], (J,)")
    .def_property_readonly(
      "a", [rows](const R &one) { return rows(one, true); }, "[N/rad], (J, n_max + 1)")
    .def_property_readonly(
      "b", [rows](const R &one) { return rows(one, false); }, "[N/rad], (J, n_max + 1)")
    .def_property_readonly(
      "tilt", [](const R &one) { return pair_of(one.tilt); }, "[rad]")
    .def_property_readonly("lean_torque", &R::lean_torque, "-tilt.moment [N m]")
    .def_property_readonly("n_harmonics", [](const R &one) { return one.n_harmonics(); })
    .def_property_readonly(
      "normal_force", [](const R &one) { return one.normal_force(); }, "[N]")
    .def_property_readonly(
      "radius", [](const R &one) { return one.radius(); },
      "Radius of the one ring with the same force, moment and first harmonic [m]")
    .def_property_readonly(
      "moment", [](const R &one) { return pair_of(one.moment()); },
      "(M_x, M_y) of the normal forces about the centre [N m]")
    .def_property_readonly(
      "minimum", [](const R &one) { return one.minimum(); }, "Least value of the sum of the rings [N/rad]")
    .def_property_readonly(
      "pulling_force", [](const R &one) { return one.pulling_force(); }, "[N]")
    .def(
      "truncated",
      [](const R &one, unsigned int n_max) { return R(one.RingStack::truncated(n_max), one.tilt); },
      "n_max"_a, "The load without its harmonics above n_max.")
    .def(
      "rotated",
      [](const R &one, double angle)
      { return R(one.RingStack::rotated(angle), Eigen::Rotation2Dd(angle) * one.tilt); },
      "angle"_a, "The load turned counter-clockwise by an angle [rad].")
    .def("at", py::vectorize([](const R *one, double theta) { return (*one)(theta); }), "theta"_a,
         "Sum of the rings at theta [rad]: [N/rad].")
    .def("__repr__", [](const R &one)
         { return sentence("RingStack(", one.rings().size(), " rings, ", one.normal_force(), " N)"); })
    .def(py::pickle(
      [](const R &one)
      { return py::make_tuple(one.coefficients(one.n_harmonics()), one.rings().size(), pair_of(one.tilt)); },
      [](const py::tuple &state)
      {
        const auto tilt = state[2].cast<std::pair<double, double>>();
        return R(RingStack::from_coefficients(state[0].cast<Row>(), state[1].cast<std::size_t>()),
                 { tilt.first, tilt.second });
      }));

  py::class_<BalancedRing>(
    m, "SelfConsistentRing",
    "Rigid ring whose load, friction and hand force balance at every spin. closure: paper, "
    "hand or full. exponent: None for a first harmonic (exact where the whole rim is on a "
    "linear support), 1 for a flat rim that may lift off a mat, 1.5 for a round one.")
    .def(py::init(&balanced_ring), py::kw_only(), "motion"_a, "closure"_a = "full", "radius"_a = 0.03,
         "exponent"_a = py::none(), "n_harmonics"_a = 128)
    .def_readonly("motion", &BalancedRing::motion)
    .def_readonly("radius", &BalancedRing::radius)
    .def(
      "load", [](const BalancedRing &one, double omega) { return Stack(one.ring.at(omega).load); }, "omega"_a,
      "RingStack in balance at a spin [rad/s].")
    .def(
      "wrench",
      [](const BalancedRing &one, const Array &omega)
      { return wrenches([&](double w) { return one.ring.at(w).friction; }, omega); },
      "omega"_a);

  using B = SlidingBody;
  py::class_<B>(
    m, "Pressure",
    "Normal pressure p(r) that is the same all round, between two radii [m], of any unit: only its shape "
    "counts. p takes an array of radii. Integrated by Gauss points that gather at both radii and at "
    "v / |omega|, where points of the contact rest and friction is singular; a RingStack of as many rings "
    "has an error of 1e-4 there.\n\nPressure(p, inner, outer), Pressure.disc(radius), "
    "Pressure.annulus(inner, outer), Pressure.hertz(radius), Pressure.ring(radius)")
    .def(py::init(&pressure_of), "p"_a, "inner"_a, "outer"_a)
    .def_static("ring", &B::ring, "radius"_a)
    .def_static("annulus", &B::annulus, "inner"_a, "outer"_a)
    .def_static("disc", &B::disc, "radius"_a)
    .def_static(
      "hertz",
      [](double radius)
      {
        const auto root = [radius](const Row &radii)
        {
          Row values;
          for (const double r : radii)
            values.push_back(std::sqrt(std::max(0., (radius - r) * (radius + r))));
          return values;
        };
        return B::with_pressure(root, 0., radius);
      },
      "radius"_a)
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
                                       "Coefficient of friction over the slip speed: a subclass has "
                                       "coefficient(self, slip_speed [m/s]).")
    .def(py::init<>())
    .def("coefficient", &FrictionLaw::coefficient, "slip_speed"_a);
  py::class_<StribeckLaw, FrictionLaw>(
    m, "Stribeck",
    "kinetic + (static - kinetic) exp(-(u / decay_speed)^decay_exponent) + "
    "viscous u at the slip speed u [m/s]")
    .def(py::init(
           [](double s, double k, double v, double c, double p) {
             return StribeckLaw({ s, k, v, c, p });
           }),
         py::kw_only(), "static"_a, "kinetic"_a, "decay_speed"_a, "viscous"_a = 0., "decay_exponent"_a = 2.);
  m.def(
    "coulomb",
    [](double mu) {
      return StribeckLaw({ mu, mu, 1. });
    },
    "mu"_a, "Law with the same coefficient at every slip speed.");
  m.def("kernels", &kernels);
  m.def("stack_wrench",
        [](const Stack &load, const FrictionLaw &law, const Array &x, const Array &y, const Array &omega)
        {
          return wrenches([&](double v_x, double v_y, double w)
                          { return moving_wrench(load, law, v_x, v_y, w); },
                          x, y, omega);
        });
  m.def("pressure_wrench",
        [](const SlidingBody &body, double mu, double force, const Array &speed, const Array &omega)
        {
          const FreeSlider one{ body, force, 1., mu, 1. };
          one.validate();
          return wrenches([&](double v, double w) { return sliding_friction(one, v, w); }, speed, omega);
        });
  m.def("answer", &answer, "load"_a, py::kw_only(), "motion"_a, "grip_torque"_a = 0., "all"_a = true,
        "radius"_a = py::none());
  m.def("spin_up", &spin_up, "load"_a, py::kw_only(), "motion"_a, "times"_a, "grip_torque"_a = 0.,
        "initial_spin"_a = 0., "accuracy"_a = 1e-9, "radius"_a = py::none());
  m.def(
    "yaw_motion", &motion_of, "torque"_a, py::kw_only(), "yaw_inertia"_a, "times"_a, "initial_spin"_a = 0.,
    "accuracy"_a = 1e-9, "spin_scale"_a,
    "time, yaw_angle, omega: arrays at the times [s] from I d omega/dt = torque(time, yaw_angle, omega).");
  m.def("slide_pressure",
        [](const SlidingBody &body, double mu, double mass, double inertia, double speed, double omega,
           double gravity, double height, double accuracy)
        {
          const FreeSlider one{ body, mass, inertia, mu, gravity, height };
          one.validate();
          return slide([one](double v, double w) { return sliding_friction(one, v, w); },
                       { mass, inertia, body.outer_radius() }, speed, omega, accuracy);
        });
  m.def(
    "slide_stack",
    [](const Stack &load, double mu, double mass, double inertia, double speed, double omega, double accuracy)
    {
      return slide([&](double v, double w) { return coulomb_wrench(mu, load, w, v); },
                   { mass, inertia, load.radius() }, speed, omega, accuracy);
    });
}
