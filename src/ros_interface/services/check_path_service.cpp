#include <ros_interface/services/check_path_service.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <cable_variation/analysis/review_start.h>
#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/report/path_section.h>
#include <cable_variation/util/chosen_indices.h>
#include <cable_variation/util/seconds_since.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/path_conversion.h>
#include <ros_interface/conversion/path_request.h>
#include <ros_interface/display/path_publisher.h>
#include <ros_interface/markers/path_markers.h>
#include <ros_interface/node/names.h>
#include <ros_interface/node/node_end.h>
#include <ros_interface/node/spinning_thread.h>
#include <ros_interface/request/name_registry.h>
#include <ros_interface/request/request_status.h>
#include <ros_interface/runs/report_file.h>

namespace cable_variation_ros {

using cable_variation::CheckPathRequest;
using cable_variation::CheckPathResponse;
using cable_variation::PathCheck;

namespace {

/// The design in force, and what is asked of it.
struct Question {
  SolverContext::Snapshot snapshot;
  cable_variation::Harness harness;
  cable_variation::Equilibrium equilibrium;
  cable_variation::ComponentPoses components;
  PathRequest request;
  std::optional<cable_variation::MeasureEvaluator> evaluator;

  cable_variation::SolvedScene inForce() const { return {harness, equilibrium, components}; }
};

/// Between two callbacks of the node. The evaluator refers to the question: it stays where it is.
void prepare(const CheckPathRequest& request, const SolverContext& context, Question& question) {
  requireConverged(context.equilibrium());
  question.snapshot = context.snapshot();
  question.harness = context.harness();
  question.equilibrium = context.equilibrium();
  question.components = context.components();
  const cable_variation::Design& design = question.snapshot.design;
  question.request =
      toPath(request, design, question.harness, question.snapshot.moved, question.snapshot.on_tf);
  question.evaluator.emplace(context.evaluatorInForce().with(design.scene, question.inForce()));
}

PathCheck followed(const Question& question) {
  cable_variation::PathTask task;
  task.design = question.snapshot.design;
  task.moved = question.snapshot.moved;
  task.solver = question.snapshot.solver;
  task.path = question.request.path;
  task.attachments = question.request.over_motions;
  task.step = question.request.step;
  return checkPath(std::move(task), *question.evaluator, [](double) { return goesOn(); });
}

void writeReport(const std::string& name, const Question& question, const PathCheck& check,
                 const cable_variation::OutputDirectory& output, CheckPathResponse& response) {
  const cable_variation::Scene& scene = question.snapshot.design.scene;
  const cable_variation::SolvedScene solved = question.inForce();
  cable_variation::Review review =
      startReview("Path check", question.snapshot.origin, scene, question.snapshot.design.shifted, solved);
  review.about = {{"Path of", question.request.about}};
  review.warnings.insert(review.warnings.end(), response.warnings.begin(), response.warnings.end());
  review.measures = cable_variation::allIndices(scene.measures.size());
  review.measured = question.evaluator->evaluate(solved, review.measures);
  review.path.emplace(cable_variation::PathFindings{check, question.request.over_motions});
  response.report_path = writeBeside(output, name, ".html", reviewPage(review), response.status);
  response.csv_path = writeBeside(output, name, ".csv", pathCsv(scene, check), response.status);
}

}  // namespace

CheckPathService::CheckPathService(const ros::NodeHandle& node, const SolverContext& context,
                                   SpinningThread& spinning, PathPublisher& publisher,
                                   const cable_variation::OutputDirectory& output, NameRegistry& names)
    : context_(context),
      spinning_(spinning),
      publisher_(publisher),
      output_(output),
      names_(names),
      server_(node, kCheckPathService, [this](const Request& request) { return answer(request); }) {}

CheckPathService::Response CheckPathService::answer(const Request& request) {
  return answered<Response>([&] { return check(request); });
}

CheckPathService::Response CheckPathService::check(const Request& request) {
  if (!request.report.empty()) {
    cable_variation::OutputDirectory::checkName(request.report);
    output_.requireWritable();
  }
  const NameRegistry::Hold hold(names_, "report", request.report, kCheckPathService);
  const ros::WallTime start = ros::WallTime::now();
  Question question;
  spinning_.run([&] { prepare(request, context_, question); });
  const PathCheck check = followed(question);

  const cable_variation::Scene& scene = question.snapshot.design.scene;
  Response response = toResponse(scene, check, question.request.path);
  response.solve_time = (ros::WallTime::now() - start).toSec();
  response.warnings.insert(response.warnings.begin(), question.request.warnings.begin(),
                           question.request.warnings.end());
  if (!request.report.empty()) writeReport(request.report, question, check, output_, response);
  visualization_msgs::MarkerArray markers = pathMarkers(scene, check, question.request.path);
  const std::vector<cable_variation::Label> events = pathLabels(scene, check);
  spinning_.run([&] { publisher_.show(markers, events, question.snapshot.design_number, context_); });
  return response;
}

}  // namespace cable_variation_ros
