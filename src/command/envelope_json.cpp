#include <command/envelope_json.h>

#include <optional>
#include <utility>

#include <cable_variation/envelope/clearance/clearance_limit.h>

namespace cable_variation_command {

using cable_variation::Containment;
using cable_variation::Envelope;
using cable_variation::EnvelopeClearance;
using cable_variation::Scene;

namespace {

/// The constants of ClearanceResult.
int kindCode(EnvelopeClearance::Kind kind) {
  switch (kind) {
    case EnvelopeClearance::Kind::together:
      return 1;
    case EnvelopeClearance::Kind::production:
      return 2;
    case EnvelopeClearance::Kind::bodies:
      break;
  }
  return 0;
}

Json clearanceJson(const Scene& scene, const Json& variables, const EnvelopeClearance& clearance) {
  const std::optional<double> limit = lowerLimit(scene, clearance);
  Json json = Json::object();
  json.set("cable", scene.harness.cables[clearance.cable].name).set("component", clearance.component);
  json.set("other_cable", clearance.other ? scene.harness.cables[*clearance.other].name : "");
  json.set("distance", clearance.distance)
      .set("kind", kindCode(clearance.kind))
      .set("margin", clearance.margin);
  json.set("random_shapes", clearance.random_shapes).set("between_bodies", clearance.between_bodies);
  json.set("on_envelope", clearance.on_envelope).set("on_other", clearance.on_other);
  json.set("arc_length", clearance.arc_length).set("other_arc_length", clearance.other_arc_length);
  json.set("time", clearance.time).set("variables", variables).set("deviations", clearance.deviations);
  json.set("nominal", clearance.nominal).set("nominal_time", clearance.nominal_time);
  json.set("worst_sample", clearance.worst_sample).set("colliding_triangles", clearance.colliding.size());
  json.set("has_limit", limit.has_value()).set("limit", limit.value_or(0.0));
  return json.set("note", noteOf(clearance));
}

Json containmentJson(const Scene& scene, const Containment& found) {
  const bool any = found.largest_protrusion > 0.0;
  Json json = Json::object();
  json.set("shapes", found.shapes).set("outside", found.outside).set("outside_bound", found.outside_bound);
  json.set("largest_excess", found.largest_excess).set("largest_protrusion", found.largest_protrusion);
  json.set("failed", found.failed).set("cable", any ? scene.harness.cables[found.cable].name : "");
  json.set("arc_length", any ? found.arc_length : 0.0).set("time", any ? found.time : 0.0);
  return json.set("deviations", any ? found.deviations : Eigen::VectorXd());
}

Json tightnessJson(const cable_variation::Tightness& found) {
  Json json = Json::object();
  json.set("ratio", found.ratio()).set("envelope_volume", found.envelope_volume);
  json.set("shapes_volume", found.shapes_volume).set("shapes", found.shapes);
  return json.set("voxel", found.voxel);
}

Json snapJson(const Scene& scene, const cable_variation::Snap& snap) {
  Json json = Json::object();
  json.set("before", snap.before).set("after", snap.after).set("begins", snap.begins).set("time", snap.time);
  json.set("branch", snap.branch).set("cable", scene.harness.cables[snap.cable].name);
  json.set("arc_length", snap.arc_length).set("jump", snap.jump).set("share", snap.share);
  return json.set("share_bound", snap.share_bound);
}

Json phasesJson(const Envelope& envelope) {
  Json list = Json::array();
  for (const cable_variation::EnvelopePhase& phase : envelope.phases) {
    Json json = Json::object();
    json.set("start", phase.start).set("end", phase.end).set("poses", phase.poses);
    list.add(json.set("excess", phase.excess));
  }
  return list;
}

}  // namespace

Json envelopeJson(const Scene& scene, const cable_variation::EnvelopeTask& task,
                  const cable_variation::EnvelopeCalculation& found) {
  const Envelope& envelope = found.envelope;
  Json cables = Json::array(), variables = Json::array(), clearances = Json::array(), snaps = Json::array();
  for (const std::size_t cable : envelope.cables) cables.add(scene.harness.cables[cable].name);
  for (const std::size_t variable : envelope.variables) variables.add(scene.design_variables[variable].name);
  for (const EnvelopeClearance& each : found.clearances)
    clearances.add(clearanceJson(scene, variables, each));
  for (const cable_variation::Snap& snap : envelope.snaps) snaps.add(snapJson(scene, snap));
  Json json = Json::object();
  json.set("surface_excess", found.surfaces.whole.excess).set("volume", found.volume);
  json.set("clearances", std::move(clearances))
      .set("containment", containmentJson(scene, envelope.containment));
  json.set("tightness", tightnessJson(envelope.tightness)).set("probability", envelope.probability);
  json.set("margin", task.options.margin).set("inflation", envelope.inflation);
  json.set("largest_inflation", envelope.largest_inflation).set("cables", std::move(cables));
  json.set("variables", std::move(variables)).set("phases", phasesJson(envelope));
  json.set("motion_excess", envelope.motion_excess).set("snaps", std::move(snaps));
  json.set("branches", envelope.branches).set("pieces", envelope.frames.front().pieces.size());
  json.set("samples", envelope.samples.size())
      .set("solves", envelope.solves)
      .set("failures", envelope.failures);
  json.set("discretisation_error", envelope.discretisation_error).set("seed", task.options.seed);
  json.set("solve_time", envelope.solve_time).set("verify_time", envelope.verify_time);
  return json.set("clearance_time", found.clearance_time).set("surface_time", found.surface_time);
}

}  // namespace cable_variation_command
