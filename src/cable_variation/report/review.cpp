#include <cable_variation/report/review.h>

#include <filesystem>

#include <cable_variation/report/cable_variation_section.h>
#include <cable_variation/report/equilibrium_section.h>
#include <cable_variation/report/markup.h>
#include <cable_variation/report/simulation_section.h>
#include <cable_variation/report/stability_section.h>
#include <cable_variation/report/summary_section.h>
#include <cable_variation/util/display_unit.h>
#include <cable_variation/util/version.h>

namespace cable_variation {

namespace {

/// "nominal", or what differs from the scene's file.
std::string designText(const Review& review) {
  std::string text;
  for (const std::string& change : review.changes) text += (text.empty() ? "" : ", ") + change;
  for (const auto& [name, value] : review.values) {
    for (const DesignVariable& variable : review.scene.design_variables) {
      if (variable.name != name || value == variable.nominal) continue;
      const DisplayUnit unit = displayUnit(variable.unit);
      text += (text.empty() ? "" : ", ") + name + " = " + figure(unit.factor * value, 6) + " " + unit.symbol;
    }
  }
  return text.empty() ? "nominal" : text;
}

std::vector<ReportFact> factsOf(const Review& review) {
  const Scene& scene = review.scene;
  std::vector<ReportFact> facts{{"Scene", scene.source}};
  if (!review.source_hash.empty()) facts.push_back({"SHA-256 of its file", review.source_hash});
  facts.push_back({"Design", designText(review)});
  facts.insert(facts.end(), review.about.begin(), review.about.end());
  facts.push_back({"Made by", std::string("cable_variation ") + packageVersion() + ", " + review.date});
  if (!review.author.empty()) facts.push_back({"Author", review.author});
  return facts;
}

}  // namespace

std::string reviewPage(const Review& review) {
  std::vector<ReportSection> sections{
      summarySection(review),
      equilibriumSection(review.scene, review.solved, review.measures, review.measured)};
  if (review.stability != nullptr) {
    sections.push_back(stabilitySection(review.scene, *review.stability, review.values));
  }
  if (review.simulation != nullptr) {
    const Simulation& simulation = *review.simulation;
    sections.push_back(
        simulationSection(review.scene, simulation.statistics, review.values, &simulation.linear));
    sections.push_back(cableVariationSection(review.scene, simulation));
  }
  if (review.envelope) sections.push_back(envelopeSection(review.scene, *review.envelope));
  if (review.path) sections.push_back(pathSection(review.scene, *review.path));
  const std::string name = std::filesystem::path(review.scene.source).filename().string();
  return reportPage(name.empty() ? review.title : name + ": " + review.title, factsOf(review),
                    review.warnings, sections, review.title);
}

}  // namespace cable_variation
