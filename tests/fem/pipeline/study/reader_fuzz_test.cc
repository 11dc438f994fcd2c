// Each randomly mutated file must be read or refused in one sentence, without crash, hang or an exception of
// another library. The seed is fixed, so failures are reproducible. The preset `sanitize` adds the address
// sanitizer.
#include "fem/geometry/foot_mesh.h"
#include "fem/pipeline/analysis/sweep_case.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/coupling/usable_mesh.h"
#include "fem/pipeline/study/data_files.h"
#include "fem/pipeline/study/study_file.h"
#include "tests/fem/geometry/mesh_writers.h"

#include <boost/algorithm/string.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <unistd.h>

namespace stemware::pipeline
{
namespace
{

namespace fs = std::filesystem;

class Mutator
{
public:
  explicit Mutator(unsigned int seed)
      : random(seed)
  {
  }

  std::string operator()(std::string text)
  {
    for (std::size_t i = 1 + below(4); i > 0; --i)
      change(text);
    return text;
  }

private:
  std::size_t below(std::size_t end) { return end == 0 ? 0 : random() % end; }

  std::string word()
  {
    using namespace std::string_literals;
    static const std::string text =
      "0|-1|1|2|1e308|-1e-320|nan|inf|4294967296|99999999999999999999|0x10|1,5|\0|\xFF\xFE|\xEF\xBB\xBF|\xC3|"
      "<|>|</|/>|<!--|&#0;|[|{|}|\"|\\|,|;|=|*|**|$|$EndNodes|#|\r\n|\n|\t| |end|subsection X|set|*NODE\n|"
      "*ELSET, ELSET=A, GENERATE\n1, 4000000000, 1\n|*SURFACE, TYPE=ELEMENT, NAME=B_1\nA, S1\n|"
      "*ELEMENT, TYPE=C3D20\n|# ring radius: 1 (m)\n|null|true|{\"a\":[]}|file 1 1\n"s;
    static const std::vector<std::string> words = []
    {
      std::vector<std::string> parts;
      boost::split(parts, text, boost::is_any_of("|"));
      return parts;
    }();
    return words[below(words.size())];
  }

  void change(std::string &text)
  {
    const std::size_t at = below(text.size() + 1),
                      n = below(std::min<std::size_t>(text.size() - at, 200) + 1);
    switch (below(8))
    {
    case 0:
      if (at < text.size())
        text[at] = static_cast<char>(random());
      break;
    case 1:
      text.erase(at, n);
      break;
    case 2:
      text.insert(below(text.size() + 1), text.substr(at, n));
      break;
    case 3:
      text.insert(at, word());
      break;
    case 4:
      text.resize(at);
      break;
    case 5: // replace a number
    {
      const std::size_t begin = text.find_first_of("0123456789", at);
      if (begin != std::string::npos)
        text.replace(begin, text.find_first_not_of("0123456789.e-", begin) - begin, word());
      break;
    }
    case 6: // remove or double a line
    {
      const std::size_t end = text.find('\n', at),
                        next = end == std::string::npos ? end : text.find('\n', end + 1);
      if (next != std::string::npos)
        below(2) == 0 ? text.erase(end, next - end) : text.insert(end, text.substr(end, next - end));
      break;
    }
    default: // insert a word or a part of the text many times
    {
      const std::string part = below(2) == 0 ? word() : text.substr(at, std::min<std::size_t>(n, 20));
      for (std::size_t i = below(3000); i > 0 && text.size() < 300000; --i)
        text.insert(at, part);
    }
    }
  }

  std::mt19937 random;
};

struct FuzzedReader
{
  std::string name, extension;
  std::vector<std::string> seeds;
  std::function<void(const fs::path &)> read;
  unsigned int n_trials = 300;
};

std::string text_in_docs(const std::string &name)
{
  std::ifstream file(fs::path(STEMWARE_DOCS) / "cookbooks" / name);
  std::string text{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  EXPECT_FALSE(text.empty()) << name;
  return text;
}

std::string small_mesh()
{
  dealii::Triangulation<3> mesh;
  fem::make_foot_mesh(fem::GlassProfile(), { 8, 2, 1 }, mesh);
  return fem_tests::gmsh_text(mesh);
}

std::string small_gmsh_4()
{
  dealii::Triangulation<3> mesh;
  fem::make_foot_mesh(fem::GlassProfile(), { 8, 2, 1 }, mesh);
  return fem_tests::gmsh_text_of_second_order(mesh, true);
}

void read_mesh(const fs::path &file)
{
  dealii::Triangulation<3> mesh;
  read_mesh_file(file.string(), {}, mesh);
}

const std::string case_table = "Motion/Mass (g);Motion/Closure\r\n302,5;\"full\"\r\n0,29 kg;paper\r\n";

std::vector<FuzzedReader> made_readers()
{
  const auto read_given_study = [](const fs::path &file) { read_study(file.string()); };
  const auto read_profile = [](const fs::path &file) {
    read_study("", { "Glass/Shape=profile", "Glass/Profile file=" + file.string() });
  };
  const auto read_speeds = [](const fs::path &file) {
    read_study("", { "Motion/End time=1", "Motion/Orbit speed file=" + file.string() });
  };
  return { { "prm", ".prm", { text_in_docs("wine_glass.prm"), commented_defaults() }, read_given_study },
           { "json",
             ".json",
             { study_as_json(entries_of(Study())).dump(2), "{\"Glass\": {\"Contact radius\": 0.03}}" },
             read_given_study },
           { "profile", ".csv", { text_in_docs("own_profile.csv") }, read_profile },
           { "speeds", ".csv", { text_in_docs("hand_speed.csv"), "0;0,2\n1;0,3\n2;0,35\n" }, read_speeds },
           { "load",
             ".dat",
             { "# ring radius: 0.03 (m)\n0 0.4684 0\n1 0 -0.13\n2 0.01 0.02\n" },
             [](const fs::path &file) { read_load_file(file.string()); } },
           { "msh", ".msh", { small_mesh(), small_gmsh_4() }, read_mesh },
           { "cases", ".csv", { case_table }, [](const fs::path &file) {
              cases_from_file(file.string());
            } } };
}

const std::vector<FuzzedReader> &all_readers()
{
  static const std::vector<FuzzedReader> readers = made_readers();
  return readers;
}

class ReaderFuzz : public testing::TestWithParam<std::size_t>
{
};

TEST_P(ReaderFuzz, MutatedFilesAreReadOrRefusedInOneSentence)
{
  const FuzzedReader &reader = all_readers().at(GetParam());
  const fs::path folder = testing::TempDir() + "stemware_fuzz_" + std::to_string(::getpid());
  fs::create_directory(folder);
  const fs::path file = folder / ("mutated" + reader.extension);
  Mutator mutate(4711 + static_cast<unsigned int>(GetParam()));
  unsigned int n_read = 0, n_refused = 0;
  for (unsigned int trial = 0; trial < reader.n_trials; ++trial)
  {
    std::ofstream(file, std::ios::binary) << mutate(reader.seeds[trial % reader.seeds.size()]);
    try
    {
      reader.read(file);
      ++n_read;
    }
    catch (const BadInput &refused)
    {
      ++n_refused;
      const std::string sentence = refused.what();
      EXPECT_LT(sentence.size(), 800u) << "trial " << trial << ": " << sentence;
      EXPECT_EQ(std::count(sentence.begin(), sentence.end(), '\n'), 0)
        << "trial " << trial << ": " << sentence;
      EXPECT_TRUE(sentence.back() == '.' || sentence.back() == ')') << "trial " << trial << ": " << sentence;
    }
    catch (const std::exception &foreign)
    {
      const fs::path kept = testing::TempDir() + "stemware_fuzz_" + reader.name + reader.extension;
      fs::copy_file(file, kept, fs::copy_options::overwrite_existing);
      ADD_FAILURE() << "trial " << trial << ", kept as " << kept << ": " << foreign.what();
    }
  }
  EXPECT_EQ(n_read + n_refused, reader.n_trials);
  RecordProperty("read", static_cast<int>(n_read));
  fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(All, ReaderFuzz, testing::Range<std::size_t>(0, 7),
                         [](const auto &given) { return all_readers().at(given.param).name; });

} // namespace
} // namespace stemware::pipeline
