#pragma once

#include <QImage>

#include <cable_variation/Legend.h>

namespace cable_variation_rviz {

/// A legend as it is seen: title, quantity and unit, the colour bar with its ticks, where the values come
/// from, the note. Light on a translucent dark ground; as wide and high as it must be.
/// @param legend its bounds finite and in order
/// @param text_height [px]
QImage legendImage(const cable_variation::Legend& legend, int text_height);

}  // namespace cable_variation_rviz
