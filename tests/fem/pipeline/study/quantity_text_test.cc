#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study_file.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/refusal.h"
#include "tests/ulps.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using Texts = std::vector<std::string>;

TEST(QuantityText, DecimalUnitsGiveTheNearestDouble)
{
  const std::vector<std::tuple<const char *, const char *, double>> cases = {
    { "300 g", "kg", 0.3 },
    { "300g", "kg", 0.3 },
    { "0.3", "kg", 0.3 },
    { "+300 g", "kg", 0.3 },
    { "30 mm", "m", 0.03 },
    { "0.3 mm", "m", 3e-4 },
    { "1.7 um", "m", 1.7e-6 },
    { "1.7 \u00b5m", "m", 1.7e-6 },
    { "1.7 \u03bcm", "m", 1.7e-6 },
    { "70 GPa", "Pa", 70e9 },
    { "7e4 MPa", "Pa", 7e10 },
    { "70e+3 N/mm^2", "Pa", 7e10 },
    { "70 kN/mm\u00b2", "Pa", 7e10 },
    { "10 GPa/m", "Pa/m", 1e10 },
    { "10 MPa/mm", "Pa/m", 1e10 },
    { "10 N/mm^3", "Pa/m", 1e10 },
    { "20 cm/s", "m/s", 0.2 },
    { "981 cm/s^2", "m/s^2", 9.81 },
    { "981 cm s^-2", "m/s^2", 9.81 },
    { "1.4 mN m", "N m", 1.4e-3 },
    { "1.4 N*mm", "N m", 1.4e-3 },
    { "3000 g cm^2", "kg m^2", 3e-4 },
    { "500 ms", "s", 0.5 },
    { "30 %", "1", 0.3 },
    { "30%", "1", 0.3 },
    { "8 GB", "B", 8e9 },
    { "1 bar", "Pa", 1e5 },
    { "\u22125 cm", "m", -0.05 }, // minus sign as in reports
    { "\u20135 cm", "m", -0.05 },
    { "5e\u22122 m", "m", 0.05 },
    { "300\u00a0g", "kg", 0.3 },
    { "\u00a0300\u2009g\u202f", "kg", 0.3 },
    { "3000 g\u202fcm^2", "kg m^2", 3e-4 },
  };
  for (const auto &[text, unit, expected] : cases)
    EXPECT_EQ(parse_quantity(text, unit), expected) << text;
}

TEST(QuantityText, OtherUnitsAreConvertedToRoundingAccuracy)
{
  EXPECT_NEAR(*parse_quantity("180 deg", "rad"), 3.141592653589793, ulps(2, 3.14));
  EXPECT_NEAR(*parse_quantity("-90\u00b0", "rad"), -1.5707963267948966, ulps(3, 1.57));
  EXPECT_NEAR(*parse_quantity("2 min", "s"), 120, 1e-12);
  EXPECT_NEAR(*parse_quantity("1 inch", "m"), 0.0254, ulps(2, 0.0254));
  EXPECT_NEAR(*parse_quantity("1 in", "m"), 0.0254, ulps(2, 0.0254));
  EXPECT_NEAR(*parse_quantity("1 ft", "m"), 12 * 0.0254, ulps(2, 0.3048));
  EXPECT_NEAR(*parse_quantity("36 km/h", "m/s"), 10, 1e-14);
  EXPECT_NEAR(*parse_quantity("2 h", "s"), 7200, 1e-11);
  EXPECT_NEAR(*parse_quantity("1 lb", "kg"), 0.45359237, ulps(1, 0.45359237));
  EXPECT_NEAR(*parse_quantity("16 oz", "kg"), 0.45359237, ulps(1, 0.45359237));
  EXPECT_NEAR(*parse_quantity("360 deg/s", "rad/s"), 6.283185307179586, 1e-14);
}

TEST(QuantityText, RefusesMalformedNumbersAndWrongUnits)
{
  for (const char *text :
       { "",         " ",        "g",       "30 mm",   "300 gramm", "nan",    "inf g",  "-inf",
         "1e400",    "1e305 Gg", "3,5",     "300 g g", "300 g^2",   "300 /s", "300 g/", "300 g^",
         "300 g^99", "300 mkg",  "300 G g", "3 0",     "0x10",      "--3",    "+-3" })
    EXPECT_EQ(parse_quantity(text, "kg"), std::nullopt) << text;
}

TEST(QuantityText, EveryEntryAcceptsItsOwnUnitAndRefusesAnotherDimension)
{
  Study study;
  unsigned int n_quantities = 0;
  for (const StudyEntry &entry : study_entries(study))
    if (entry.quantity != nullptr)
    {
      // m^7 is not a unit of any entry.
      EXPECT_FALSE(entry.assign("0.1 m^7")) << entry.path();
      EXPECT_EQ(entry.assign("1 kg"), entry.unit == "kg") << entry.path();
      EXPECT_EQ(entry.assign(entry.text() + (entry.unit == "1" ? "" : ' ' + entry.unit)), true)
        << entry.path();
      ++n_quantities;
    }
  EXPECT_GE(n_quantities, 30u);
}

TEST(QuantityText, NamesTheErrorOfAWrongUnitOrNumber)
{
  const auto refusal = [](const std::string &path, const std::string &value) -> std::string {
    return test::sentence_of([&] { with_values(Study(), "--set", { { path, value } }); });
  };
  for (const auto &[entry, value, words] :
       { std::tuple("Motion/Mass", "30 mm", "a length, but a mass is needed"),
         std::tuple("Glass/Contact radius", "30 mmm", "unknown unit, \"mmm\""),
         std::tuple("Motion/Orbit speed", "1 mph", "m/s, cm/s, mm/s or km/h"),
         std::tuple("Motion/Friction coefficient", "1 permille", "a pure number"),
         std::tuple("Motion/Friction coefficient", "0.3 N", "a force, but a pure number"),
         std::tuple("Motion/Mass", "-300 g", "greater than 0 (kg)"),
         std::tuple("Motion/Mass", "0,3 kg", "comma") })
    EXPECT_THAT(refusal(entry, value), testing::HasSubstr(words));
}

TEST(QuantityText, AUnitAfterTheLastNumberAppliesToAll)
{
  EXPECT_EQ(with_shared_unit({ "200", "250", "300 g" }), (Texts{ "200 g", "250 g", "300 g" }));
  EXPECT_EQ(with_shared_unit({ "0.2 kg", "300 g" }), (Texts{ "0.2 kg", "300 g" }));
  EXPECT_EQ(with_shared_unit({ "200 g", "300" }), (Texts{ "200 g", "300" }));
  EXPECT_EQ(with_shared_unit({}), Texts());
}

TEST(QuantityText, ValuesAreStoredInSiUnits)
{
  const Study study = with_values(Study(), "the test",
                                  { { "Motion/Mass", "250 g" },
                                    { "Glass/Young modulus", "60 GPa" },
                                    { "Glass/Rim waviness", "3: 2 um @ 90 deg" } });
  const auto json = study_as_json(entries_of(study));
  EXPECT_EQ(json["Motion"]["Mass"], 0.25);
  EXPECT_EQ(json["Glass"]["Young modulus"], 6e10);
  EXPECT_EQ(study.glass.waviness.front().amplitude, 2e-6);
  EXPECT_NEAR(study.glass.waviness.front().azimuth, 1.5707963267948966, ulps(3, 1.57));
  EXPECT_THAT(study_as_prm(study), testing::HasSubstr("= 0.25\n"));
}

} // namespace
} // namespace stemware::pipeline
