#include <command/equilibrium_json.h>

#include <cable_variation/analysis/centreline_points.h>
#include <cable_variation/equilibrium/bend_radius.h>

namespace cable_variation_command {

using cable_variation::CableShape;
using cable_variation::Equilibrium;
using cable_variation::Harness;
using cable_variation::Pose;
using cable_variation::Reaction;
using cable_variation::ShapePoint;

namespace {

template <typename Value>
Json listOf(const CableShape& shape, Value ShapePoint::*member) {
  Json list = Json::array();
  for (const ShapePoint& point : shape.points) list.add(point.*member);
  return list;
}

Json shapeJson(const CableShape& shape, double length) {
  const cable_variation::BendRadius bend = smallestBendRadius(shape);
  Json centreline = Json::array();
  for (const Pose& pose : shape.sample(cable_variation::centrelineCount(length)))
    centreline.add(pose.position);
  Json json = Json::object();
  json.set("cable", shape.cable).set("length", length).set("radius", shape.radius);
  json.set("smallest_bend_radius", bend.radius).set("smallest_bend_radius_at", bend.arc_length);
  json.set("centreline", std::move(centreline)).set("arc_length", listOf(shape, &ShapePoint::arc_length));
  json.set("section", listOf(shape, &ShapePoint::pose)).set("force", listOf(shape, &ShapePoint::force));
  json.set("moment", listOf(shape, &ShapePoint::moment)).set("strain", listOf(shape, &ShapePoint::strain));
  return json.set("curvature", listOf(shape, &ShapePoint::curvature));
}

Json energyJson(const cable_variation::EnergyTerms& energy) {
  Json json = Json::object();
  json.set("elastic", energy.elastic).set("gravity", energy.gravity).set("springs", energy.springs);
  return json.set("loads", energy.loads).set("total", energy.total());
}

Json contactJson(const cable_variation::ContactInterval& interval, const Harness& harness) {
  Json places = Json::array(), on_part = Json::array(), forces = Json::array();
  for (const cable_variation::ContactForce& place : interval.places) {
    places.add(place.arc_length);
    on_part.add(place.on_part);
    forces.add(Eigen::Vector3d(place.force * place.direction));
  }
  Json json = Json::object();
  json.set("cable", harness.cables[interval.cable].name).set("component", interval.part);
  json.set("start", interval.start).set("end", interval.end).set("force", interval.force);
  json.set("moment", interval.moment).set("total", interval.total).set("arc_length", std::move(places));
  return json.set("on_component", std::move(on_part)).set("place_force", std::move(forces));
}

}  // namespace

Json equilibriumJson(const Equilibrium& equilibrium, const Harness& harness) {
  Json shapes = Json::array(), clips = Json::array(), joints = Json::array(), others = Json::array();
  for (std::size_t i = 0; i < equilibrium.shapes.size(); ++i)
    shapes.add(shapeJson(equilibrium.shapes[i], harness.cables[i].length));
  for (std::size_t i = 0; i < equilibrium.clip_reactions.size(); ++i) {
    const Reaction& reaction = equilibrium.clip_reactions[i];
    Json json = Json::object();
    json.set("clip", reaction.name).set("cable", harness.cables[harness.clips[i].cable].name);
    json.set("force", reaction.force).set("moment", reaction.moment);
    clips.add(json.set("arc_length", reaction.arc_length).set("section", reaction.section));
  }
  for (const Reaction& reaction : equilibrium.joint_reactions) {
    Json json = Json::object();
    json.set("joint", reaction.name).set("force", reaction.force).set("moment", reaction.moment);
    joints.add(json.set("section", reaction.section));
  }
  for (const cable_variation::Alternative& other : equilibrium.alternatives) {
    others.add(Json::object().set("energy", other.energy).set("largest_distance", other.largest_distance));
  }
  Json contacts = Json::array();
  for (const cable_variation::ContactInterval& interval : equilibrium.contacts)
    contacts.add(contactJson(interval, harness));
  Json json = Json::object();
  json.set("shapes", std::move(shapes)).set("clip_reactions", std::move(clips));
  json.set("joint_reactions", std::move(joints)).set("contacts", std::move(contacts));
  json.set("smallest_gap", equilibrium.smallest_gap).set("energy", energyJson(equilibrium.energy));
  json.set("smallest_eigenvalue", equilibrium.smallest_eigenvalue).set("iterations", equilibrium.iterations);
  json.set("residual", equilibrium.residual).set("discretisation_error", equilibrium.discretisation_error);
  return json.set("solve_time", equilibrium.solve_time).set("alternatives", std::move(others));
}

}  // namespace cable_variation_command
