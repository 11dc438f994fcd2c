#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/base/json.h"
#include "fem/pipeline/coupling/load_report.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Numbers of the page's pictures: each function adds tables to a document and captions to its words. Angles
/// in degrees, lengths of a section in mm.
namespace stemware::pipeline
{

/// Words and tables of a page.
struct Pictures
{
  /// Texts by name, among them "title", "inputs" and "answer", and captions of pictures.
  nlohmann::ordered_json words = nlohmann::ordered_json::object();
  /// Columns of tables and pictures: {"keys": [...], "values": [[...] ...]} by name.
  nlohmann::ordered_json tables = nlohmann::ordered_json::object();

  /// Adds columns of numbers for a picture, with six digits.
  void add_columns(const std::string &name,
                   const std::vector<std::pair<std::string, std::vector<double>>> &columns);
};

/// Returns a number rounded to @p n_digits significant digits; null if it is not finite.
nlohmann::ordered_json shortened(double value, int n_digits = 6);
nlohmann::ordered_json shortened(const std::vector<double> &values, int n_digits = 6);

/// Adds "load_lines": pointwise load over its mean on the azimuth lines if the foot has lifted off, where the
/// series of the load overshoots; else null.
void add_load_lines(const LoadReport &load, Pictures &pictures);

/// Adds "slip_at_rest" or another @p name: slip and friction round the rim.
void add_slip_columns(const std::string &name, const ring::Motion &motion, double radius,
                      const ring::RingStack &load, double omega, Pictures &pictures);

/// Adds "motion": instants of a spin-up, each with the load over its mean at 48 places of the rim and the
/// friction at 24, the sense of its torque, the hand's force, and the torque that is left.
void add_motion(const Study &study, const std::vector<ring::Instant> &instants, Pictures &pictures);

/// Adds "torque": torque of friction with fewer and with all harmonics and, if given, of the paper's model.
void add_torque_columns(const TorqueCurve &curve, const std::vector<double> &of_paper, Pictures &pictures);

/// Adds "spin_up": spins with all harmonics, with the first @p n_first unless 0, and of the paper's model.
void add_spin_up_columns(const SpinUpCurves &curves, unsigned int n_first, Pictures &pictures);

/// Adds "phases": torque over the azimuth of the mark of the glass or the table.
void add_phase_columns(const PhaseStudy &phases, Pictures &pictures);

/// Returns p(r, theta) of @p footprint cut by cut, on a scale that ends at @p largest [Pa], with the load's
/// @p peak pressure and the error band of the peak at rest [Pa]; the band is left out up to a tenth of the
/// peak.
nlohmann::ordered_json pressure_map(const fem::PressureMap &footprint, double contact_radius, double largest,
                                    double peak, const std::optional<double> &band = {});

} // namespace stemware::pipeline
