#include "fem/pipeline/analysis/band_changes.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/study/study_size.h"
#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace stemware::pipeline
{

namespace
{

/// Safety factor of changes that converge at least with first order.
constexpr double usual_factor = 1.25;

/// Safety factor of a change of contact lines under a load that ends between two lines: the larger of two
/// changes may be half of the error.
constexpr double factor_of_lines = 2.5;

/// Minimum number of elastic harmonics in a comparison of meshes.
constexpr unsigned int min_harmonics = 4;

using Setting = std::function<void(Variant &)>;

Variant changed(Variant copy, const Setting &change)
{
  change(copy);
  return copy;
}

/// Returns the change @p variant for the part @p part of the band, on its own foot, compared with @p from.
BandChange change_of(const std::string &part, double factor, Variant variant, const std::string &from = "",
                     bool compares_over_spins = false)
{
  variant.kind = VariantKind::parameter;
  return { std::move(variant), part, factor, from, compares_over_spins };
}

void raise_degree(Variant &variant)
{
  ++variant.study.contact.degree;
}

void harden(Variant &variant)
{
  variant.discretisation.hardness *= 10;
}

/// Number of rings that suffices except near slip ratio 1.
constexpr unsigned int usual_rings = 5;

/// Returns @p n_rings Chebyshev radii on the band whose Chebyshev radii are @p radii, at least two.
std::vector<double> radii_on_band_of(const std::vector<double> &radii, unsigned int n_rings)
{
  const double middle = (radii.back() + radii.front()) / 2, reach = (radii.back() - radii.front()) / 2;
  const double half = reach / std::cos(ring::pi / 2 / static_cast<double>(radii.size()));
  return chebyshev_radii(middle - half, middle + half, n_rings);
}

/// Adds other rings and harmonics for the pressure of the same contacts. These changes count twice, because
/// the friction force in the moment balance adds an error of the same size. @p ring_counts: numbers of rings
/// in place of the foot's (if that has at least two), of which the largest change counts. A single ring is
/// replaced by the rings of a study with Contact/Rings = usual_rings.
void add_ring_projections(const Variant &own_study, const ElasticFoot &foot,
                          const std::vector<unsigned int> &ring_counts, std::vector<BandChange> &changes)
{
  constexpr double with_balance = 2;
  const unsigned int n = foot.n_harmonics(), resolved = foot.body().n_resolved_harmonics();
  const std::vector<double> &own = foot.ring_radii();
  changes.push_back(change_of("load_harmonics", with_balance, own_study));
  changes.back().ring_projection = { own, n < resolved ? std::min(2 * n, resolved) : std::max(n / 2, 1u) };
  if (own.size() < 2)
  {
    changes.push_back(change_of("rings", usual_factor, own_study));
    changes.back().shared = Shared::contact;
    changes.back().study.contact.rings = usual_rings;
    return;
  }
  for (const unsigned int n_rings : ring_counts)
  {
    changes.push_back(change_of("rings", with_balance, own_study));
    changes.back().ring_projection = { radii_on_band_of(own, n_rings), n };
    changes.back().is_alternative = true;
  }
}

/// Adds changes to three and four times the contact lines, set by @p multiply(variant, factor). Under a load
/// that ends between two of N lines, the error depends on the position of the edge between them and has
/// either sign, so that a single other count may agree by chance.
void add_lines(const Variant &own, const std::function<void(Variant &, unsigned int factor)> &multiply,
               std::vector<BandChange> &changes)
{
  for (const unsigned int factor : { 4u, 3u })
  {
    changes.push_back(change_of("lines", factor_of_lines,
                                changed(own, [&](Variant &variant) { multiply(variant, factor); })));
    changes.back().is_alternative = true;
  }
}

std::vector<BandChange> changes_of_revolution(const Variant &own, const ElasticFoot &foot, bool is_full)
{
  const Study &study = own.study;
  std::vector<BandChange> changes;
  const auto with_harmonics = [&](unsigned int n)
  { return changed(own, [=](Variant &variant) { variant.study.contact.harmonics = n; }); };
  const unsigned int n_harmonics = study.contact.harmonics;
  Variant fewer = own;
  std::string from;
  if (n_harmonics > 1)
  {
    from = "harmonics";
    fewer = with_harmonics(n_harmonics / 2);
    changes.push_back(change_of(from, 0.5, fewer));
  }
  // Meshes are compared with a quarter of the harmonics: the higher ones are changed by a mesh in the same
  // way.
  if (n_harmonics >= 4 * min_harmonics)
  {
    from = "few harmonics";
    fewer = with_harmonics(n_harmonics / 4);
    changes.push_back(change_of(from, 0, fewer));
  }
  const Variant coarse = changed(fewer, [](Variant &variant) { variant.discretisation.fineness /= 2; });
  changes.push_back(change_of("mesh", usual_factor, coarse, from));
  // With the small cells of a hard table, a higher degree is tried on coarse cells, which gives an upper
  // bound.
  if (study.contact.degree < 4 && study.table.is_hard())
    changes.push_back(change_of("degree", usual_factor, changed(coarse, raise_degree), "mesh"));
  else if (study.contact.degree < 4)
    changes.push_back(change_of("degree", usual_factor, changed(fewer, raise_degree), from));
  // At re-entrant corners, far from the contact, the error is of first order: halved cells show half of it.
  if (has_focused_mesh(study, own.discretisation))
    changes.push_back(change_of(
      "mesh", 2, changed(fewer, [](Variant &variant) { ++variant.discretisation.halvings_beyond_zone; }),
      from));
  if (!is_full)
    add_lines(
      own, [](Variant &variant, unsigned int factor) { variant.study.contact.azimuth_lines *= factor; },
      changes);
  if (study.table.is_hard())
    changes.push_back(change_of("interface", 1.5, changed(own, harden)));
  // If the slip vanishes between two rings, the error depends on the position between them and has either
  // sign. A single other number of rings, or rings with common radii, may agree by chance.
  const auto n_rings = static_cast<unsigned int>(foot.ring_radii().size());
  add_ring_projections(own, foot, { 2 * n_rings, 2 * n_rings + 1, 4 * n_rings }, changes);
  return changes;
}

/// Study on a coarser mesh. @p ratio: smallest growth of the cells among the three directions.
struct CoarserStudy
{
  Variant variant;
  double ratio = 2;
};

/// Returns the study of a solid foot on cells about twice as large; std::nullopt if there is no such mesh.
std::optional<CoarserStudy> on_coarser_mesh(const Variant &own)
{
  CoarserStudy coarse = { own };
  ContactSection &contact = coarse.variant.study.contact;
  if (auto &halved = coarse.variant.discretisation.halved_cells; !halved.empty())
    halved.pop_back();
  else if (contact.refinements > 0)
    --contact.refinements;
  else if (contact.mesh_file.empty())
  {
    // Rounded up to an allowed count: 6 cells across the land become 4.
    const auto coarsen = [&](unsigned int &n, unsigned int multiple)
    {
      const unsigned int before = n;
      n = multiple * ((n / multiple + 1) / 2);
      coarse.ratio = std::min(coarse.ratio, static_cast<double>(before) / n);
    };
    fem::FootResolution &cells = contact.resolution;
    coarsen(cells.azimuthal_cells, 4);
    coarsen(cells.radial_cells, 2);
    coarsen(cells.foot_layers, 1);
    if (coarse.ratio < 1.5 || cells.azimuthal_cells < 8)
      return std::nullopt;
  }
  else
    return std::nullopt;
  return coarse;
}

/// Returns the factor on the compliance of the interface that represents the indentation of the glass which
/// cells of size @p cell do not resolve. Under a line load p on a band of half-width b < cell, this
/// indentation is 2 (1 - nu^2) / (pi E) p ln(cell / b), and the interface yields by p / (2 b k) (Johnson,
/// Contact Mechanics, 1985, section 4.2).
double softening_by_narrow_contact(const Study &study, const LoadReport &load, double cell)
{
  const double b = load.half_width(), nu = study.glass.material.poisson_ratio;
  const double pressure = load.rings.a(0) / load.rings.radius() / (2 * b);
  const double indentation =
    2 * (1 - nu * nu) / (ring::pi * study.glass.material.young_modulus) * std::log(cell / b);
  return 1 + indentation * 2 * b * study.table.make().interface->stiffness_at(pressure);
}

std::vector<BandChange> changes_of_solid(const Variant &own, const ElasticFoot &foot,
                                         const LoadReport &at_rest, bool is_full)
{
  const Study &study = own.study;
  const double cell = foot.body().description().contact_cell_size;
  // The contact of a flat land is at its edges, where a generated mesh has smaller cells.
  const bool is_round = !study.contact.mesh_file.empty() || study.glass.profile.crown_radius > 0;
  const bool is_narrow = is_round && at_rest.half_width() < cell;
  if (is_narrow && study.table.is_hard())
    throw BadInput("the contact is narrower than the mesh's cells");
  const auto is_affordable = [](const Variant &finer)
  { return size_of(finer.study).memory <= finer.study.contact.memory_limit; };
  std::vector<BandChange> changes;
  const std::optional<CoarserStudy> coarse = on_coarser_mesh(own);
  const Variant finer = changed(own, [](Variant &variant) { ++variant.study.contact.refinements; }),
                quadratic = changed(own, raise_degree);
  // First-order error: the change from a coarser mesh, or twice the change to halved cells.
  if (coarse)
    changes.push_back(change_of("mesh", 1.5 / (coarse->ratio - 1), coarse->variant, "", true));
  else if (study.contact.degree == 2 && is_affordable(finer))
    changes.push_back(change_of("mesh", 2.5, finer, "", true));
  else if (study.contact.degree == 2)
    changes.push_back(
      change_of("degree", 1, changed(own, [](Variant &variant) { variant.study.contact.degree = 1; })));
  if (study.contact.degree == 1 && is_affordable(quadratic))
    changes.push_back(change_of("degree", usual_factor, quadratic));
  if (changes.empty())
    throw BadInput("quadratic elements would exceed Contact/Memory limit");
  const Variant &cheapest = coarse ? coarse->variant : own;
  const std::string as_cheapest = coarse ? "mesh" : "";
  // Each halving of the cells adds the same amount to the indentation of a narrow contact.
  if (is_narrow)
    changes.push_back(change_of(
      "mesh", usual_factor,
      changed(cheapest, [&](Variant &variant)
              { variant.discretisation.hardness /= softening_by_narrow_contact(study, at_rest, cell); }),
      as_cheapest, true));
  if (uses_penalty_for_hard_table(cheapest.study, cheapest.discretisation))
    changes.push_back(change_of("interface", 2, changed(cheapest, harden), as_cheapest));
  else if (uses_penalty_for_hard_table(study, own.discretisation))
    changes.push_back(change_of("interface", 2, changed(own, harden)));
  // The contact edge crosses faces of a mesh file in any direction, and faces of a generated mesh with
  // lift-off. Nodal multipliers have no lines.
  if ((!is_full || !study.contact.mesh_file.empty()) &&
      (!study.table.is_hard() || uses_penalty_for_hard_table(study, own.discretisation)))
    add_lines(
      own, [](Variant &variant, unsigned int factor) { variant.discretisation.line_factor *= factor; },
      changes);
  // More rings would amplify rounding if the contact is far narrower than the spacing of the nodes, because
  // the rings are extrapolated to the nodes in the moment balance.
  const auto n_rings = static_cast<unsigned int>(foot.ring_radii().size());
  add_ring_projections(own, foot, { n_rings == 2 ? usual_rings : n_rings - 1 }, changes);
  return changes;
}

} // namespace

std::vector<BandChange> band_changes(const Study &study, const ElasticFoot &foot, const LoadReport &at_rest,
                                     bool is_full)
{
  const Variant own = own_variant(study, &foot);
  return abilities(study.contact.body).is_of_revolution ? changes_of_revolution(own, foot, is_full)
                                                        : changes_of_solid(own, foot, at_rest, is_full);
}

} // namespace stemware::pipeline
