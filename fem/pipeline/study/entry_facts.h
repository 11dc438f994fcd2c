#pragma once

namespace stemware::pipeline
{

/// Allowed numbers of an entry, with their description.
struct Range
{
  const char *words;
  bool (*contains)(double);
};

constexpr Range any_number = { "a finite number", [](double) { return true; } };
constexpr Range positive = { "a number greater than 0", [](double value) { return value > 0; } };
constexpr Range not_negative = { "a number not less than 0", [](double value) { return value >= 0; } };
constexpr Range poisson_range = { "a number greater than -1 and less than 0.5",
                                  [](double value) { return -1 < value && value < 0.5; } };

// Further facts of a declaration: each function sets the member of StudyEntry that has its name.

/// Sets StudyEntry::has_effect to @p condition, independent of the rest of its subsection.
constexpr auto used_if(bool condition)
{
  return [=](auto &entry) { entry.has_effect = condition; };
}

constexpr auto plausible(double least, double most, const char *from_what_to_what)
{
  return [=](auto &entry)
  {
    entry.plausible = { least, most };
    entry.plausible_reason = from_what_to_what;
  };
}

/// Declares bounds of a length over the contact radius; the defaults exclude only lengths in a wrong unit.
constexpr auto times_contact_radius(double least = 1e-5, double most = 300)
{
  return [=](auto &entry) { entry.times_contact_radius = { least, most }; };
}

constexpr auto follows_from_profile = [](auto &entry) { entry.follows_from_profile = true; };

} // namespace stemware::pipeline
