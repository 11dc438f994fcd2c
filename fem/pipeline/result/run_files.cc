#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/result/common_sections.h"
#include "fem/pipeline/result/curves.h"
#include "ring_model/load/constants.h"

#include <cmath>

namespace stemware::pipeline
{

namespace
{

constexpr char azimuth[] = "azimuth from the direction of travel";

/// Returns the load lambda_j(theta) of one ring [N/rad]. Single rings may have a negative mean a_0.
double value_of(const ring::RingStack::Ring &ring, double angle)
{
  double value = ring.a[0];
  for (std::size_t n = 1; n < ring.a.size(); ++n)
    value += ring.a[n] * std::cos(static_cast<double>(n) * angle) +
             ring.b[n] * std::sin(static_cast<double>(n) * angle);
  return value;
}

struct Coefficient
{
  std::size_t ring;
  double radius;
  unsigned int n;
  double a, b;
};

/// Returns lambda(theta) round the rim: the sum of the rings, its first harmonic, and each of several rings.
Table load_table(const ring::RingStack &load)
{
  constexpr unsigned int n_intervals = 720;
  std::vector<double> angles;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    angles.push_back(2 * ring::pi * i / n_intervals);
  Fields<double> fields = {
    { "theta", "rad", "", [](double angle) { return angle; }, in_file("theta", azimuth) },
    { "load", "N/rad", "", load, in_file("lambda, all harmonics", "load at rest, all harmonics") },
    { "load_first_harmonic", "N/rad", "", load.truncated(1),
      in_file("lambda, first harmonic", "load at rest, first harmonic") }
  };
  if (load.rings().size() > 1)
    for (const ring::RingStack::Ring &ring : load.rings())
      fields.add({ "load_at_radius_*", "N/rad", "", [=](double angle) { return value_of(ring, angle); },
                   in_file("lambda, ring of radius * m", "load at rest of the ring of radius * m"),
                   with_number(to_short_text(ring.radius)) });
  return fields.table(angles, Face::file);
}

/// Returns the coefficients of each ring: lambda_j(theta) = a_0 + sum a_n cos(n theta) + b_n sin(n theta).
Table ring_table(const ring::RingStack &load)
{
  std::vector<Coefficient> rows;
  for (std::size_t j = 0; j < load.rings().size(); ++j)
    for (unsigned int n = 0; n <= load.n_harmonics(); ++n)
    {
      const ring::RingStack::Ring &ring = load.rings()[j];
      rows.push_back({ j + 1, ring.radius, n, ring.a[n], ring.b[n] });
    }
  return Fields<Coefficient>{
    { "ring", "1", "", &Coefficient::ring, in_file("ring j", "ring, counted from 1") },
    { "radius", "m", "", &Coefficient::radius, in_file("r_j", "radius of the ring") },
    { "n", "1", "", &Coefficient::n, in_file("n", "harmonic") },
    { "a", "N/rad", "", &Coefficient::a, in_file("a_n", "cosine coefficient") },
    { "b", "N/rad", "", &Coefficient::b, in_file("b_n", "sine coefficient") }
  }.table(rows, Face::file);
}

/// Returns lambda(theta) at rest at the azimuths of the contact's lines, 0 on unloaded lines.
Table pointwise_table(const std::vector<fem::AzimuthValue> &pointwise)
{
  using Line = fem::AzimuthValue;
  return Fields<Line>{
    { "theta", "rad", "", &Line::azimuth, in_file("theta", azimuth) },
    { "load", "N/rad", "", &Line::value, in_file("lambda", "load at rest on the lines of the contact") }
  }.table(pointwise, Face::file);
}

/// Returns p(r, theta), one row per point, cut by cut.
Table footprint_table(const fem::PressureMap &footprint)
{
  using Point = fem::PressurePoint;
  std::vector<Point> points;
  for (const auto &cut : footprint.cuts)
    points.insert(points.end(), cut.begin(), cut.end());
  return Fields<Point>{
    { "radius", "m", "", &Point::radius, in_file("r", "radius") },
    { "theta", "rad", "", &Point::azimuth, in_file("theta", azimuth) },
    { "pressure", "Pa", "", &Point::pressure, in_file("pressure", "pressure of the foot on the table") }
  }.table(points, Face::file);
}

/// Returns the Newton steps of the contact at rest.
Table history_table(const std::vector<fem::ContactIteration> &history)
{
  using Step = fem::ContactIteration;
  return Fields<Step>{
    { "step", "1", "", &Step::number, in_file("step", "Newton step") },
    { "loaded_places", "1", "", &Step::n_loaded, in_file("loaded places", "loaded places") },
    { "changed_places", "1", "", &Step::n_changed,
      in_file("changed places", "places that changed between loaded and free") },
    { "residual", "1", "", &Step::residual,
      in_file("relative imbalance of forces", "relative imbalance of forces") },
    { "step_length", "1", "", &Step::step_length, in_file("share of the step taken", "step length") },
    { "linear_iterations", "1", "", &Step::linear_iterations,
      in_file("iterations of the linear solver", "iterations of the linear solver") }
  }.table(history, Face::file);
}

void add_foot_files(const FootReport &foot, const std::vector<fem::FieldFile> &fields, bool has_terminal_spin,
                    std::vector<ResultFile> &files)
{
  files.push_back({ "footprint.csv", "pressure p(r, θ) of the foot on the table at rest",
                    footprint_table(foot.footprint) });
  if (foot.footprint_at_end && has_terminal_spin)
    files.push_back(
      { "footprint_at_end.csv", "the same at the terminal spin", footprint_table(*foot.footprint_at_end) });
  files.push_back(
    { "contact_history.csv", "Newton steps of the contact", history_table(foot.at_rest.history) });
  const auto add = [&](const std::string &name, const char *state)
  {
    files.push_back({ "fields/" + name, "displacement, strain, stress and contact pressure " +
                                          std::string(state) + ", for ParaView" });
  };
  for (const fem::FieldFile &file : fields)
  {
    if (file.name == "contact.vtu" || file.name == "contact.pvtu") // pieces of contact.pvtu are not listed
      add(file.name, "at rest");
    if (file.name.find("_at_terminal_spin") != std::string::npos)
      add(file.name, "at the terminal spin");
  }
}

} // namespace

std::string load_file_text(const ring::RingStack &load)
{
  std::vector<Coefficient> rows;
  for (unsigned int n = 0; n <= load.n_harmonics(); ++n)
    rows.push_back({ 0, load.radius(), n, load.a(n), load.b(n) });
  const auto amplitude = [&](const Coefficient &row) { return std::hypot(row.a, row.b) / load.a(0); };
  const auto crest = [](const Coefficient &row) { return row.n == 0 ? 0 : std::atan2(row.b, row.a) / row.n; };
  const Fields<Coefficient> fields = { { "n", "1", "", &Coefficient::n, in_file("n", "") },
                                       { "a", "N/rad", "", &Coefficient::a, in_file("a_n", "") },
                                       { "b", "N/rad", "", &Coefficient::b, in_file("b_n", "") },
                                       { "amplitude", "1", "", amplitude, in_file("amplitude / a_0", "") },
                                       { "crest", "rad", "", crest, in_file("direction of a crest", "") } };
  return "# ring radius: " + to_text(load.radius()) + " (m)\n" +
         data_table(
           fields.table(rows, Face::file, "lambda(theta) = a_0 + sum a_n cos(n theta) + b_n sin(n theta)"));
}

std::vector<ResultFile> run_files(const StudyAnswer &answer)
{
  const auto &[study, goal, contact, spin, bands, budget, fields] = answer;
  const ring::RingStack &rings = contact.load;
  std::vector<ResultFile> files = { { "summary.json", "all numbers, for programs" },
                                    { "parameters.prm", "the study as input file" },
                                    { "load.csv", "λ(θ) at rest", load_table(rings) },
                                    { "harmonics.dat", "its Fourier coefficients, readable by Load/File",
                                      load_file_text(rings) },
                                    { "rings.csv", "the same ring by ring", ring_table(rings) } };
  const auto add = [&](const char *name, const char *words, const Table &table) {
    files.push_back({ name, words, table });
  };
  if (budget)
  {
    add("budget.csv", "the terminal spin from the paper's model to this study's",
        chain_fields().table(budget->rows, Face::file));
    add("without.csv", "the complete model without one effect at a time",
        without_fields().table(budget->without, Face::file));
  }
  add("torque.csv", "τ_z, T_x, T_y against the spin",
      torque_columns(spin.torque).table(points_of(spin.torque.omega.size()), Face::file));
  add("spin_up.csv", "the spin against time",
      spin_up_columns(spin.spin_up).table(points_of(spin.spin_up.time.size()), Face::file));
  add("truncation.csv", "the answer with 1, 2, 3, 4, 6, 8 ... harmonics",
      truncation_fields().table(truncations_of(answer.spin), Face::file));
  if (const auto &driven = spin.spin_up.driven)
    add("driven_spin_up.csv", "the spin against time under the speeds of the file",
        driven_columns(*driven).table(points_of(driven->time.size()), Face::file));
  if (spin.phases)
    add("phases.csv", "τ_z by the orientation of glass and table",
        phase_columns(*spin.phases).table(points_of(spin.phases->phases.size()), Face::file));
  if (study.load.is_from_contact())
  {
    add("load_lines.csv", "λ(θ) at rest on the azimuth lines of the contact",
        pointwise_table(contact.load.pointwise));
    if (contact.foot)
      add_foot_files(*contact.foot, fields.files, spin.answer().terminal.has_value(), files);
  }
  files.push_back({ "timings.json", "how long it took" });
  return files;
}

} // namespace stemware::pipeline
