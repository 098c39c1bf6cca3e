#include <rviz_plugins/legend_display.h>

#include <cmath>

#include <pluginlib/class_list_macros.hpp>
#include <ros/message_traits.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/int_property.h>

#include <rviz_plugins/image_overlay.h>
#include <rviz_plugins/legend_image.h>

namespace cable_variation_rviz {

using cable_variation::Legend;
using rviz::StatusProperty;

LegendDisplay::LegendDisplay()
    : TopicDisplay(ros::message_traits::datatype<Legend>(), "no legend yet: nothing is coloured"),
      corner_(new rviz::EnumProperty("Corner", "Top Right", "of the view", this, SLOT(place()))),
      margin_(
          new rviz::IntProperty("Margin", 10, "from the edges of the view [pixels]", this, SLOT(place()))),
      text_height_(new rviz::IntProperty("Text Height", 16, "[pixels]", this, SLOT(draw()))) {
  corner_->addOption("Top Left", static_cast<int>(Corner::top_left));
  corner_->addOption("Top Right", static_cast<int>(Corner::top_right));
  corner_->addOption("Bottom Left", static_cast<int>(Corner::bottom_left));
  corner_->addOption("Bottom Right", static_cast<int>(Corner::bottom_right));
  margin_->setMin(0);
  margin_->setMax(4000);
  text_height_->setMin(8);
  text_height_->setMax(64);
}

LegendDisplay::~LegendDisplay() = default;

void LegendDisplay::onInitialize() {
  overlay_ = std::make_unique<ImageOverlay>();
  place();
}

ros::Subscriber LegendDisplay::listen(ros::NodeHandle& node, const std::string& topic) {
  return node.subscribe(topic, 1, &LegendDisplay::receive, this);
}

void LegendDisplay::forget() {
  legend_.reset();
  draw();
}

void LegendDisplay::receive(const cable_variation::LegendConstPtr& legend) {
  legend_.reset();
  if (legend->title.empty()) {
    setStatus(StatusProperty::Ok, "Topic", "nothing is coloured");
  } else if (!std::isfinite(legend->minimum) || !std::isfinite(legend->maximum) ||
             legend->minimum > legend->maximum) {
    setStatus(StatusProperty::Error, "Topic",
              QString("legend from %1 to %2: bounds must be finite and in order")
                  .arg(legend->minimum)
                  .arg(legend->maximum));
  } else {
    legend_ = legend;
    setStatus(StatusProperty::Ok, "Topic", "colours of " + QString::fromStdString(legend->topic));
  }
  draw();
}

void LegendDisplay::place() {
  if (!overlay_) return;
  overlay_->setPlace(static_cast<Corner>(corner_->getOptionInt()), margin_->getInt());
  queueRender();
}

void LegendDisplay::draw() {
  if (!overlay_) return;
  if (legend_) overlay_->setImage(legendImage(*legend_, text_height_->getInt()));
  overlay_->setVisible(legend_ != nullptr);
  queueRender();
}

}  // namespace cable_variation_rviz

PLUGINLIB_EXPORT_CLASS(cable_variation_rviz::LegendDisplay, rviz::Display)
