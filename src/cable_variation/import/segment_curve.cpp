#include <cable_variation/import/segment_curve.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cable_variation/math/so3.h>
#include <cable_variation/scene_file/fault_list.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/number_text.h>

namespace cable_variation {
namespace {

constexpr std::size_t kSteps = 64;  // of a piece's parameter, where its arc length is kept

std::string millimetres(double metres) { return numberText(1e3 * metres, 7) + " mm"; }

}  // namespace

SegmentCurve::SegmentCurve(const KblDocument& document, const KblSegment& segment)
    : start_node_(document.nodes[segment.start_node].position),
      end_node_(document.nodes[segment.end_node].position) {
  if (segment.curves.empty()) return;
  double least = std::numeric_limits<double>::infinity();
  for (const BSpline::Knots knots : {BSpline::Knots::unclamped, BSpline::Knots::clamped}) {
    std::vector<BSpline> pieces;
    for (const KblCurve& curve : segment.curves)
      pieces.emplace_back(curve.control_points, curve.degree, knots);
    const Eigen::Vector3d first = pieces.front().position(0.0);
    const Eigen::Vector3d last = pieces.back().position(1.0);
    for (const bool reversed : {false, true}) {
      const double off = std::max((first - (reversed ? end_node_ : start_node_)).norm(),
                                  (last - (reversed ? start_node_ : end_node_)).norm());
      if (!(off < least)) continue;
      least = off;
      pieces_ = pieces;
      reversed_ = reversed;
    }
  }
  for (const BSpline& piece : pieces_) {
    std::vector<double> reached{0.0};
    for (std::size_t i = 0; i < kSteps; ++i) {
      const double from = static_cast<double>(i) / kSteps;
      reached.push_back(reached.back() + piece.length(from, from + 1.0 / kSteps, 1));
    }
    lengths_.push_back(reached.back());
    reached_.push_back(std::move(reached));
  }
}

Eigen::Vector3d SegmentCurve::pieceEnd(std::size_t piece, bool last) const {
  return pieces_[piece].position(last ? 1.0 : 0.0);
}

double SegmentCurve::length() const {
  double sum = 0.0;
  for (const double length : lengths_) sum += length;
  return sum;
}

double SegmentCurve::startDeviation() const {
  const Eigen::Vector3d start = reversed_ ? pieceEnd(pieces_.size() - 1, true) : pieceEnd(0, false);
  return (start - start_node_).norm();
}

double SegmentCurve::endDeviation() const {
  const Eigen::Vector3d end = reversed_ ? pieceEnd(0, false) : pieceEnd(pieces_.size() - 1, true);
  return (end - end_node_).norm();
}

double SegmentCurve::largestGap() const {
  double largest = 0.0;
  for (std::size_t i = 1; i < pieces_.size(); ++i)
    largest = std::max(largest, (pieceEnd(i, false) - pieceEnd(i - 1, true)).norm());
  return largest;
}

CurvePoint SegmentCurve::at(double arc_length) const {
  double left = reversed_ ? length() - arc_length : arc_length;  // along the pieces as they are
  std::size_t piece = 0;
  while (piece + 1 < pieces_.size() && left > lengths_[piece]) left -= lengths_[piece++];
  const std::vector<double>& reached = reached_[piece];
  const auto above = std::upper_bound(reached.begin() + 1, reached.end() - 1, left);
  const auto step = static_cast<std::size_t>(above - reached.begin()) - 1;
  const double from = static_cast<double>(step) / kSteps;
  // the parameter by Newton's iteration, kept in an interval that holds it
  double low = from, high = from + 1.0 / kSteps;
  double t = low;
  constexpr int kMostSteps = 60;
  for (int i = 0; i < kMostSteps; ++i) {
    const double excess = reached[step] + pieces_[piece].length(from, t, 1) - left;
    if (std::abs(excess) < 1e-9) break;
    (excess > 0.0 ? high : low) = t;
    const double next = t - excess / pieces_[piece].first(t).norm();
    t = next > low && next < high ? next : 0.5 * (low + high);
  }
  const Eigen::Vector3d tangent = pieces_[piece].first(t).normalized();
  return {arc_length, pieces_[piece].position(t), reversed_ ? Eigen::Vector3d(-tangent) : tangent};
}

std::vector<CurvePoint> SegmentCurve::samples() const {
  std::vector<CurvePoint> points;
  const double whole = length();
  double before = 0.0;  // lengths of the pieces passed
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
    for (std::size_t i = piece == 0 ? 0 : 1; i <= kSteps; ++i) {
      const double t = static_cast<double>(i) / kSteps;
      const Eigen::Vector3d tangent = pieces_[piece].first(t).normalized();
      const double along = before + reached_[piece][i];
      points.push_back({reversed_ ? whole - along : along, pieces_[piece].position(t),
                        reversed_ ? Eigen::Vector3d(-tangent) : tangent});
    }
    before += lengths_[piece];
  }
  if (reversed_) std::reverse(points.begin(), points.end());
  return points;
}

double SegmentCurve::smallestBendRadius() const {
  double smallest = std::numeric_limits<double>::infinity();
  const std::vector<CurvePoint> points = samples();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double turn = so3::log(so3::smallestRotation(points[i - 1].tangent, points[i].tangent)).norm();
    if (turn > 0.0) smallest = std::min(smallest, (points[i].arc_length - points[i - 1].arc_length) / turn);
  }
  return smallest;
}

std::vector<std::optional<SegmentCurve>> soundCurves(const KblDocument& document, ImportFindings& findings) {
  using Kind = ImportFinding::Kind;
  std::vector<std::optional<SegmentCurve>> curves;
  for (const KblSegment& segment : document.segments) {
    curves.emplace_back();
    const auto find = [&](Kind kind, const std::string& message) {
      findings.push_back({kind, segment.id, segment.line, "Segment '" + segment.id + "': " + message});
    };
    SegmentCurve curve(document, segment);
    if (!curve.isThere()) {
      find(Kind::no_curve, "there is no Center_curve; its way is not known");
      continue;
    }
    if (!(curve.largestGap() < kCurveTolerance)) {
      find(Kind::open_curve, "there is a gap of " + millimetres(curve.largestGap()) +
                                 " between two pieces of its Center_curve; it is not used");
      continue;
    }
    // of the two lengths, the file's curve is the route as it was designed
    const auto& named = segment.virtual_length ? segment.virtual_length : segment.physical_length;
    const double length = curve.length();
    std::string stale;
    if (named && !(std::abs(length - *named) < kCurveTolerance)) {
      stale = "its Center_curve is " + millimetres(length) + " long, and " +
              (segment.virtual_length ? "Virtual_length" : "Physical_length") + " says " +
              millimetres(*named);
    }
    const bool at_start = curve.startDeviation() < kCurveTolerance;
    const bool at_end = curve.endDeviation() < kCurveTolerance;
    for (const bool start : {true, false}) {
      if (start ? at_start : at_end) continue;
      const std::size_t node = start ? segment.start_node : segment.end_node;
      stale += (stale.empty() ? "its Center_curve " : ", and it ") +
               std::string(start ? "starts " : "ends ") +
               millimetres(start ? curve.startDeviation() : curve.endDeviation()) + " from node '" +
               document.nodes[node].id + "'";
    }
    if (!stale.empty()) {
      find(Kind::stale_curve, stale + "; the curve is not used");
      continue;
    }
    if (curve.isReversed())
      find(Kind::reversed_curve, "its Center_curve runs from the end node to the start node; it is read so");
    if (!named) find(Kind::no_length, "there is no Virtual_length; the length of its Center_curve is taken");
    curves.back().emplace(std::move(curve));
  }
  return curves;
}

namespace {

// Coordinates are taken to be in mm. A chord is never longer than its segment, and of most not much shorter.
void checkCoordinates(const KblDocument& document, FaultList& faults) {
  constexpr double kLargest = 1.5, kSmallest = 0.05;
  std::vector<double> ratios;
  for (const KblSegment& segment : document.segments) {
    const Eigen::Vector3d chord =
        document.nodes[segment.end_node].position - document.nodes[segment.start_node].position;
    if (segment.virtual_length) ratios.push_back(chord.norm() / *segment.virtual_length);
  }
  if (ratios.empty()) return;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  if (*middle <= kLargest && *middle >= kSmallest) return;
  faults.add(0, "the nodes of half of the segments are " + numberText(*middle, 4) +
                    " times Virtual_length apart; expected at most once: are the coordinates in mm?");
}

}  // namespace

std::vector<double> segmentLengths(const KblDocument& document,
                                   const std::vector<std::optional<SegmentCurve>>& curves,
                                   LengthSource source) {
  FaultList faults(document.source);
  std::vector<double> lengths;
  try {
    checkCoordinates(document, faults);
    for (std::size_t i = 0; i < document.segments.size(); ++i) {
      const KblSegment& segment = document.segments[i];
      const bool physical = source == LengthSource::physical_length;
      const auto& first = physical ? segment.physical_length : segment.virtual_length;
      const auto& second = physical ? segment.virtual_length : segment.physical_length;
      if (!first && !second && !curves[i]) {
        faults.add(segment.line, "Segment '" + segment.id +
                                     "': there is neither Virtual_length nor Physical_length nor a "
                                     "Center_curve from node to node; expected one of them");
      }
      lengths.push_back(first ? *first : second ? *second : curves[i] ? curves[i]->length() : 0.0);
    }
  } catch (const FaultList::Full&) {
  }
  if (faults.count() > 0) throw SceneError(faults.sorted());
  return lengths;
}

}  // namespace cable_variation
