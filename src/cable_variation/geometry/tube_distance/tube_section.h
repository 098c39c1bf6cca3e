#pragma once  // internal to geometry/

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <cable_variation/geometry/mesh/box.h>
#include <cable_variation/geometry/tube_distance/centreline.h>
#include <cable_variation/geometry/tube_distance/distance.h>

namespace cable_variation {

/// Control points of a quintic curve over 0 to 1 (Bernstein form): the curve lies within their hull.
using ControlPoints = std::array<Eigen::Vector3d, 6>;

/// Both halves (de Casteljau).
std::array<ControlPoints, 2> halves(const ControlPoints& points);

/// The curve from parameter `start` to `end`, in either order.
ControlPoints restricted(const ControlPoints& points, double start, double end);

/// How far the curve can be from its chord, run through evenly [m].
double sagittaBound(const ControlPoints& points);

/// A stretch of a centreline's piece, over a parameter u from 0 to 1, in the frame of what it is measured
/// against.
struct TubeSection {
  std::size_t piece = 0;
  double t_start = 0.0, t_end = 1.0;            ///< of the piece
  double start_radius = 0.0, end_radius = 0.0;  ///< linear in u [m]
  bool continued = false;                       ///< the next section begins where this one ends
  std::array<Eigen::Vector3d, 6> powers;        ///< coefficients of the powers of u
  ControlPoints control;
  Box box;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< at u = 0.5
  double reach = 0.0;                                ///< no place is further from the middle [m]

  Eigen::Vector3d position(double u) const;
  double radius(double u) const { return start_radius + u * (end_radius - start_radius); }
  double largestRadius() const { return start_radius < end_radius ? end_radius : start_radius; }
  Centreline::Place place(double u) const { return {piece, t_start + u * (t_end - t_start)}; }

  struct Derivatives {
    Eigen::Vector3d position, first, second;  ///< over u
  };
  Derivatives derivatives(double u) const;
};

/// The sections of a cable that count, in order, in the frame at `pose` (world): short and little bent, so
/// that bounds are tight, and cut at the arc length `cut`.
/// Throws std::invalid_argument for a centreline or stretches that are none.
std::vector<TubeSection> sectionsOf(const Centreline& cable, const Pose& pose,
                                    const std::vector<SkippedStretch>& skipped,
                                    std::optional<double> cut = {});

/// A binary tree over sections. Node 0 is the root; a node of one section is a leaf.
struct SectionTree {
  struct Node {
    Box box;
    double largest_radius = 0.0;  ///< [m]
    std::size_t first = 0, count = 0;
    std::size_t left = 0, right = 0;  ///< unless a leaf
  };
  std::vector<Node> nodes;

  explicit SectionTree(const std::vector<TubeSection>& sections);

 private:
  std::size_t build(const std::vector<TubeSection>& sections, std::size_t first, std::size_t count);
};

}  // namespace cable_variation
