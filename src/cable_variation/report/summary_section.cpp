#include <cable_variation/report/summary_section.h>

#include <algorithm>
#include <cctype>
#include <iterator>

#include <cable_variation/report/markup.h>
#include <cable_variation/report/route_table.h>
#include <cable_variation/report/scene_figure.h>
#include <cable_variation/report/tolerance_table.h>
#include <cable_variation/report/verdict_table.h>

namespace cable_variation {

namespace {

std::string capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// Clips, and where measures that fail have their value.
std::vector<SceneLabel> labelsOf(const Review& review, const std::vector<MeasureVerdict>& verdicts) {
  std::vector<SceneLabel> labels;
  for (const Reaction& clip : review.solved.equilibrium.clip_reactions) {
    labels.push_back({clip.name, clip.section.position});
  }
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const MeasureValue& value = review.measured[i];
    if (verdicts[i].verdict != Verdict::fail || !value.has_place) continue;
    labels.push_back({review.scene.measures[verdicts[i].measure].name, value.point, true});
  }
  return labels;
}

void addPicture(const Review& review, const std::vector<MeasureVerdict>& verdicts, ReportSection& section) {
  if (review.solved.harness.cables.empty()) return;
  std::vector<const TriangleMesh*> envelope;
  if (review.envelope) envelope.push_back(&review.envelope->surface);
  const ScenePicture picture = scenePicture(review.scene, review.solved, envelope);
  std::string caption = "The design at rest; parts that hide a cable let it shine through.";
  if (!envelope.empty()) caption += " Blue around the cables: the envelope.";
  const std::vector<SceneLabel> labels = labelsOf(review, verdicts);
  const bool bad = std::any_of(labels.begin(), labels.end(), [](const SceneLabel& each) { return each.bad; });
  if (bad) caption += " Red: where measures that fail have their value.";
  section.chart(sceneFigure(picture, labels), caption, ReportSection::Width::full);
}

}  // namespace

MeasureEvidence evidenceOf(const Review& review) {
  MeasureEvidence evidence;
  evidence.measures = review.measures;
  for (const MeasureValue& value : review.measured) evidence.values.push_back(value.value);
  evidence.linear = review.stability;
  if (review.simulation != nullptr) {
    evidence.simulation = &review.simulation->statistics;
    // Over a motion the linear analysis is of one time, the simulated values are the worst of all.
    const bool at_one_time = review.simulation->times.size() <= 1;
    if (evidence.linear == nullptr && at_one_time) evidence.linear = &review.simulation->linear;
    // ... and so are their values at the design.
    const SimulationStatistics& statistics = review.simulation->statistics;
    for (std::size_t i = 0; i < statistics.measures.size(); ++i) {
      const auto found =
          std::find(evidence.measures.begin(), evidence.measures.end(), statistics.measures[i]);
      if (found == evidence.measures.end()) continue;
      evidence.values[static_cast<std::size_t>(found - evidence.measures.begin())] = statistics.nominal[i];
    }
  }
  for (std::size_t i = 0; review.path && i < evidence.measures.size(); ++i) {
    const std::size_t measure = evidence.measures[i];
    evidence.values[i] = worstAlong(review.path->check, review.scene.measures[measure], measure).worst;
  }
  if (review.envelope) evidence.clearances = &review.envelope->clearances;
  return evidence;
}

ReportSection summarySection(const Review& review) {
  ReportSection section("Summary");
  const std::vector<MeasureVerdict> verdicts = verdictsOf(review.scene, evidenceOf(review));
  const std::vector<EnvelopeClearance> none;
  const OverallVerdict overall =
      overallVerdict(review.scene, verdicts, review.envelope ? review.envelope->clearances : none,
                     review.path ? pathFaults(review.path->check) : std::vector<std::string>());
  section.banner(toneOf(overall.verdict), capitals(toString(overall.verdict)), overall.text);
  addPicture(review, verdicts, section);
  if (!verdicts.empty()) {
    std::vector<MeasureVerdict> shown;
    const std::vector<std::size_t> own = withoutPlainRoutes(review.scene, review.measures);
    std::copy_if(
        verdicts.begin(), verdicts.end(), std::back_inserter(shown),
        [&](const MeasureVerdict& each) { return std::count(own.begin(), own.end(), each.measure) > 0; });
    if (!shown.empty())
      section.table(verdictTable(review.scene, shown, review.path ? "worst on\nthe path" : "design"));
    if (shown.size() < verdicts.size())
      section.paragraph("Deviations from planned routes that have no limits stand with the design at rest.");
    section.paragraph(review.path ? "A measure passes that keeps its limits all along the path."
                                  : verdictRule(verdicts));
  }
  if (!review.variables.empty()) {
    section.heading("Tolerances that went in");
    section.table(toleranceTable(review.scene, review.variables, review.values));
    for (const std::string& note : toleranceNotes(review.scene, review.variables)) section.paragraph(note);
  }
  return section;
}

}  // namespace cable_variation
