// Real files, which may not be shipped: read from the folder that the environment variable
// CABLE_VARIATION_DATA names, which has them in kbl/; without it these tests are skipped.
#include <cable_variation/import/kbl_import.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/import/segment_curve.h>

#include "kbl_texts.h"

namespace cable_variation {
namespace {

std::vector<std::string> realFiles() {
  std::vector<std::string> files;
  const char* folder = std::getenv("CABLE_VARIATION_DATA");
  if (folder == nullptr) return files;
  std::error_code ignored;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(folder) / "kbl", ignored)) {
    if (entry.path().extension() == ".kbl") files.push_back(entry.path().string());
  }
  return files;
}

TEST(RealKbl, soundCurvesHaveTheirLengthsAndStaleOnesAreTold) {
  const std::vector<std::string> files = realFiles();
  if (files.empty()) GTEST_SKIP() << "no files in $CABLE_VARIATION_DATA/kbl";
  for (const std::string& file : files) {
    const KblDocument document = readKbl(file);
    ImportFindings findings;
    const auto curves = soundCurves(document, findings);
    std::set<std::string> told;
    for (const ImportFinding& finding : findings) {
      if (finding.kind == ImportFinding::Kind::stale_curve) told.insert(finding.id);
    }
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const KblSegment& segment = document.segments[i];
      const SegmentCurve curve(document, segment);
      const double off = std::max({std::abs(curve.length() - segment.virtual_length.value()),
                                   curve.startDeviation(), curve.endDeviation()});
      EXPECT_EQ(told.count(segment.id), curves[i] ? 0U : 1U) << segment.id;
      EXPECT_TRUE(curves[i] ? off < 1e-5 : off > 0.01)
          << segment.id << ": " << off;  // none is near the bound
    }
    if (document.segments.size() == 183) {
      EXPECT_EQ(told, (std::set<std::string>{"Segment_17", "Segment_55", "Segment_119", "Segment_163",
                                             "Segment_170"}));
    }
  }
}

TEST(RealKbl, becomeScenesThatSolve) {
  const std::vector<std::string> files = realFiles();
  if (files.empty()) GTEST_SKIP() << "no files in $CABLE_VARIATION_DATA/kbl";
  for (const std::string& file : files) {
    const KblDocument document = readKbl(file);
    for (const ImportedRestShape shape : {ImportedRestShape::straight, ImportedRestShape::curve}) {
      ImportMapping mapping;
      mapping.rest_shape = shape;
      const Scene scene = sceneOf(sceneText(importKbl(document, mapping).draft));
      EXPECT_LE(scene.harness.cables.size(), document.segments.size());
      EquilibriumOptions options;
      options.accuracy = scene.accuracy;
      const Equilibrium found = EquilibriumSolver(options).solve(scene.harness);
      EXPECT_TRUE(found.converged()) << file << ": " << found.message;
    }
  }
}

// By the documentation's mapping, with ducts that harnesses slide through: it solves, nothing that the import
// wrote is implausible, and each segment with a sound curve is compared with it.
TEST(RealKbl, solveByTheDocumentedMapping) {
  const std::vector<std::string> files = realFiles();
  if (files.empty()) GTEST_SKIP() << "no files in $CABLE_VARIATION_DATA/kbl";
  const std::string page = contentsOf(findTestPackage("cable_variation") + "/doc/import.md");
  const std::size_t begin = page.find("```yaml\n") + 8;
  const ImportMapping mapping =
      readImportMappingText(page.substr(begin, page.find("```", begin) - begin), "import.md");
  for (const std::string& file : files) {
    const KblDocument document = readKbl(file);
    const Scene scene = sceneOf(sceneText(importKbl(document, mapping).draft));
    for (const SceneFault& warning : scene.warnings) ADD_FAILURE() << file << ": " << warning.message;
    ImportFindings findings;
    const auto curves = soundCurves(document, findings);
    const auto sound =
        std::count_if(curves.begin(), curves.end(), [](const auto& curve) { return curve.has_value(); });
    EXPECT_EQ(static_cast<long>(scene.measures.size()), sound);
    EquilibriumOptions options;
    options.accuracy = scene.accuracy;
    const Equilibrium found = EquilibriumSolver(options).solve(scene.harness);
    EXPECT_TRUE(found.converged()) << file << ": " << found.message;
  }
}

}  // namespace
}  // namespace cable_variation
