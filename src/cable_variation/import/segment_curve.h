#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/import/b_spline.h>
#include <cable_variation/import/import_finding.h>
#include <cable_variation/import/kbl_document.h>

namespace cable_variation {

/// A place on a segment's centreline.
struct CurvePoint {
  double arc_length = 0.0;   ///< from the segment's start node [m]
  Eigen::Vector3d position;  ///< [m]
  Eigen::Vector3d tangent;   ///< of length 1
};

/// The centreline of a segment as its file has it, from the start node to the end node.
class SegmentCurve {
 public:
  /// Of pieces that are clamped or not: whichever ends nearer to the nodes, in their order or the reverse.
  SegmentCurve(const KblDocument& document, const KblSegment& segment);

  bool isThere() const { return !pieces_.empty(); }
  bool isReversed() const { return reversed_; }
  double length() const;          ///< of all pieces [m]
  double startDeviation() const;  ///< of its start from the start node [m]
  double endDeviation() const;    ///< of its end from the end node [m]
  double largestGap() const;      ///< between two pieces [m]

  /// At `arc_length` from its start, clamped [m].
  CurvePoint at(double arc_length) const;
  /// From its start to its end, at equal steps of each piece's parameter.
  std::vector<CurvePoint> samples() const;
  /// As samples tell it [m].
  double smallestBendRadius() const;

 private:
  Eigen::Vector3d pieceEnd(std::size_t piece, bool last) const;

  std::vector<BSpline> pieces_;  // as the file has them
  std::vector<double> lengths_;
  std::vector<std::vector<double>> reached_;  // arc lengths at equal steps of a piece's parameter
  bool reversed_ = false;
  Eigen::Vector3d start_node_, end_node_;
};

/// How far a curve may be off and still is the segment's: rounding in the file takes far less.
constexpr double kCurveTolerance = 1e-4;  // [m]

/// Which of a segment's two lengths is taken where both are there.
enum class LengthSource { virtual_length, physical_length };

/// The lengths of all segments [m]: as the file says, else of their sound curves. Throws SceneError with all
/// segments that have neither, and for coordinates that cannot be in mm: the nodes are much further apart, or
/// much nearer, than the segments between them are long.
std::vector<double> segmentLengths(const KblDocument& document,
                                   const std::vector<std::optional<SegmentCurve>>& curves,
                                   LengthSource source);

/// The segments' centrelines, each by the index of its segment; nothing: there is none, or it is not to be
/// trusted, which is among the findings.
std::vector<std::optional<SegmentCurve>> soundCurves(const KblDocument& document, ImportFindings& findings);

}  // namespace cable_variation
