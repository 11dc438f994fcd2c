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

/// On what converges faster than any order, or with the first order and more.
constexpr double usual_factor = 1.25;

/// On the change of contact lines under a load that ends between two of them: the larger of two changes may
/// be half of the error.
constexpr double factor_of_lines = 2.5;

/// Elastic harmonics that a comparison of meshes takes at least.
constexpr unsigned int min_harmonics = 4;

using Setting = std::function<void(Variant &)>;

Variant changed(Variant copy, const Setting &change)
{
  change(copy);
  return copy;
}

/// @p variant for the part @p part of the band, on a foot of its own, compared with @p from.
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

/// Number of rings that is enough everywhere but next to slip ratio 1.
constexpr unsigned int usual_rings = 5;

/// @p n_rings radii on the band of @p radii, which are chebyshev_radii(), two at least.
std::vector<double> radii_on_band_of(const std::vector<double> &radii, unsigned int n_rings)
{
  const double middle = (radii.back() + radii.front()) / 2, reach = (radii.back() - radii.front()) / 2;
  const double half = reach / std::cos(ring::pi / 2 / static_cast<double>(radii.size()));
  return chebyshev_radii(middle - half, middle + half, n_rings);
}

/// Other rings and harmonics that take over the pressure of the same contacts. What the friction force adds
/// in the balance is of the size of what they change: it counts twice. @p ring_counts: numbers of rings in
/// the place of the foot's, two at least, whose largest change counts; one ring becomes those of a study that
/// asks for usual_rings.
void add_gathering(const Variant &own_study, const ElasticFoot &foot,
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

/// Adds three and four times the lines along which the table law is integrated, set by @p multiply(variant,
/// factor). The error of N lines under a load that ends between two of them depends on the place of its edge
/// there, and is of both signs: one other count may agree by chance.
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
  // What a mesh changes is told with a quarter of the harmonics: beyond them a mesh changes what all others
  // share.
  if (n_harmonics >= 4 * min_harmonics)
  {
    from = "few harmonics";
    fewer = with_harmonics(n_harmonics / 4);
    changes.push_back(change_of(from, 0, fewer));
  }
  const Variant coarse = changed(fewer, [](Variant &variant) { variant.discretisation.fineness /= 2; });
  changes.push_back(change_of("mesh", usual_factor, coarse, from));
  // Where cells are small, a higher degree is tried on the coarse ones: that tells more than enough.
  if (study.contact.degree < 4 && study.table.is_hard())
    changes.push_back(change_of("degree", usual_factor, changed(coarse, raise_degree), "mesh"));
  else if (study.contact.degree < 4)
    changes.push_back(change_of("degree", usual_factor, changed(fewer, raise_degree), from));
  // At re-entrant corners, far from the contact, the error falls with the first order: halved cells show half
  // of it.
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
  // Where the slip vanishes between the rings, the error depends on the place between them and is of both
  // signs: one other number may agree by chance, and those with common radii too.
  const auto n_rings = static_cast<unsigned int>(foot.ring_radii().size());
  add_gathering(own, foot, { 2 * n_rings, 2 * n_rings + 1, 4 * n_rings }, changes);
  return changes;
}

// ---- solid

/// A study on a coarser mesh, whose cells are @p ratio times as large in the direction in which they grow
/// least.
struct CoarserStudy
{
  Variant variant;
  double ratio = 2;
};

/// The solid foot of @p study on cells about twice as large. Returns std::nullopt if its mesh has none.
std::optional<CoarserStudy> on_coarser_mesh(const Variant &own)
{
  CoarserStudy coarse = { own };
  ContactSection &contact = coarse.variant.study.contact;
  if (auto &halved = coarse.variant.discretisation.halved; !halved.empty())
    halved.pop_back();
  else if (contact.refinements > 0)
    --contact.refinements;
  else if (contact.mesh_file.empty())
  {
    // Rounded up to what a mesh can have: 6 cells across the land become 4.
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

/// How much more an interface yields that has the indentation of the glass which cells of size @p cell do not
/// know: of a band of half-width b < cell under a line load p, 2 (1 - nu^2) / (pi E) p ln(cell / b), beside
/// its own p / (2 b k) (the logarithm of a line contact: Johnson, Contact Mechanics, 1985, section 4.2).
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
  // A flat land touches with its edges, at which a generated mesh has smaller cells.
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
  // An error of first order is what halving the cells has taken from it, and twice what halving them will.
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
  // Each halving adds as much to a narrow contact's indentation as the one before.
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
  // The edge of the contact crosses faces of a mesh file in any direction, and those of a generated mesh with
  // lift-off. Nodal multipliers have no lines.
  if ((!is_full || !study.contact.mesh_file.empty()) &&
      (!study.table.is_hard() || uses_penalty_for_hard_table(study, own.discretisation)))
    add_lines(
      own, [](Variant &variant, unsigned int factor) { variant.discretisation.line_factor *= factor; },
      changes);
  // Where the contact is far narrower than the distance of nodes, whose weights in the balance of moments are
  // those of the rings extrapolated, more rings would show rounding.
  const auto n_rings = static_cast<unsigned int>(foot.ring_radii().size());
  add_gathering(own, foot, { n_rings == 2 ? usual_rings : n_rings - 1 }, changes);
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
