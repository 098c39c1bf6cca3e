#include <cable_variation/path/path_check.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/path/path_times.h>
#include <cable_variation/scene/severity.h>
#include <cable_variation/tracking/attached_design.h>
#include <cable_variation/tracking/clip_follower.h>
#include <cable_variation/util/chosen_indices.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {

namespace {

constexpr std::size_t kMostSamples = 20'000;
constexpr std::size_t kPlaces = 50;  // of a centreline
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The way that the frame, or each component that moves, has come.
class Distances {
 public:
  /// @return of the one that has come furthest [m]
  double goTo(const ComponentPoses& components, const std::optional<Pose>& frame) {
    if (frame) {
      advance("", frame->position);
    } else {
      for (const auto& [name, pose] : components) advance(name, pose.position);
    }
    double furthest = 0.0;
    for (const auto& [name, been] : been_) furthest = std::max(furthest, been.length);
    return furthest;
  }

 private:
  struct Been {
    Eigen::Vector3d at;
    double length = 0.0;  // [m]
  };

  void advance(const std::string& name, const Eigen::Vector3d& to) {
    Been& been = been_.emplace(name, Been{to}).first->second;
    been.length += (to - been.at).norm();
    been.at = to;
  }

  std::map<std::string, Been> been_;
};

class PathFollower {
 public:
  PathFollower(PathTask task, const MeasureEvaluator& evaluator)
      : task_(std::move(task)),
        evaluator_(evaluator),
        harness_(harnessAt(task_.design, {}, task_.moved)),
        all_(allIndices(task_.design.scene.measures.size())) {
    equilibrium_ = task_.solver.update(harness_);
    requireConverged(equilibrium_, "there is no shape to start from");
  }

  PathCheck follow(const std::function<bool(double)>& goes_on) {
    std::vector<double> changes;
    if (task_.attachments) {
      for (const AttachmentChange& change : task_.design.scene.attachments) changes.push_back(change.time);
    }
    const std::vector<double> times = pathTimes(task_.design, task_.path, task_.step, changes, kMostSamples);
    tellOfStart(times.front());
    tellOfGaps(times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (goes_on && !goes_on(static_cast<double>(i) / static_cast<double>(times.size()))) throw Cancelled();
      step(times[i]);
    }
    check_.kept = keeps();
    return std::move(check_);
  }

 private:
  void tellOfStart(double time) {
    constexpr double kNoticed = 1e-6;  // [m]
    const Harness start = harnessAt(task_.design, {}, task_.path.places(time));
    double furthest = 0.0;
    for (std::size_t i = 0; i < start.clips.size(); ++i)
      furthest = std::max(furthest, (start.clips[i].pose.position - harness_.clips[i].pose.position).norm());
    if (furthest > kNoticed) {
      check_.warnings.push_back("the path begins elsewhere: clips go " + shortNumber(1e3 * furthest) +
                                " mm straight to its start, which is checked as a part of it");
    }
  }

  /// Recorded poses between two samples.
  void tellOfGaps(const std::vector<double>& times) {
    const std::vector<double>& recorded = task_.path.times;
    const auto seen = std::count_if(recorded.begin(), recorded.end(), [&](double time) {
      return std::binary_search(times.begin(), times.end(), time);
    });
    if (static_cast<std::size_t>(seen) == recorded.size()) return;
    check_.warnings.push_back(
        std::to_string(seen) + " of " + std::to_string(recorded.size()) +
        " recorded poses are looked at: between two of them nothing goes further than step, " +
        shortNumber(1e3 * task_.step) +
        " mm, but limits may be broken there unseen; a smaller step sees more");
  }

  void step(double time) {
    const ComponentPoses places = task_.path.places(time);
    const ComponentPoses components = componentPosesAt(task_.design.scene, task_.design.shifted, places);
    const double length = distances_.goTo(
        components, task_.path.frame ? std::optional<Pose>(task_.path.frame(time)) : std::nullopt);
    const double before = check_.samples.empty() ? time : check_.samples.back().time;
    const double length_before = check_.samples.empty() ? 0.0 : check_.samples.back().length;

    Harness next = harnessAt(task_.design, {}, places);
    if (const std::optional<ShapeJump> jump = goTo(next)) {
      check_.events.push_back({before + jump->share * (time - before),
                               length_before + jump->share * (length - length_before),
                               snapEvent(next, *jump)});
    }
    harness_ = std::move(next);
    const auto tell = [&](ShapeEvent event) { check_.events.push_back({time, length, std::move(event)}); };
    if (auto event = equilibriumEvent(was_solved_, equilibrium_)) tell(std::move(*event));
    was_solved_ = equilibrium_.converged();
    if (task_.attachments && was_solved_) {
      for (ShapeEvent& event : attach(time, places)) tell(std::move(event));
    }
    check_.samples.push_back(sampleOf(time, length, components));
    if (!was_solved_) return;
    for (ShapeEvent& event : limits_.compare(task_.design.scene.measures, check_.samples.back().measures))
      tell(std::move(event));
  }

  /// To where the clips of `next` are.
  std::optional<ShapeJump> goTo(const Harness& next) {
    EquilibriumSolver solver = task_.solver;
    FollowedClips followed;
    if (equilibrium_.converged()) {
      followed = followClips(solver, harness_, equilibrium_, next);
    } else {
      followed.equilibrium = solver.update(next);
      followed.solves = 1;
    }
    check_.solves += static_cast<std::size_t>(followed.solves);
    if (followed.equilibrium.converged()) task_.solver = std::move(solver);
    equilibrium_ = std::move(followed.equilibrium);
    return followed.jump;
  }

  std::vector<ShapeEvent> attach(double time, const ComponentPoses& places) {
    const std::vector<AttachmentWish> wishes = scheduledAt(task_.design.scene, harness_, time);
    if (wishes.empty()) {
      refused_.clear();
      return {};
    }
    std::vector<bool> before;
    for (const Clip& clip : harness_.clips) before.push_back(clip.attached);
    try {
      Design design = withAttachments(task_.design, wishes, harness_, equilibrium_).design;
      const Harness next = harnessAt(design, {}, places);
      EquilibriumSolver solver = task_.solver;
      const AttachedClips attached = followAttachment(solver, harness_, equilibrium_, next);
      requireConverged(attached.followed.equilibrium);
      check_.solves += static_cast<std::size_t>(attached.followed.solves);
      task_.solver = std::move(solver);
      task_.design = std::move(design);
      equilibrium_ = attached.followed.equilibrium;
      harness_ = next;
      refused_.clear();
      std::vector<ShapeEvent> events = clipEvents(before, harness_, attached);
      if (attached.followed.jump) events.push_back(snapEvent(harness_, *attached.followed.jump));
      return events;
    } catch (const std::exception& error) {
      const std::string& clip = harness_.clips[wishes.front().clip].name;
      if (std::exchange(refused_, clip) == clip) return {};
      ShapeEvent event;
      event.kind = ShapeEvent::Kind::clip_refused;
      event.clip = clip;
      event.text = error.what();
      return {event};
    }
  }

  PathSample sampleOf(double time, double length, const ComponentPoses& components) const {
    PathSample sample;
    sample.time = time;
    sample.length = length;
    sample.solved = equilibrium_.converged();
    if (!sample.solved) {
      sample.message = equilibrium_.message;
      sample.smallest_eigenvalue = kNaN;
      return sample;
    }
    sample.smallest_eigenvalue = equilibrium_.smallest_eigenvalue;
    sample.measures = evaluator_.evaluate({harness_, equilibrium_, components}, all_);
    sample.reactions = equilibrium_.clip_reactions;
    for (const CableShape& shape : equilibrium_.shapes) {
      sample.bends.push_back(smallestBendRadius(shape));
      sample.centrelines.emplace_back();
      for (const Pose& pose : shape.sample(kPlaces)) sample.centrelines.back().push_back(pose.position);
    }
    return sample;
  }

  bool keeps() const {
    using Kind = ShapeEvent::Kind;
    for (const TimedEvent& each : check_.events) {
      if (each.event.kind == Kind::snapped || each.event.kind == Kind::clip_refused) return false;
    }
    const std::vector<Measure>& measures = task_.design.scene.measures;
    return std::all_of(check_.samples.begin(), check_.samples.end(), [&](const PathSample& sample) {
      if (!sample.solved) return false;
      for (std::size_t i = 0; i < measures.size(); ++i) {
        if (!withinLimits(measures[i], sample.measures[i].value)) return false;
      }
      return true;
    });
  }

  PathTask task_;
  const MeasureEvaluator& evaluator_;
  Harness harness_;
  Equilibrium equilibrium_;
  std::vector<std::size_t> all_;
  PathCheck check_;
  Distances distances_;
  LimitWatch limits_;
  bool was_solved_ = true;
  std::string refused_;  // a clip that was told of
};

}  // namespace

PathCheck checkPath(PathTask task, const MeasureEvaluator& evaluator,
                    const std::function<bool(double)>& goes_on) {
  requireNoContact(task.design.scene.harness, "paths");
  return PathFollower(std::move(task), evaluator).follow(goes_on);
}

PathWorst worstAlong(const PathCheck& check, const Measure& measure, std::size_t index) {
  PathWorst found{kNaN, kNaN, kNaN, check.samples.front().time, true};
  double nominal = kNaN;
  for (const PathSample& sample : check.samples) {
    if (!sample.solved) continue;
    const double value = sample.measures[index].value;
    if (std::isnan(nominal)) nominal = value;
    if (!withinLimits(measure, value)) found.within = false;
    if (std::isnan(value)) continue;
    if (!(value >= found.smallest)) found.smallest = value;
    if (!(value <= found.largest)) found.largest = value;
    if (!isWorse(measure, nominal, value, found.worst)) continue;
    found.worst = value;
    found.time = sample.time;
  }
  return found;
}

LargestReaction largestReaction(const PathCheck& check, std::size_t clip) {
  LargestReaction largest;
  largest.force_time = largest.moment_time = check.samples.front().time;
  for (const PathSample& sample : check.samples) {
    if (!sample.solved) continue;
    const double force = sample.reactions[clip].force.norm(), moment = sample.reactions[clip].moment.norm();
    if (force > largest.force) {
      largest.force = force;
      largest.force_time = sample.time;
    }
    if (moment > largest.moment) {
      largest.moment = moment;
      largest.moment_time = sample.time;
    }
  }
  return largest;
}

TightestBend tightestBend(const PathCheck& check, std::size_t cable) {
  TightestBend tightest{kNaN, check.samples.front().time};
  for (const PathSample& sample : check.samples) {
    if (!sample.solved || sample.bends[cable].radius >= tightest.radius) continue;
    tightest = {sample.bends[cable].radius, sample.time};
  }
  return tightest;
}

}  // namespace cable_variation
