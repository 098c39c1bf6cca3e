#include <cable_variation/report/scene_figure.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <cable_variation/report/markup.h>
#include <cable_variation/report/svg.h>
#include <cable_variation/util/base64.h>
#include <cable_variation/util/utf8.h>

namespace cable_variation {

namespace {

constexpr double kFont = 21.0, kLine = 24.0;  // of the style below [px]
// What letters of wide fonts take, capitals and others, of the font's size; and bold ones more.
constexpr double kCapital = 0.72, kSmall = 0.63, kBold = 1.12;
constexpr const char* kText = "font:21px sans-serif;paint-order:stroke;stroke:var(--paper);stroke-width:5px;";

struct Box {
  double left, top, width, height;

  bool overlaps(const Box& other) const {
    return left < other.left + other.width && other.left < left + width && top < other.top + other.height &&
           other.top < top + height;
  }
  bool within(double across, double down) const {
    return left >= 0.0 && top >= 0.0 && left + width <= across && top + height <= down;
  }
};

/// The room that a text (UTF-8) takes [px].
double widthOf(const std::string& text, bool bold) {
  double width = 0.0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (continuesUtf8(text, at)) continue;
    width += text[at] >= 'A' && text[at] <= 'Z' ? kCapital : kSmall;
  }
  return kFont * width * (bold ? kBold : 1.0);
}

std::string styled(double x, double y, const char* anchor, const std::string& style,
                   const std::string& text) {
  return "<text x=\"" + svg::pixels(x) + "\" y=\"" + svg::pixels(y) + "\" text-anchor=\"" + anchor +
         "\" style=\"" + kText + style + "\">" + escaped(text) + "</text>\n";
}

/// Where a name finds room near its place, the nearest first; nothing if there is none.
class Labelling {
 public:
  explicit Labelling(const Camera& camera) : camera_(camera) {}

  std::string add(const SceneLabel& label) {
    const Eigen::Vector3d at = camera_.project(label.place);
    const Box place{at.x() - 3.0, at.y() - 3.0, 6.0, 6.0};
    if (!place.within(camera_.width, camera_.height)) return "";
    const double width = widthOf(label.text, label.bad);
    for (const double away : {14.0, 40.0, 75.0, 115.0, 160.0}) {
      for (const auto& [x, y] : kSides) {
        const Box box{at.x() + away * x +
                          (x < -0.1  ? -width
                           : x > 0.1 ? 0.0
                                     : -0.5 * width),
                      at.y() + away * y - 0.5 * kLine, width, kLine};
        if (!box.within(camera_.width, camera_.height)) continue;
        if (std::any_of(taken_.begin(), taken_.end(), [&](const Box& each) { return box.overlaps(each); }))
          continue;
        taken_.push_back(box);
        return drawn(label, at, box);
      }
    }
    return "";
  }

  /// Names keep off the place.
  void avoid(const Eigen::Vector3d& place) {
    const Eigen::Vector3d at = camera_.project(place);
    taken_.push_back({at.x() - 6.0, at.y() - 6.0, 12.0, 12.0});
  }
  void avoid(const Box& box) { taken_.push_back(box); }

 private:
  static constexpr std::array<std::pair<double, double>, 8> kSides = {
      {{1.0, 0.0}, {-1.0, 0.0}, {0.0, -1.6}, {0.0, 1.6}, {0.8, -1.0}, {-0.8, -1.0}, {0.8, 1.0}, {-0.8, 1.0}}};

  static std::string drawn(const SceneLabel& label, const Eigen::Vector3d& at, const Box& box) {
    const std::string colour = label.bad ? "var(--bad)" : "var(--ink)";
    const double x = std::clamp(at.x(), box.left, box.left + box.width);
    const double y = std::clamp(at.y(), box.top + 4.0, box.top + kLine - 4.0);
    std::string content = svg::line(at.x(), at.y(), x, y, "stroke:" + colour + ";stroke-width:1.5");
    content += "<circle cx=\"" + svg::pixels(at.x()) + "\" cy=\"" + svg::pixels(at.y()) + "\" r=\"" +
               (label.bad ? "7" : "4") + "\" style=\"fill:" + (label.bad ? "none" : colour) +
               ";stroke:" + colour + ";stroke-width:3\"/>\n";
    return content + styled(box.left, box.top + kLine - 6.0, "start",
                            "fill:" + colour + (label.bad ? ";font-weight:bold" : ""), label.text);
  }

  Camera camera_;
  std::vector<Box> taken_;
};

/// A round length, a sixth to a third of the picture's width.
double roundLength(const Camera& camera) {
  const double wanted = camera.width / camera.pixels_per_metre / 3.0;  // [m]
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double each : {5.0, 2.0}) {
    if (each * power <= wanted) return each * power;
  }
  return power;
}

}  // namespace

std::string sceneFigure(const ScenePicture& picture, const std::vector<SceneLabel>& labels) {
  const Camera& camera = picture.camera;
  std::string content = "<image width=\"" + svg::pixels(camera.width) + "\" height=\"" +
                        svg::pixels(camera.height) + "\" href=\"data:image/png;base64," +
                        base64(picture.png) + "\"/>\n";
  const double length = roundLength(camera), left = 20.0, base = camera.height - 20.0;
  const double right = left + camera.pixels_per_metre * length;
  Labelling labelling(camera);
  labelling.avoid(Box{left, base - 40.0, right - left, 50.0});
  for (const SceneLabel& label : labels) labelling.avoid(label.place);
  for (const bool bad : {true, false}) {  // what is wrong first
    for (const SceneLabel& label : labels) {
      if (label.bad == bad) content += labelling.add(label);
    }
  }
  content += svg::line(left, base, right, base, "stroke:var(--ink);stroke-width:3");
  for (const double x : {left, right})
    content += svg::line(x, base - 7.0, x, base + 7.0, "stroke:var(--ink);stroke-width:3");
  content +=
      styled(0.5 * (left + right), base - 12.0, "middle", "fill:var(--ink)", figure(1e3 * length) + " mm");
  return svg::element(camera.width, camera.height, content);
}

}  // namespace cable_variation
