#pragma once

#include <QWidget>

#ifndef Q_MOC_RUN
#include <cable_variation/MeasureStatisticsResult.h>
#endif

namespace cable_variation_rviz {

/// The histogram of a measure: its bars, those beyond a limit in red, the limits as lines, mean and three
/// standard deviations to each side, and mean, sigma and Cpk as text.
class HistogramPlot : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramPlot(cable_variation::MeasureStatisticsResult statistics, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString title() const;

  cable_variation::MeasureStatisticsResult statistics_;
};

}  // namespace cable_variation_rviz
