#pragma once  // internal to equilibrium/

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/equilibrium/discretisation/configuration.h>
#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/rod/kernel/element_kernel.h>
#include <cable_variation/rod/profile.h>

namespace cable_variation {

struct NodalField;

/// Gaps are closed by no more than this where all has come to rest [m].
constexpr double kGapTolerance = 1e-6;
/// What is no further apart than this touches, and what enters by no more does not enter [m].
constexpr double kTouching = 1e-5;

/// The gaps between cables and parts at places of the cables, with the forces that keep them from closing: an
/// augmented Lagrangian (Hestenes 1969; Powell 1969). A gap g with the force λ known so far and the stiffness
/// k presses with p = max(0, λ - k g), as if it had the energy (p² - λ²)/2k; where all has come to rest λ
/// becomes p, until no gap is closed by more than kGapTolerance.
///
/// Contact is everywhere along a cable, the places are few: those of a base that is fine enough to see what
/// is near, and others that are put in where the gap has a minimum between them that is below zero (the
/// exchange method of semi-infinite programming; Hettich and Kortanek 1993).
class ContactSystem {
 public:
  /// Softness to begin with, see soften().
  static constexpr double kSoft = 1e-2;

  /// Keeps references to harness and topology.
  ContactSystem(const Harness& harness, const Topology& topology, const Grid& grid);
  /// To be called when the harness has changed in numbers (see sameStructure()).
  void harnessChanged();

  /// A gap that presses.
  struct Pressing {
    std::size_t span = 0, element = 0;
    std::size_t contact = 0;                       ///< index into Harness::contacts
    std::array<double, element::kNodes> weight{};  ///< of the element's nodes at the place
    double share = 0.0;                            ///< of the span
    std::size_t place = 0;                         ///< number of the place along the span
    Eigen::Vector3d position;                      ///< on the centreline [m, world]
    Eigen::Vector3d tangent;                       ///< its derivative over the span's share [m, world]
    double radius = 0.0;                           ///< of the cable [m]
    double radius_slope = 0.0;                     ///< over the span's share [m]
    Eigen::Vector3d on_part;                       ///< [m, world]
    Eigen::Vector3d direction;                     ///< of the force on the cable, unit, world
    Eigen::Matrix3d curvature;                     ///< of the gap by the place's position [1/m], world
    double gap = 0.0;                              ///< [m]
    double force = 0.0;                            ///< [N]
    double bent = 0.0;       ///< the force that the curvature is turned by: `force`, unless frozen [N]
    double stiffness = 0.0;  ///< [N/m]
    /// Of a place that moves with a minimum of the gap: the gap's second derivative over the span's share
    /// [m], else 0; and the curvature times the centreline's derivative over it.
    double sharpness = 0.0;
    Eigen::Vector3d along = Eigen::Vector3d::Zero();
    /// Then the gap's second derivative by the nodes' positions is that at a held place less these times
    /// themselves [m^-1/2]; zero otherwise.
    std::array<Eigen::Vector3d, element::kNodes> follows{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                                         Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  };

  /// Gaps and forces at a configuration.
  void evaluate(const Configuration& configuration);
  const std::vector<Pressing>& pressing() const { return pressing_; }
  /// Whether a gap that does not press is closed all the same, `within` [m].
  bool isClosed(std::size_t contact, std::size_t span, std::size_t place, double within) const;
  double energy() const { return energy_; }  ///< [J]
  /// The part of energy() that gaps which press now add along a motion, to first and second order [J].
  std::array<double, 2> energyAlong(const NodalField& motion) const;
  /// The largest amount by which a gap is closed, or one that presses is open, after evaluate() [m].
  double worstGap() const { return worst_gap_; }

  /// How stiff gaps are, over what brings the forces to rest fast: small for large steps.
  void soften(double share) { softness_ = share; }
  /// No forces known, no places but the base.
  void forget();
  /// After evaluate() at `configuration`: its forces become those known; places without any go, unless of the
  /// base. What presses where the gap has a sharp minimum, as about an edge, is from now on a place that
  /// moves with it.
  void keepForces(const Configuration& configuration);
  void letMove(const Configuration& configuration);  ///< that alone, with the forces of the last evaluation
  /// As letMove(), also where the minimum is a blunt one, but what presses presses in one point. Returns
  /// whether there was any.
  bool letPointsMove(const Configuration& configuration);
  /// Puts places in where gaps are smallest between others and closed. Returns whether there was one.
  bool findMinima(const Configuration& configuration);
  /// Whether any force is known.
  bool holds() const;
  /// The forces and places of another grid's.
  void take(const ContactSystem& other);
  /// From now on what presses on another grid, and that alone, as linear as it is there: closed or opened by
  /// what a place is elsewhere.
  void freeze(const ContactSystem& other);
  /// A place of a cable that surely counts [m].
  void watch(std::size_t cable, double arc_length, const Configuration& configuration);

  /// The share of a motion, up to 1, that carries no centreline near a surface from outside.
  double freeShare(const Configuration& configuration, const NodalField& motion) const;
  /// As freeShare(), from one configuration to another, of which parts may have moved from `before`.
  bool isFree(const std::vector<PartContact>& before, const Configuration& from,
              const Configuration& to) const;
  /// The first contact whose part a centreline passes through, or nearly so, as an index.
  std::optional<std::size_t> crossed(const Configuration& configuration) const;

  /// Stretches of a cable that do not count in a contact.
  std::vector<CableStretch> skipped(const PartContact& contact, const Configuration& configuration) const;

 private:
  struct Held {
    std::size_t contact = 0;
    Eigen::Vector3d direction;  // in the part's frame
    double known = 0.0;         // λ [N]
    double now = 0.0;           // p of the last evaluation [N]
  };
  struct Place {
    std::size_t element = 0;
    double at = 0.0;     // of the element, 0 to 1
    double share = 0.0;  // of the span
    bool base = true;
    bool fresh = true;       // not yet evaluated
    bool moves = false;      // with a minimum of the gap to what it holds, one thing
    bool blunt = false;      // the minimum need not be sharp
    double sharpness = 0.0;  // of a minimum it is at: second derivative of the gap over `at` [m], else 0
    std::array<double, element::kNodes> weight{}, slope{};
    double radius = 0.0;        // of the cable there [m]
    double radius_slope = 0.0;  // over `at` [m]
    std::vector<Held> held;
    std::vector<double> gap;            // per contact of the cable, if it is known to be small [m]
    std::vector<double> clear;          // per contact of the cable: nothing is closer to `seen` [m]
    std::vector<Eigen::Vector3d> seen;  // in the part's frame
  };
  struct SpanPlaces {
    std::vector<Place> places;          // by share
    std::vector<std::size_t> contacts;  // of the span's cable
    double stiffness = 0.0;             // [N/m]
    std::vector<double> grid;           // boundaries of the elements
  };
  struct Nearest {
    double gap = 0.0, slope = 0.0;  // slope over the element
    bool found = false;
  };

  void evaluateFrozen(const Configuration& configuration);
  Place makePlace(std::size_t span, double share, bool base) const;
  void setNumbers(std::size_t span, Place& place) const;
  static Eigen::Vector3d positionAt(const SpanConfiguration& span, const Place& place);
  static Eigen::Vector3d tangentAt(const SpanConfiguration& span, const Place& place);
  double arcLength(std::size_t span, double share, const Configuration& configuration) const;
  static bool counts(const std::vector<CableStretch>& skipped, double arc_length);
  double reach(std::size_t contact, const Place& place) const;
  Nearest nearest(std::size_t contact, const SpanConfiguration& nodes, const Place& place) const;
  std::optional<Place> minimumBetween(std::size_t span, std::size_t contact, const SpanConfiguration& nodes,
                                      const Place& a, const Place& b, const Nearest& left,
                                      const Nearest& right) const;
  void insert(std::size_t span, Place place);
  /// Moves a place that holds one thing to the minimum of the gap near by. False: it has none.
  bool toMinimum(std::size_t span, const SpanConfiguration& nodes, Place& place) const;
  bool isSharp(std::size_t span, const SpanConfiguration& nodes, const Place& place) const;
  void moveMinima(std::size_t span, const SpanConfiguration& nodes);
  void letMove(std::size_t span, const SpanConfiguration& nodes);
  bool liesFlat(std::size_t span, const SpanConfiguration& nodes, std::size_t place) const;
  std::vector<std::vector<const Pressing*>> pressingRuns() const;
  /// Whether a place is so near to one that moves with a blunt minimum that it would hold its slope as soon
  /// as it pressed, however little.
  bool isBesidePoint(std::size_t span, std::size_t contact, double share) const;
  bool letPointMove(const Configuration& configuration, const std::vector<const Pressing*>& run);
  void setFollows(const Place& place, Pressing& pressing) const;
  struct OnTheWay;
  OnTheWay onTheWay(std::size_t span, std::size_t contact, double share) const;
  /// Whether a motion carries a span nowhere through a part, as it is too short for that.
  bool isShort(std::size_t span, const NodalField& motion) const;
  /// From nodes of a span to others, both in the part's frame: the share that is free.
  double freeShare(std::size_t span, std::size_t contact, const Configuration& at,
                   const std::vector<Eigen::Vector3d>& from, const std::vector<Eigen::Vector3d>& to,
                   double most) const;

  const Harness& harness_;
  const Topology& topology_;
  std::vector<RodProfile> profiles_;
  std::vector<SpanPlaces> spans_;
  std::vector<Pressing> pressing_;
  std::vector<Pressing> frozen_;  // with the numbers of the other grid
  bool is_frozen_ = false;
  bool has_points_ = false;  // places that move with blunt minima
  double energy_ = 0.0, worst_gap_ = 0.0;
  double softness_ = kSoft;
};

}  // namespace cable_variation
