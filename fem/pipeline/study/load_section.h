#pragma once

#include "fem/pipeline/study/entry_facts.h"
#include "ring_model/load/ring_stack.h"

#include <memory>
#include <string>

namespace stemware::pipeline
{

enum class LoadSource
{
  contact,        ///< the finite-element contact
  first_harmonic, ///< the paper's ansatz, balanced at every spin; no finite elements
  file            ///< Fourier coefficients from a file
};

enum class LoadCoupling
{
  two_way, ///< contact, friction and moments are balanced at every spin
  one_way  ///< the load at omega = 0 is used at every spin
};

/// Subsection Load: source of lambda(theta).
struct LoadSection
{
  LoadSource source = LoadSource::contact;
  LoadCoupling coupling = LoadCoupling::two_way;
  double moment_ratio = -1;             ///< m = |M_N| / (N R / 2); negative: given by the moment balance
  double moment_direction = -1.5707963; ///< theta of the load's maximum [rad], used with moment_ratio >= 0
  std::string file;                     ///< Fourier coefficients, used with source = file
  std::shared_ptr<const ring::RingStack> from_file = {}; ///< load read from `file`

  bool is_from_contact() const { return source == LoadSource::contact; }
  /// Returns true if the moment is given, not computed from the moment balance.
  bool is_static() const { return moment_ratio >= 0; }
  /// Returns true if the moment balance gives the moment (no given moment, no load file).
  bool has_closure() const { return !is_static() && source != LoadSource::file; }
  /// Returns true if the load at rest is used at every spin: Coupling = one-way, given moment, or load file.
  bool is_one_way() const
  {
    return !has_closure() || (is_from_contact() && coupling == LoadCoupling::one_way);
  }
  /// Returns true if contact and friction are in balance at every spin; false for a given moment.
  bool is_in_balance() const { return is_from_contact() && !is_one_way(); }

  /// Declares the entries with their facts. A template, to be compiled in one file only.
  template <typename List>
  void declare(List &list)
  {
    list.enter("Load", true);
    list.choice("Source", source,
                { { "contact", LoadSource::contact },
                  { "first harmonic", LoadSource::first_harmonic },
                  { "file", LoadSource::file } },
                "contact: the finite-element contact; first harmonic: the paper's ansatz, in balance with "
                "the moment balance at every spin; file: Fourier coefficients from a file");
    list.choice(
      "Coupling", coupling, { { "two-way", LoadCoupling::two_way }, { "one-way", LoadCoupling::one_way } },
      "two-way: contact, friction and moments are in balance at every spin; one-way: the load of the glass "
      "that does not spin yet is kept at every spin, as a given moment and a load from a file are by nature",
      used_if(is_from_contact() && has_closure()));
    list.number("Moment ratio", moment_ratio, any_number, "1",
                "Moment of the table's pressure over N R / 2 for a static study; negative: the moment "
                "of the moment balance. The foot tips at 2, on a flat land of outer radius r_o at 2 r_o / R");
    list.number("Moment direction", moment_direction, any_number, "rad",
                "Where a static study's load is largest, counter-clockwise from the direction of travel; "
                "used with Moment ratio >= 0",
                used_if(is_static()), plausible(-6.2832, 6.2832, "one turn either way"));
    list.path("File", file,
              "Fourier coefficients for Source = file: a line \"# ring radius: 0.03 (m)\", then rows n a_n "
              "b_n (N/rad) for n = 0, 1, 2, ...; harmonics.dat of a results folder is such a file");
  }
};

} // namespace stemware::pipeline
