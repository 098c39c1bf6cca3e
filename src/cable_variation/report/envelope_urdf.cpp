#include <cable_variation/report/envelope_urdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <cable_variation/geometry/body/convex_cover.h>
#include <cable_variation/report/markup.h>
#include <cable_variation/report/share_text.h>
#include <cable_variation/report/stl.h>

namespace cable_variation {
namespace {

using Group = std::vector<const RoundedHull*>;

// Pieces of one cable and branch that are of neighbouring stretches and phases.
class Grouping {
 public:
  explicit Grouping(const std::vector<EnvelopePiece>& pieces) : pieces_(pieces) {
    for (const EnvelopePiece& piece : pieces) {
      double& length = length_[{piece.cable, piece.branch}];
      length = std::max(length, piece.end);
      phases_ = std::max(phases_, piece.phase + 1);
    }
    for (const auto& [key, length] : length_) total_length_ += length;
  }

  std::size_t phases() const { return phases_; }

  std::vector<Group> each() const {
    std::vector<Group> groups;
    groups.reserve(pieces_.size());
    for (const EnvelopePiece& piece : pieces_) groups.push_back({&piece.body});
    return groups;
  }

  // Phases in `phase_groups`, each cut into as many stretches as `largest` leaves it.
  std::vector<Group> merged(std::size_t phase_groups, std::size_t largest) const {
    std::map<std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>, Group> groups;
    for (const EnvelopePiece& piece : pieces_) {
      const double length = length_.at({piece.cable, piece.branch});
      const double share = total_length_ > 0.0 ? length / total_length_ : 1.0;
      const double stretches =
          std::max(1.0, std::floor(share * static_cast<double>(largest) / static_cast<double>(phase_groups)));
      const double middle = length > 0.0 ? 0.5 * (piece.start + piece.end) / length : 0.0;
      const auto stretch = static_cast<std::size_t>(std::min(middle * stretches, stretches - 1.0));
      groups[{piece.cable, piece.branch, piece.phase * phase_groups / phases_, stretch}].push_back(
          &piece.body);
    }
    std::vector<Group> all;
    all.reserve(groups.size());
    for (auto& [key, group] : groups) all.push_back(std::move(group));
    return all;
  }

 private:
  const std::vector<EnvelopePiece>& pieces_;
  std::map<std::pair<std::size_t, std::size_t>, double> length_;  // [m]
  double total_length_ = 0.0;                                     // [m]
  std::size_t phases_ = 1;
};

double excessOf(const std::vector<Group>& groups) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, groups.size()), 0.0,
      [&](const auto& range, double largest) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          largest = std::max(largest, mergingExcess(groups[i]));
        }
        return largest;
      },
      [](double a, double b) { return std::max(a, b); });
}

std::vector<Group> bestGroups(const std::vector<EnvelopePiece>& pieces, std::size_t largest) {
  const Grouping grouping(pieces);
  if (pieces.size() <= largest) return grouping.each();
  std::vector<Group> best;
  double smallest = std::numeric_limits<double>::infinity();
  // Long stretches of few phases, or short ones of many: whichever comes closer.
  for (std::size_t phase_groups = 1; phase_groups <= grouping.phases(); phase_groups *= 2) {
    std::vector<Group> groups = grouping.merged(phase_groups, largest);
    if (phase_groups > 1 && groups.size() > largest) break;
    const double excess = excessOf(groups);
    if (excess >= smallest) continue;
    smallest = excess;
    best = std::move(groups);
  }
  return best;
}

std::vector<ConvexCover> coversOf(const std::vector<Group>& groups) {
  std::vector<std::optional<ConvexCover>> covers(groups.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, groups.size()), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) covers[i] = convexCover(groups[i]);
  });
  std::vector<ConvexCover> all;
  all.reserve(covers.size());
  for (auto& cover : covers) all.push_back(std::move(*cover));
  return all;
}

void check(const EnvelopeFrame& frame, const EnvelopeUrdfOptions& options) {
  if (frame.pieces.empty()) throw std::invalid_argument("URDF of an envelope without pieces");
  if (options.largest_pieces == 0) throw std::invalid_argument("URDF of 0 pieces; expected 1 at least");
  if (options.name.empty() || options.name.find('/') != std::string::npos) {
    throw std::invalid_argument("URDF name '" + options.name + "'; expected one that a file can have");
  }
  if (options.folder.compare(0, 10, "package://") != 0 && options.folder.compare(0, 7, "file://") != 0) {
    throw std::invalid_argument("folder '" + options.folder +
                                "' of a URDF's meshes; expected package:// or file://");
  }
}

std::string heldBy(double probability) {
  if (probability == 0.0) return "holds all that the tolerances allow";
  return "holds the whole shape of " + shareText(probability) + " of production";
}

}  // namespace

EnvelopeUrdf envelopeUrdf(const EnvelopeFrame& frame, const TriangleMesh& outer_surface,
                          const EnvelopeUrdfOptions& options) {
  check(frame, options);
  const std::vector<ConvexCover> covers = coversOf(bestGroups(frame.pieces, options.largest_pieces));
  EnvelopeUrdf urdf;
  urdf.pieces = covers.size();

  const std::string title = "cable_variation envelope";
  const std::string folder = options.folder.back() == '/' ? options.folder : options.folder + '/';
  const auto geometry = [&](const std::string& file) {
    return "<geometry><mesh filename=\"" + escaped(folder + file) + "\"/></geometry>";
  };
  const std::string name = escaped(options.name);
  const std::string surface_file = options.name + "_surface.stl";
  urdf.meshes.push_back({surface_file, binaryStl(outer_surface, title)});
  urdf.text = "<?xml version=\"1.0\"?>\n<!-- " + heldBy(options.probability) + " -->\n<robot name=\"" + name +
              "\">\n  <link name=\"" + name + "\">\n    <visual>\n      " + geometry(surface_file) +
              "\n      <material name=\"envelope\"><color rgba=\"0.3 0.6 0.9 0.4\"/></material>\n"
              "    </visual>\n";
  for (std::size_t i = 0; i < covers.size(); ++i) {
    const std::string file = options.name + "_" + std::to_string(i) + ".stl";
    urdf.meshes.push_back({file, binaryStl(covers[i].hull.surface(), title)});
    urdf.excess = std::max(urdf.excess, covers[i].excess);
    urdf.text += "    <collision>" + geometry(file) + "</collision>\n";
  }
  urdf.text += "  </link>\n</robot>\n";
  return urdf;
}

}  // namespace cable_variation
