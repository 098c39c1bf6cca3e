#include <rviz_plugins/panel/motion_bar.h>

#include <cmath>
#include <utility>

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QToolButton>

#include <cable_variation/Seek.h>

#include <rviz_plugins/panel/solver_connection.h>

namespace cable_variation_rviz {

namespace {

constexpr int kSteps = 2000;  // of the slider

}  // namespace

MotionBar::MotionBar(SolverConnection& connection, std::string player, QWidget* parent)
    : QWidget(parent),
      connection_(connection),
      player_(std::move(player)),
      play_(new QToolButton),
      slider_(new QSlider(Qt::Horizontal)),
      time_(new QLabel) {
  play_->setObjectName("play");
  slider_->setObjectName("motion_time");
  slider_->setRange(0, kSteps);
  slider_->setToolTip("Time of the motion");
  time_->setMinimumWidth(fontMetrics().horizontalAdvance("1000.00 / 1000.00 s"));
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(play_);
  layout->addWidget(slider_, 1);
  layout->addWidget(time_);
  hide();
  connect(play_, &QToolButton::clicked, this, [this] { play(!state_.playing); });
  connect(slider_, &QSlider::sliderPressed, this, [this] { play(false); });
  connect(slider_, &QSlider::valueChanged, this,
          [this](int value) { seek(state_.duration * value / kSteps); });
  states_ = connection_.hear<cable_variation::MotionState>(
      player_ + "/motion_state", [this](const cable_variation::MotionStateConstPtr& state) { show(*state); });
}

void MotionBar::show(const cable_variation::MotionState& state) {
  state_ = state;
  setVisible(state.duration > 0.0);
  play_->setIcon(style()->standardIcon(state.playing ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay));
  play_->setToolTip(state.playing ? "Halt" : "Play");
  if (slider_->isSliderDown() || !(state.duration > 0.0)) return;
  const QSignalBlocker quiet(slider_);
  slider_->setValue(static_cast<int>(std::lround(kSteps * state.time / state.duration)));
  showTime(state.time);
}

void MotionBar::showTime(double time) {
  time_->setText(QString("%1 / %2 s").arg(time, 0, 'f', 2).arg(state_.duration, 0, 'f', 2));
}

void MotionBar::play(bool playing) {
  std_srvs::SetBoolRequest request;
  request.data = playing;
  connection_.ask<std_srvs::SetBool>(
      player_ + "/play", request, "play",
      [this](const std_srvs::SetBoolResponse&, const std::string& failure) { tell("play", failure); });
}

void MotionBar::seek(double time) {
  showTime(time);
  cable_variation::SeekRequest request;
  request.time = time;
  connection_.ask<cable_variation::Seek>(
      player_ + "/seek", request, "seek",
      [this](const cable_variation::SeekResponse&, const std::string& failure) { tell("seek", failure); });
}

void MotionBar::tell(const char* of, const std::string& failure) {
  if (failure.empty()) {
    Q_EMIT succeeded(of);
  } else {
    Q_EMIT failed(of, QString::fromStdString(failure));
  }
}

}  // namespace cable_variation_rviz
