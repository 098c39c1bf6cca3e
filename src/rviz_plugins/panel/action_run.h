#pragma once

#include <functional>
#include <memory>
#include <string>

#include <actionlib/client/simple_action_client.h>

#include <rviz_plugins/panel/solver_connection.h>

namespace cable_variation_rviz {

/// One action of a node, run at most once at a time, heard in Qt's thread.
template <typename Action>
class ActionRun {
 public:
  ACTION_DEFINITION(Action)
  using Progress = std::function<void(const Feedback& feedback)>;
  /// `result` is as made by default if there is none; `failure` is empty if all went well.
  using Done = std::function<void(const Result& result, const std::string& failure)>;

  /// @param name the action's full name. `solver` must outlive this
  ActionRun(SolverConnection& solver, std::string name)
      : solver_(solver), name_(std::move(name)), client_(solver.node(), name_, false) {}

  bool running() const { return done_ != nullptr; }

  /// Asks for a run; what went wrong at once, `done` tells too.
  void start(const Goal& goal, Progress progress, Done done) {
    if (!client_.isServerConnected()) {
      done(Result(), "there is no action " + name_ + ": the node is not running, or still loads its scene");
      return;
    }
    done_ = std::move(done);
    const std::size_t number = ++number_;
    client_.sendGoal(
        goal,
        [this, number](const actionlib::SimpleClientGoalState&, const ResultConstPtr& result) {
          solver_.toQt([this, number, result] {
            if (number != number_ || !done_) return;
            finish(result ? *result : Result(), result ? failureOf(*result) : "no answer from " + name_);
          });
        },
        typename Client::SimpleActiveCallback(),
        [this, number, progress](const FeedbackConstPtr& feedback) {
          solver_.toQt([this, number, progress, feedback] {
            if (number == number_ && done_) progress(*feedback);
          });
        });
  }

  /// Ends the run; its `done` tells when it has.
  void cancel() {
    if (!running()) return;
    if (client_.isServerConnected()) {
      client_.cancelGoal();
    } else {
      finish(Result(), "the node with " + name_ + " is gone");
    }
  }

 private:
  using Client = actionlib::SimpleActionClient<Action>;

  void finish(const Result& result, const std::string& failure) {
    const Done done = std::move(done_);
    done_ = nullptr;
    done(result, failure);
  }

  SolverConnection& solver_;
  std::string name_;
  Done done_;               ///< of the run; none: there is no run
  std::size_t number_ = 0;  ///< of the run: an answer of an older one is not heard
  Client client_;
};

}  // namespace cable_variation_rviz
