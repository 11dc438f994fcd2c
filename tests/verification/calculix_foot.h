#pragma once

// Reference results in calculix_foot.json: elastic compliances by CalculiX (calculix_foot.py), contact solved
// in numpy.
#include <nlohmann/json.hpp>

#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace stemware::verification
{

struct CalculixLoad
{
  std::optional<double> modulus; ///< modulus of the mat [Pa/m]; std::nullopt: hard interface
  double moment_ratio, direction, friction, spin_per_speed;
  std::vector<double> a, b; ///< n = 0 ... 6

  std::string name() const
  {
    return (modulus ? "k = " + std::to_string(*modulus) : std::string("hard")) +
           ", m = " + std::to_string(moment_ratio) + ", mu = " + std::to_string(friction);
  }
};

/// Foot of @p kind "flat" (land 2 mm wide) or "crown" (land 4 mm wide, crown radius 3 mm).
struct CalculixFoot
{
  explicit CalculixFoot(const std::string &kind)
  {
    std::ifstream file(STEMWARE_CALCULIX_FOOT);
    const nlohmann::json foot = nlohmann::json::parse(file).at("feet").at(kind);
    normal = foot.at("compliance").at("zz").get<std::vector<double>>();
    radial = foot.at("compliance").at("zr").get<std::vector<double>>();
    azimuthal = foot.at("compliance").at("zt").get<std::vector<double>>();
    for (const auto &load : foot.at("loads"))
      loads.push_back({ load.at("k").is_null() ? std::nullopt : std::optional(load.at("k").get<double>()),
                        load.at("moment_ratio"), load.at("direction"), load.at("friction"), load.at("spin"),
                        load.at("a_over_a0"), load.at("b_over_a0") });
  }

  /// int u_z r dr over the land under a unit pressure or traction of harmonic n on the land [m^5/N].
  std::vector<double> normal, radial, azimuthal;
  std::vector<CalculixLoad> loads;
};

} // namespace stemware::verification
