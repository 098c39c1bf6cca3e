#include <rviz_plugins/displays/cables_display.h>

#include <pluginlib/class_list_macros.hpp>
#include <ros/message_traits.h>
#include <rviz/display_context.h>
#include <rviz/properties/bool_property.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/float_property.h>

#include <QSignalBlocker>

#include <ros_interface/markers/cable_tubes.h>
#include <rviz_plugins/displays/message_checks.h>
#include <rviz_plugins/displays/surface.h>
#include <rviz_plugins/displays/surface_material.h>
#include <rviz_plugins/displays/surface_object.h>
#include <rviz_plugins/displays/tube_colours.h>
#include <rviz_plugins/image_overlay.h>
#include <rviz_plugins/legend_image.h>

namespace cable_variation_rviz {

using cable_variation::CableTube;
using cable_variation::CableTubes;
using rviz::StatusProperty;

namespace {

const char* const kNone = "none";
constexpr int kNoLegend = -1;
constexpr std::uint32_t kSides = 16;      // of a tube
constexpr int kLegendMargin = 10;         // [px]
constexpr int kLegendText = 16;           // height [px]
constexpr float kElsewhereWider = 1.03F;  // where it lies along the cable as it is, it covers that

void append(const TubeSurface& tube, const std::vector<Eigen::Vector4f>& of_stations, Surface& all,
            std::vector<Eigen::Vector4f>& colors) {
  const auto first = static_cast<std::uint32_t>(all.positions.size());
  all.positions.insert(all.positions.end(), tube.positions.begin(), tube.positions.end());
  all.normals.insert(all.normals.end(), tube.normals.begin(), tube.normals.end());
  for (const std::uint32_t vertex : tube.triangles) all.triangles.push_back(first + vertex);
  for (const std::uint32_t station : tube.stations) colors.push_back(of_stations[station]);
}

TubeSurface surfaceOf(const CableTube& tube) {
  std::vector<Eigen::Vector3f> line;
  for (std::size_t i = 0; i < tube.radius.size(); ++i) line.emplace_back(&tube.position[3 * i]);
  std::vector<float> radii = tube.radius;
  if (tube.elsewhere) {
    for (float& radius : radii) radius *= kElsewhereWider;
  }
  return tubeSurface(line, radii, kSides);
}

}  // namespace

CablesDisplay::CablesDisplay()
    : TopicDisplay(ros::message_traits::datatype<CableTubes>()),
      quantity_(new rviz::EnumProperty(
          "Quantity", cable_variation_ros::kVariationQuantity,
          "that colours the cables. Where it is not known, they have their own colours.", this,
          SLOT(redraw()))),
      automatic_(new rviz::BoolProperty("Automatic Range", true, "of the colours: as the message has it",
                                        this, SLOT(redraw()))),
      minimum_(new rviz::FloatProperty("Minimum", 0.0F, "first colour [the quantity's unit]", automatic_,
                                       SLOT(redraw()), this)),
      maximum_(new rviz::FloatProperty("Maximum", 1.0F, "last colour [the quantity's unit]", automatic_,
                                       SLOT(redraw()), this)),
      map_(new rviz::EnumProperty("Colour Map", "viridis", "", this, SLOT(redraw()))),
      alpha_(new rviz::FloatProperty("Alpha", 1.0F, "0: not to be seen, 1: opaque", this, SLOT(redraw()))),
      legend_(new rviz::EnumProperty("Legend", "Bottom Right",
                                     "corner with what the colours mean, unless they are those of the "
                                     "variation with its own range, which the display Legend tells",
                                     this, SLOT(redraw()))) {
  connect(quantity_, SIGNAL(requestOptions(EnumProperty*)), this, SLOT(offerQuantities()));
  map_->addOption("viridis", static_cast<int>(ColourMap::viridis));
  map_->addOption("viridis reversed", static_cast<int>(ColourMap::viridis_reversed));
  map_->addOption("grey", static_cast<int>(ColourMap::grey));
  alpha_->setMin(0.0F);
  alpha_->setMax(1.0F);
  legend_->addOption("Top Left", static_cast<int>(Corner::top_left));
  legend_->addOption("Top Right", static_cast<int>(Corner::top_right));
  legend_->addOption("Bottom Left", static_cast<int>(Corner::bottom_left));
  legend_->addOption("Bottom Right", static_cast<int>(Corner::bottom_right));
  legend_->addOption("none", kNoLegend);
}

CablesDisplay::~CablesDisplay() = default;

void CablesDisplay::onInitialize() {
  surface_ = std::make_unique<SurfaceObject>(*context_->getSceneManager(), *scene_node_);
  overlay_ = std::make_unique<ImageOverlay>();
  lit_ = litMaterial();
  translucent_ = translucentMaterial();
}

ros::Subscriber CablesDisplay::listen(ros::NodeHandle& node, const std::string& topic) {
  return node.subscribe(topic, 1, &CablesDisplay::receive, this);
}

void CablesDisplay::receive(const cable_variation::CableTubesConstPtr& tubes) {
  const std::string fault = faultOf(*tubes);
  if (!fault.empty()) {
    forget();
    setStatusStd(StatusProperty::Error, "Topic", fault);
    return;
  }
  tubes_ = tubes;
  setFrame(tubes->header.frame_id,
           Ogre::Vector3(static_cast<float>(tubes->origin.x), static_cast<float>(tubes->origin.y),
                         static_cast<float>(tubes->origin.z)));
  const QString count = QString::number(tubes->cables.size()) + " cables";
  setStatus(StatusProperty::Ok, "Topic",
            tubes->outdated ? count + " as they last were in equilibrium" : count);
  redraw();
}

void CablesDisplay::forget() {
  tubes_.reset();
  if (surface_) surface_->set({}, {}, lit_);
  if (overlay_) overlay_->setVisible(false);
  changed_ = false;
  queueRender();
}

void CablesDisplay::redraw() {
  changed_ = true;
  queueRender();
}

void CablesDisplay::offerQuantities() {
  quantity_->clearOptions();
  quantity_->addOption(kNone);
  bool has_variation = false;
  for (const std::string& name : tubes_ ? quantitiesOf(*tubes_) : std::vector<std::string>()) {
    quantity_->addOptionStd(name);
    has_variation = has_variation || name == cable_variation_ros::kVariationQuantity;
  }
  // To be chosen before there is one.
  if (!has_variation) quantity_->addOption(cable_variation_ros::kVariationQuantity);
}

void CablesDisplay::update(float wall_dt, float ros_dt) {
  TopicDisplay::update(wall_dt, ros_dt);
  if (!changed_) return;
  changed_ = false;
  if (tubes_) draw();
}

std::optional<QuantityRange> CablesDisplay::range() {
  std::optional<QuantityRange> range = rangeOf(*tubes_, quantity_->getStdString());
  const bool automatic = automatic_->getBool();
  for (rviz::FloatProperty* bound : {minimum_, maximum_}) bound->setReadOnly(automatic);
  deleteStatus("Range");
  if (!range) return range;
  if (automatic) {
    const QSignalBlocker minimum_told(minimum_), maximum_told(maximum_);
    minimum_->setFloat(static_cast<float>(range->minimum));
    maximum_->setFloat(static_cast<float>(range->maximum));
    return range;
  }
  range->minimum = minimum_->getFloat();
  range->maximum = maximum_->getFloat();
  if (range->minimum <= range->maximum) return range;
  setStatus(StatusProperty::Error, "Range", "the minimum is above the maximum: nothing is coloured");
  return std::nullopt;
}

void CablesDisplay::draw() {
  TubeColouring colouring;
  const std::optional<QuantityRange> in_force = range();
  if (in_force) {
    colouring.quantity = quantity_->getStdString();
    colouring.minimum = in_force->minimum;
    colouring.maximum = in_force->maximum;
  }
  colouring.map = static_cast<ColourMap>(map_->getOptionInt());
  colouring.alpha = alpha_->getFloat();
  Surface all;
  std::vector<Eigen::Vector4f> colors;
  for (std::size_t i = 0; i < tubes_->cables.size(); ++i) {
    const std::vector<Eigen::Vector4f> of_stations = stationColours(*tubes_, i, colouring);
    if (!of_stations.empty()) append(surfaceOf(tubes_->cables[i]), of_stations, all, colors);
  }
  const bool opaque = !tubes_->outdated && colouring.alpha >= 1.0F;
  surface_->set(all, colors, opaque ? lit_ : translucent_);
  drawLegend(in_force);
}

void CablesDisplay::drawLegend(const std::optional<QuantityRange>& range) {
  const bool variation = quantity_->getStdString() == cable_variation_ros::kVariationQuantity;
  const auto map = static_cast<ColourMap>(map_->getOptionInt());
  const bool told = variation && automatic_->getBool() && map == ColourMap::viridis;
  const bool shown = range && !tubes_->outdated && !told && legend_->getOptionInt() != kNoLegend;
  if (shown) {
    cable_variation::Legend legend;
    legend.title = "Cables";
    legend.quantity = quantity_->getStdString();
    legend.unit = range->unit;
    legend.minimum = range->minimum;
    legend.maximum = range->maximum;
    const QString origin = automatic_->getBool() ? "of the shape shown" : "range as set";
    overlay_->setImage(legendImage(legend, kLegendText, map, origin));
    overlay_->setPlace(static_cast<Corner>(legend_->getOptionInt()), kLegendMargin);
  }
  overlay_->setVisible(shown);
}

}  // namespace cable_variation_rviz

PLUGINLIB_EXPORT_CLASS(cable_variation_rviz::CablesDisplay, rviz::Display)
