#include <rviz_plugins/displays/envelope_display.h>

#include <pluginlib/class_list_macros.hpp>
#include <ros/message_traits.h>
#include <rviz/display_context.h>
#include <rviz/properties/color_property.h>
#include <rviz/properties/float_property.h>

#include <rviz_plugins/displays/mesh_surface.h>
#include <rviz_plugins/displays/message_checks.h>
#include <rviz_plugins/displays/surface_material.h>
#include <rviz_plugins/displays/surface_object.h>

namespace cable_variation_rviz {

using cable_variation::EnvelopeMesh;
using rviz::StatusProperty;

namespace {

constexpr float kCrease = 0.6F;  // edges that are sharper are seen as edges [rad]

/// Counted from its first vertex, in single precision.
Surface surfaceOf(const EnvelopeMesh& envelope) {
  std::vector<Eigen::Vector3f> positions;
  const auto& origin = envelope.mesh.vertices.front();
  for (const geometry_msgs::Point& at : envelope.mesh.vertices) {
    positions.push_back(Eigen::Vector3d(at.x - origin.x, at.y - origin.y, at.z - origin.z).cast<float>());
  }
  std::vector<std::uint32_t> triangles;
  for (const shape_msgs::MeshTriangle& triangle : envelope.mesh.triangles) {
    triangles.insert(triangles.end(), triangle.vertex_indices.begin(), triangle.vertex_indices.end());
  }
  return meshSurface(positions, triangles, kCrease);
}

QString textOf(const EnvelopeMesh& envelope) {
  const QString of = QString("of %1 cables").arg(static_cast<int>(envelope.cables.size()));
  if (!(envelope.probability > 0.0)) return of + ", all that the tolerances allow";
  return of + QString(", %1 % of production").arg(100.0 * envelope.probability);
}

}  // namespace

EnvelopeDisplay::EnvelopeDisplay()
    : TopicDisplay(ros::message_traits::datatype<EnvelopeMesh>()),
      color_(new rviz::ColorProperty("Color", QColor(255, 170, 60), "", this, SLOT(draw()))),
      alpha_(new rviz::FloatProperty(
          "Alpha", 0.3F,
          "0: not to be seen, 1: opaque. Denser at the rim, clearer where it faces the camera.", this,
          SLOT(draw()))) {
  alpha_->setMin(0.0F);
  alpha_->setMax(1.0F);
}

EnvelopeDisplay::~EnvelopeDisplay() = default;

void EnvelopeDisplay::onInitialize() {
  surface_ = std::make_unique<SurfaceObject>(*context_->getSceneManager(), *scene_node_);
  surface_->drawLast();
  material_ = shellMaterial();
  opaque_ = litMaterial();
}

ros::Subscriber EnvelopeDisplay::listen(ros::NodeHandle& node, const std::string& topic) {
  return node.subscribe(topic, 1, &EnvelopeDisplay::receive, this);
}

void EnvelopeDisplay::receive(const cable_variation::EnvelopeMeshConstPtr& envelope) {
  forget();
  const std::string fault = faultOf(*envelope);
  if (!fault.empty()) {
    setStatusStd(StatusProperty::Error, "Topic", fault);
    return;
  }
  if (envelope->mesh.triangles.empty()) {
    setStatus(StatusProperty::Ok, "Topic", "there is no envelope of the design in force");
    return;
  }
  const auto& origin = envelope->mesh.vertices.front();
  setFrame(envelope->header.frame_id,
           Ogre::Vector3(static_cast<float>(origin.x), static_cast<float>(origin.y),
                         static_cast<float>(origin.z)));
  mesh_ = surfaceOf(*envelope);
  setStatus(StatusProperty::Ok, "Topic", textOf(*envelope));
  draw();
}

void EnvelopeDisplay::forget() {
  mesh_ = {};
  draw();
}

void EnvelopeDisplay::draw() {
  if (!surface_) return;
  const QColor color = color_->getColor();
  const float alpha = alpha_->getFloat();
  const Eigen::Vector4f rgba(static_cast<float>(color.redF()), static_cast<float>(color.greenF()),
                             static_cast<float>(color.blueF()), alpha);
  surface_->set(mesh_, std::vector<Eigen::Vector4f>(mesh_.positions.size(), rgba),
                alpha < 1.0F ? material_ : opaque_);
  queueRender();
}

}  // namespace cable_variation_rviz

PLUGINLIB_EXPORT_CLASS(cable_variation_rviz::EnvelopeDisplay, rviz::Display)
