#pragma once  // internal to envelope/

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <cable_variation/envelope/clearance/clearance_samples.h>
#include <cable_variation/envelope/clearance/clip_offsets.h>

namespace cable_variation {

/// A clearance as the pieces of the envelope give it, before samples are solved again.
struct ClearanceSpot {
  EnvelopeClearance clearance;               ///< points in `frame`
  std::vector<const EnvelopePiece*> pieces;  ///< concerned: one, or one of each cable
  std::string frame;                         ///< of the envelope
  std::vector<std::size_t> samples;          ///< that span the pieces near the place, the nearest first
  ExactDistance exact;                       ///< what is measured, of one solved harness
  std::vector<double> phase_bounds;  ///< between cables, per phase: of its bodies [m]; infinity: none count
};

/// Finds the closest pieces of an envelope to components and between cables. All given must outlive it.
class SpotFinder {
 public:
  /// Throws std::invalid_argument as clearances().
  /// @param offsets of all harnesses that the envelope holds; null: what the tolerances say of them
  SpotFinder(const Scene& scene, const Envelope& envelope, const EnvelopeOptions& options,
             const ComponentParts& parts, SampleShapes& shapes, const ClearanceOptions& clearance_options,
             const ClipOffsets* offsets = nullptr);

  /// To components by cable, then between cables; their functions refer to the finder.
  std::vector<ClearanceSpot> find() const;

 private:
  const EnvelopeFrame* frameOf(const std::string& name) const;
  bool counts(const EnvelopePiece& piece, const std::vector<std::size_t>& clips, double near) const;
  std::optional<ClearanceSpot> toComponent(std::size_t cable, std::size_t component) const;
  std::optional<ClearanceSpot> toCable(std::size_t cable, std::size_t other) const;

  const Scene& scene_;
  const Envelope& envelope_;
  const ComponentParts& parts_;
  const ClearanceOptions& options_;
  std::vector<std::string> anchors_;           // per component, see clearanceFrames()
  std::shared_ptr<const SolvedSample> start_;  // the design at the start
  std::optional<ClipOffsets> own_offsets_;
  const ClipOffsets* offsets_;
};

}  // namespace cable_variation
