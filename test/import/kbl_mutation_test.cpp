// Files broken at random: whatever happens, a scene or a message comes of it, and a message names what is
// broken.
#include <cable_variation/import/kbl_import.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "kbl_texts.h"

namespace cable_variation {
namespace {

// What is said of a text: its faults; or nothing, and then its scene has loaded.
std::string saidOf(const std::string& text) {
  KblDocument document;
  try {
    document = readKblText(text, "file.kbl");
  } catch (const SceneError& error) {
    return error.what();
  }
  ImportResult result;
  try {
    result = importKbl(document, ImportMapping());
  } catch (const SceneError& error) {
    return error.what();
  }
  EXPECT_NO_THROW(sceneOf(sceneText(result.draft))) << sceneText(result.draft);
  return {};
}

// Places of the text that an expression's first group matches.
std::vector<std::pair<std::size_t, std::size_t>> placesOf(const std::string& text, const char* expression) {
  std::vector<std::pair<std::size_t, std::size_t>> places;
  const std::regex regex(expression);
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
    places.emplace_back(match->position(1), match->length(1));
  return places;
}

TEST(KblMutation, aBrokenReferenceIsNamed) {
  const std::string& text = smallKbl();
  const char* references =
      "<(?:Start_node|End_node|Cartesian_point|Part|Routed_wire|Unit_component|Fixing|Associated_protection|"
      "Wire)>"
      "([A-Za-z0-9_]+)<";
  // parts of cores are not needed, and not read
  const std::set<std::string> unread{"Core_1", "Core_2"};
  std::size_t broken = 0;
  for (const auto& [at, length] : placesOf(text, references)) {
    if (unread.count(text.substr(at, length)) > 0) continue;
    std::string mutated = text;
    mutated.replace(at, length, "Nowhere_17");
    const std::string said = saidOf(mutated);
    EXPECT_NE(said.find("'Nowhere_17'"), std::string::npos) << text.substr(at, length) << ": " << said;
    ++broken;
  }
  EXPECT_GE(broken, 60U);
}

TEST(KblMutation, aCutNumberIsNamed) {
  const std::string& text = smallKbl();
  for (const auto& [at, length] :
       placesOf(text, "<(?:Coordinates|Value_component|Degree|Location|U|V)>([-0-9.]+)<")) {
    for (const char* by : {"", "1e", "nan", "1e999", "--3"}) {
      std::string mutated = text;
      mutated.replace(at, length, by);
      EXPECT_NE(saidOf(mutated).find("expected"), std::string::npos)
          << by << " for " << text.substr(at, length);
    }
  }
}

TEST(KblMutation, numbersOfAnySizeAreToldOrTaken) {
  const std::string& text = smallKbl();
  std::mt19937 random(3);
  const std::vector<std::string> values{"0", "-1", "1e-300", "1e300", "1e6", "0.001", "123456789"};
  for (const auto& [at, length] : placesOf(text, "<(?:Coordinates|Value_component|Location)>([-0-9.]+)<")) {
    std::string mutated = text;
    mutated.replace(at, length, values[random() % values.size()]);
    saidOf(mutated);
  }
}

TEST(KblMutation, whateverIsCutOutOrPutIn) {
  std::mt19937 random(11);
  const std::string& text = smallKbl();
  for (int round = 0; round < 400; ++round) {
    std::string mutated = text;
    for (std::size_t k = 0; k <= random() % 3; ++k) {
      const std::size_t at = random() % mutated.size();
      switch (random() % 4) {
        case 0:
          mutated.erase(at, random() % 200);
          break;
        case 1:
          mutated[at] = static_cast<char>(random() % 256);
          break;
        case 2:
          mutated.insert(at, mutated.substr(random() % mutated.size(), random() % 300));
          break;
        default:
          mutated.resize(at + 1);
      }
    }
    const std::string said = saidOf(mutated);
    EXPECT_TRUE(said.empty() || said.find("file.kbl") == 0U) << said;
  }
}

// Whole elements left out: what refers to them is named, or what they were for is missed.
TEST(KblMutation, elementsThatAreNotThereAreMissed) {
  const std::string& text = smallKbl();
  for (const auto& [at, length] :
       placesOf(text, "\\n  <(?:Node|Segment|Unit|Fixing|General_wire) id=\"([A-Za-z0-9_]+)\"")) {
    const std::string id = text.substr(at, length);
    const std::size_t begin = text.rfind("\n  <", at);
    std::size_t end = std::min(text.find("\n  <", at), text.find("\n</", at));
    if (text.compare(end, 5, "\n  </") == 0) end = text.find('\n', end + 1);
    std::string mutated = text;
    mutated.erase(begin, end - begin);
    const std::string said = saidOf(mutated);
    if (id == "Unit_g") {
      EXPECT_EQ(said, "");  // nothing has it
    } else {
      EXPECT_NE(said.find("'" + id + "'"), std::string::npos) << said;
    }
  }
}

}  // namespace
}  // namespace cable_variation
