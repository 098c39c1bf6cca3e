#pragma once

#include <QColor>
#include <QString>

namespace cable_variation_rviz {

/// Whether limits are kept: as a sign, for who sees no colours, and as a colour that is readable on white.
enum class Verdict { none, good, bad };

inline QString signOf(Verdict verdict) {
  if (verdict == Verdict::none) return QString::fromUtf8("\u2013");
  return QString::fromUtf8(verdict == Verdict::good ? "\u2714" : "\u2718");
}

inline QColor colourOf(Verdict verdict) {
  if (verdict == Verdict::none) return {90, 90, 90};
  return verdict == Verdict::good ? QColor(0, 110, 40) : QColor(190, 15, 20);
}

}  // namespace cable_variation_rviz
