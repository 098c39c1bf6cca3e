#pragma once

#include <QImage>

#include <cable_variation/Legend.h>

#include <rviz_plugins/colour_maps.h>

namespace cable_variation_rviz {

/// A legend as it is seen: title, quantity and unit, the colour bar with its ticks, where the values come
/// from, the note. Light on a translucent dark ground; as wide and high as it must be.
/// @param legend its bounds finite and in order
/// @param text_height [px]
/// @param origin where the values come from, if not as the legend has it
QImage legendImage(const cable_variation::Legend& legend, int text_height, ColourMap map = ColourMap::viridis,
                   const QString& origin = {});

}  // namespace cable_variation_rviz
