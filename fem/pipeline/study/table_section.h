#pragma once

#include "fem/contact/interface_law.h"
#include "fem/contact/table.h"
#include "fem/geometry/elastic_material.h"
#include "fem/pipeline/study/entry_facts.h"
#include "fem/pipeline/study/quantity_text.h"

namespace stemware::pipeline
{

/// Contact law between foot and table.
enum class TableInterface
{
  hard,    ///< Signorini's conditions: no penetration, no tension
  winkler, ///< pressure proportional to the penetration
  rough    ///< pressure exponential in the distance
};

/// Body under the table's interface.
enum class TableSubstrate
{
  rigid,
  elastic ///< a disc, held at its bottom
};

/// Subsection Table: an interface on a substrate.
struct TableSection
{
  TableInterface interface = TableInterface::rough;
  TableSubstrate substrate = TableSubstrate::elastic;
  double foundation_modulus = 1e10; ///< modulus of the Winkler interface [Pa/m]
  /// Thickness of the layer represented by a Winkler interface [m]; 0: not given.
  double layer_thickness = 0;
  fem::Roughness roughness;
  fem::TableDisc disc; ///< the elastic substrate
  fem::ElasticMaterial disc_material = { 10e9, 0.3 };
  Waviness waviness; ///< fixed to the ground: positive where the table is lower

  /// Makes the table for the finite elements; query it instead of the enumerations.
  fem::Table make() const;
  /// Returns true if the interface is rigid (Signorini's conditions).
  bool is_hard() const;

  /// Declares the entries with their facts. A template, to be compiled in one file only.
  template <typename List>
  void declare(List &list)
  {
    const bool has_contact = list.study.load.is_from_contact();
    const bool is_winkler = has_contact && interface == TableInterface::winkler;
    const bool is_rough = has_contact && interface == TableInterface::rough;
    const bool is_on_disc = has_contact && substrate == TableSubstrate::elastic;
    list.enter("Table", has_contact);
    list.choice("Interface", interface,
                { { "hard", TableInterface::hard },
                  { "Winkler", TableInterface::winkler },
                  { "rough", TableInterface::rough } },
                "How foot and table touch. hard: without penetration; Winkler: pressure proportional to the "
                "penetration, a layer much thinner than the contact is wide; rough: asperities, pressure "
                "exponential in the distance");
    list.choice("Substrate", substrate,
                { { "rigid", TableSubstrate::rigid }, { "elastic", TableSubstrate::elastic } },
                "What lies under the interface. elastic: a disc of a material of its own, held at its "
                "bottom: a table top, or a layer of cork (body of revolution only)");
    list.number("Foundation modulus", foundation_modulus, positive, "Pa/m",
                "Pressure of a Winkler interface per depth of penetration", used_if(is_winkler),
                plausible(1e7, 1e14, "5 cm of foam to a micrometre of dirt"));
    list.number(
      "Layer thickness", layer_thickness, not_negative, "m",
      "Thickness of the layer that a Winkler interface stands for, 0 where it stands for none. Changes no "
      "result: it lets the study say where the contact is too narrow for such an interface",
      used_if(is_winkler), plausible(0, 0.1, "a film to a cushion"));
    list.number("Reference pressure", roughness.reference_pressure, positive, "Pa",
                "Pressure of a rough interface where the mean planes of the two surfaces touch",
                used_if(is_rough), plausible(1e5, 1e11, "a tenth of the softer body's modulus"));
    list.number("Decay length", roughness.decay_length, positive, "m",
                "Distance over which a rough interface's pressure falls by e: half the rms roughness",
                used_if(is_rough), plausible(1e-9, 1e-4, "float glass to sawn wood: half the rms roughness"));
    list.number("Disc radius", disc.radius, positive, "m", "Radius of the disc of an elastic substrate",
                used_if(is_on_disc), times_contact_radius(),
                plausible(0.02, 3, "larger than the foot, up to a table"));
    list.number("Disc thickness", disc.thickness, positive, "m",
                "Thickness of that disc, which is held at its bottom", used_if(is_on_disc),
                times_contact_radius(0.001), plausible(1e-4, 0.5, "a tablecloth to a block"));
    list.number("Disc Young modulus", disc_material.young_modulus, positive, "Pa",
                "Young's modulus of the disc (hardwood 10e9, cork 5e6)", used_if(is_on_disc),
                plausible(1e5, 1.2e12, "foam to diamond"));
    list.number("Disc Poisson ratio", disc_material.poisson_ratio, poisson_range, "1",
                "Poisson's ratio of the disc (cork 0)", used_if(is_on_disc),
                plausible(-0.2, 0.499, "cork (0), wood (0.3), rubber (0.49)"));
    list.waviness(
      "Waviness", waviness,
      "How the table is out of flat: harmonics of its depth, fixed to the ground and positive where it is "
      "lower. At the start azimuth 0 points away from the orbit's centre. Body of revolution only");
  }
};

} // namespace stemware::pipeline
