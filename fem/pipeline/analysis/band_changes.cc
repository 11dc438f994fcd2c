#include "fem/pipeline/analysis/error_bands.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/coupling/revolution_setup.h"
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

/// Safety factor for changes to another mesh or degree. With an error of first order, the change to a mesh
/// with twice the cell size equals the error, so the factor adds a margin of 25 %.
constexpr double usual_factor = 1.25;

/// Safety factor for the two changes of add_lines(): the larger change may be only half of the error.
constexpr double factor_of_lines = 2.5;

/// Minimum number of elastic harmonics for a comparison of meshes.
constexpr unsigned int min_harmonics = 4;

Variant changed(Variant copy, const std::function<void(Variant &)> &change)
{
  change(copy);
  return copy;
}

/// Returns the contribution of @p variant to @p part of the error band: @p factor times the difference
/// between the results of @p variant and of a reference. The reference is the first variant of part @p from,
/// or the study if @p from is empty.
BandChange change_of(const std::string &part, double factor, Variant variant, const std::string &from = "",
                     bool compares_over_spins = false)
{
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

/// Number of rings that suffices unless the slip ratio is close to 1.
constexpr unsigned int usual_rings = 5;

/// Returns @p n_rings >= 2 Chebyshev radii on the interval whose Chebyshev radii are @p radii.
std::vector<double> radii_on_band_of(const std::vector<double> &radii, unsigned int n_rings)
{
  const double middle = (radii.back() + radii.front()) / 2, reach = (radii.back() - radii.front()) / 2;
  const double half = reach / std::cos(ring::pi / 2 / static_cast<double>(radii.size()));
  return chebyshev_radii(middle - half, middle + half, n_rings);
}

/// Adds changes of the numbers of rings and harmonics: other projections of the existing contact pressure,
/// without a new moment balance. A new balance would change the spin about as much as the projection does, so
/// the factor is 2. With two or more rings, the largest change over @p ring_counts is used.
void add_ring_projections(const Variant &own_study, const ElasticFoot &foot,
                          const std::vector<unsigned int> &ring_counts, std::vector<BandChange> &changes)
{
  constexpr double with_balance = 2;
  const auto project =
    [&](const std::string &part, const std::vector<double> &radii, unsigned int n_harmonics)
  {
    BandChange &change = changes.emplace_back(change_of(part, with_balance, own_study));
    change.shared = Shared::load;
    change.ring_radii = radii;
    change.n_harmonics = n_harmonics;
  };
  const unsigned int n = foot.n_harmonics(), resolved = foot.body().n_resolved_harmonics();
  const std::vector<double> &own = foot.ring_radii();
  project("load_harmonics", own, n < resolved ? std::min(2 * n, resolved) : std::max(n / 2, 1u));
  if (own.size() < 2)
  {
    changes.push_back(change_of("rings", usual_factor, own_study));
    changes.back().shared = Shared::contact;
    changes.back().study.contact.rings = usual_rings;
    return;
  }
  for (const unsigned int n_rings : ring_counts)
  {
    project("rings", radii_on_band_of(own, n_rings), n);
    changes.back().is_alternative = true;
  }
}

/// Adds two changes: four times and three times as many contact lines. If the load ends between two lines,
/// the error has either sign, depending on the distance from the contact edge to the next line. A single
/// change could therefore vanish by chance.
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
  const ContactSection &contact = own.study.contact;
  const bool is_hard = own.study.table.is_hard();
  std::vector<BandChange> changes;
  const auto with_harmonics = [&](unsigned int n)
  { return changed(own, [=](Variant &variant) { variant.study.contact.harmonics = n; }); };
  const unsigned int n_harmonics = contact.harmonics;
  Variant fewer = own;
  std::string from;
  if (n_harmonics > 1)
  {
    from = "harmonics";
    fewer = with_harmonics(n_harmonics / 2);
    changes.push_back(change_of(from, 0.5, fewer));
  }
  // To save time, meshes are compared with only a quarter of the elastic harmonics: the relative error due to
  // the mesh is the same with all harmonics.
  if (n_harmonics >= 4 * min_harmonics)
  {
    from = "few harmonics";
    fewer = with_harmonics(n_harmonics / 4);
    changes.push_back(change_of(from, 0, fewer));
  }
  const Variant coarse = changed(fewer, [](Variant &variant) { variant.discretisation.fineness /= 2; });
  changes.push_back(change_of("mesh", usual_factor, coarse, from));
  // At re-entrant corners far from the contact the error is of first order, so the change to halved cells is
  // half of the error.
  if (revolution_setup(own).resolution.has_focus())
    changes.push_back(change_of(
      "mesh", 2, changed(fewer, [](Variant &variant) { ++variant.discretisation.halvings_beyond_zone; }),
      from));
  // A higher degree removes the same error as smaller cells, so it is an alternative. On a hard table the
  // cells are small, and a higher degree is expensive. The degree is therefore raised on the coarse mesh,
  // where the change due to the degree is larger than on the mesh of the study.
  if (contact.degree < 4)
  {
    changes.push_back(is_hard ? change_of("mesh", usual_factor, changed(coarse, raise_degree), "mesh")
                              : change_of("mesh", usual_factor, changed(fewer, raise_degree), from));
    changes.back().is_alternative = true;
  }
  if (!is_full)
    add_lines(
      own, [](Variant &variant, unsigned int factor) { variant.study.contact.azimuth_lines *= factor; },
      changes);
  if (is_hard)
    changes.push_back(change_of("interface", 1.5, changed(own, harden)));
  // The study is compared with three other numbers of rings: if the slip vanishes between two rings, the
  // error has either sign, and a single change could vanish by chance.
  const auto n_rings = static_cast<unsigned int>(foot.ring_radii().size());
  add_ring_projections(own, foot, { 2 * n_rings, 2 * n_rings + 1, 4 * n_rings }, changes);
  return changes;
}

/// Study on a coarser mesh. `ratio`: its cell size over the study's cell size, minimum over the directions.
struct CoarserStudy
{
  Variant variant;
  double ratio = 2;
};

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
    // The halved number of cells is rounded up to a multiple of @p multiple: with multiple = 2, 6 cells
    // become 4.
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

/// Returns a factor on the compliance of the interface. The factor represents the indentation of the glass
/// that cells of size @p cell do not resolve. A line load p on a contact of half-width b < cell causes the
/// indentation 2 (1 - nu^2) / (pi E) p ln(cell / b) of the glass and p / (2 b k) of an interface of stiffness
/// k (Johnson, Contact Mechanics, 1985, section 4.2).
double softening_by_narrow_contact(const fem::ElasticMaterial &glass, const fem::Table &table,
                                   const LoadReport &load, double cell)
{
  const double b = load.half_width(), nu = glass.poisson_ratio;
  const double pressure = load.a(0) / load.radius() / (2 * b);
  const double indentation = 2 * (1 - nu * nu) / (ring::pi * glass.young_modulus) * std::log(cell / b);
  return 1 + indentation * 2 * b * table.interface->stiffness_at(pressure);
}

std::vector<BandChange> changes_of_solid(const Variant &own, const ElasticFoot &foot,
                                         const LoadReport &at_rest, bool is_full)
{
  const ContactSection &contact = own.study.contact;
  const GlassSection &glass = own.study.glass;
  const fem::Table table = own.study.table.make();
  const bool is_hard = table.interface->is_hard();
  const double cell = foot.body().description().contact_cell_size;
  // A flat land is in contact at its edges, where a generated mesh has smaller cells. Only a crowned land or
  // a mesh file can therefore have a contact narrower than a cell.
  const bool is_round = !contact.mesh_file.empty() || glass.profile.crown_radius > 0;
  const bool is_narrow = is_round && at_rest.half_width() < cell;
  if (is_narrow && is_hard)
    throw BadInput("the contact is narrower than the mesh's cells");
  const auto is_affordable = [](const Variant &finer)
  { return size_of(finer.study).memory <= finer.study.contact.memory_limit; };
  std::vector<BandChange> changes;
  const std::optional<CoarserStudy> coarse = on_coarser_mesh(own);
  const Variant finer = changed(own, [](Variant &variant) { ++variant.study.contact.refinements; }),
                quadratic = changed(own, raise_degree);
  // With an error of first order, the error equals the change from a mesh with twice the cell size, or twice
  // the change to halved cells. The safety factors are 1.5 and 1.25, respectively.
  if (coarse)
    changes.push_back(change_of("mesh", 1.5 / (coarse->ratio - 1), coarse->variant, "", true));
  else if (contact.degree == 2 && is_affordable(finer))
    changes.push_back(change_of("mesh", 2.5, finer, "", true));
  else if (contact.degree == 2)
    changes.push_back(
      change_of("degree", 1, changed(own, [](Variant &variant) { variant.study.contact.degree = 1; })));
  if (contact.degree == 1 && is_affordable(quadratic))
    changes.push_back(change_of("degree", usual_factor, quadratic));
  if (changes.empty())
    throw BadInput("quadratic elements would exceed Contact/Memory limit");
  const Variant &cheapest = coarse ? coarse->variant : own;
  const std::string as_cheapest = coarse ? "mesh" : "";
  // If the contact is narrower than a cell, the change to halved cells does not bound the error: each further
  // halving adds the same indentation until the cells resolve the contact.
  if (is_narrow)
    changes.push_back(change_of("mesh", usual_factor,
                                changed(cheapest,
                                        [&](Variant &variant) {
                                          variant.discretisation.hardness /=
                                            softening_by_narrow_contact(glass.material, table, at_rest, cell);
                                        }),
                                as_cheapest, true));
  if (cheapest.uses_penalty_for_hard_table())
    changes.push_back(change_of("interface", 2, changed(cheapest, harden), as_cheapest));
  else if (own.uses_penalty_for_hard_table())
    changes.push_back(change_of("interface", 2, changed(own, harden)));
  // The number of contact lines affects the results only if the contact edge crosses element faces. With a
  // mesh file, this always happens; with a generated mesh, only if the rim lifts off. Contact with nodal
  // multipliers has no contact lines.
  if ((!is_full || !contact.mesh_file.empty()) && (!is_hard || own.uses_penalty_for_hard_table()))
    add_lines(
      own, [](Variant &variant, unsigned int factor) { variant.discretisation.line_factor *= factor; },
      changes);
  // The number of rings is reduced instead of increased: if the contact is much narrower than the node
  // spacing, the moment balance extrapolates from the rings to the nodes, and an extrapolation from more
  // rings amplifies rounding errors.
  const auto n_rings = static_cast<unsigned int>(foot.ring_radii().size());
  add_ring_projections(own, foot, { n_rings == 2 ? usual_rings : n_rings - 1 }, changes);
  return changes;
}

} // namespace

std::vector<BandChange> band_changes(const ElasticFoot &foot, const LoadReport &at_rest, bool is_full)
{
  Variant own = { foot.specification() };
  own.kind = VariantKind::parameter;
  own.shared = Shared::rings;
  return own.study.contact.is_of_revolution() ? changes_of_revolution(own, foot, is_full)
                                              : changes_of_solid(own, foot, at_rest, is_full);
}

} // namespace stemware::pipeline
