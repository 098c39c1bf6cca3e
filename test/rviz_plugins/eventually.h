#pragma once

#include <functional>

#include <QElapsedTimer>
#include <QtTest/QTest>

namespace cable_variation_rviz {

/// Lets Qt go on until `question` is true. False: it was not within `patience` [ms], which is generous: the
/// machine may be busy.
inline bool eventually(const std::function<bool()>& question, int patience = 60000) {
  QElapsedTimer time;
  time.start();
  while (!question()) {
    if (time.elapsed() > patience) return false;
    QTest::qWait(20);
  }
  return true;
}

}  // namespace cable_variation_rviz
