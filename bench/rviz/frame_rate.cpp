// How long RViz takes for a frame of a configuration, and without each of its displays: frame_rate CONFIG
// [SECONDS]. scripts/frame_rate starts what there is to be seen.
#include <cstdio>
#include <cstdlib>
#include <functional>

#include <ros/init.h>
#include <rviz/display_group.h>
#include <rviz/ogre_helpers/render_system.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualization_manager.h>

#include <QApplication>
#include <QElapsedTimer>

namespace {

void wait(
    double seconds, const std::function<void()>& meanwhile = [] {}) {
  QElapsedTimer time;
  time.start();
  while (static_cast<double>(time.elapsed()) < 1e3 * seconds) {
    QApplication::processEvents(QEventLoop::AllEvents, 5);
    meanwhile();
  }
}

/// Milliseconds from frame to frame, every frame drawn anew.
double frameTime(rviz::VisualizationManager& manager, double seconds) {
  wait(1.0);
  QElapsedTimer time;
  time.start();
  const auto before = manager.getFrameCount();
  wait(seconds, [&] { manager.queueRender(); });
  const auto drawn = manager.getFrameCount() - before;
  return static_cast<double>(time.elapsed()) / static_cast<double>(drawn);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "frame_rate", ros::init_options::AnonymousName);
  QApplication application(argc, argv);
  if (argc < 2) {
    std::fprintf(stderr, "usage: frame_rate CONFIG [SECONDS [--disable-anti-aliasing]]\n");
    return 2;
  }
  const double seconds = argc > 2 ? std::atof(argv[2]) : 5.0;
  if (argc > 3) rviz::RenderSystem::disableAntiAliasing();
  rviz::VisualizationFrame frame;
  frame.setApp(&application);
  frame.setSplashPath("");
  frame.initialize(argv[1]);
  frame.resize(1600, 1000);
  frame.show();
  rviz::VisualizationManager& manager = *frame.getManager();
  rviz::DisplayGroup& displays = *manager.getRootDisplayGroup();
  wait(20.0);  // until all is there
  const double all = frameTime(manager, seconds);
  std::printf("%-28s %6.1f ms a frame, %.0f frames a second\n", "all displays", all, 1e3 / all);
  for (int i = 0; i < displays.numDisplays(); ++i) {
    rviz::Display& display = *displays.getDisplayAt(i);
    if (!display.isEnabled()) continue;
    display.setEnabled(false);
    std::printf("without %-20s %6.1f ms\n", display.getName().toUtf8().constData(),
                frameTime(manager, seconds));
    std::fflush(stdout);
    display.setEnabled(true);
    wait(2.0);
  }
  return 0;
}
