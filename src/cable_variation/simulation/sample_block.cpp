#include <cable_variation/simulation/sample_block.h>

#include <algorithm>

#include <cable_variation/scene/severity.h>

namespace cable_variation {

void SampleFigures::merge(SampleFigures&& later) {
  measures.merge(later.measures);
  for (std::size_t instant = 0; instant < arcs.size(); ++instant) {
    for (std::size_t cable = 0; cable < arcs[instant].size(); ++cable)
      arcs[instant][cable].merge(later.arcs[instant][cable]);
    std::move(later.shapes[instant].begin(), later.shapes[instant].end(),
              std::back_inserter(shapes[instant]));
    worst[instant] += later.worst[instant];
  }
  solved_again += later.solved_again;
  undecided += later.undecided;
  discretisation_error = std::max(discretisation_error, later.discretisation_error);
}

void addToMeasures(SampleBlock& block, std::size_t at, std::size_t count,
                   const BlockWorker::Instants& instants, std::vector<double>& linear) {
  const bool one_instant = instants.size() == 1;
  for (std::size_t i = at; i < at + count; ++i) {
    const double* sample = block.deviations.col(static_cast<Eigen::Index>(i)).data();
    const double* values = block.values.col(static_cast<Eigen::Index>(i)).data();
    if (one_instant) instants.front()->predict(sample, linear.data());
    block.figures.measures.add(block.first + i, block.outcomes[i], sample, values,
                               one_instant ? linear.data() : nullptr);
  }
}

BlockWorker::BlockWorker(const Scene& scene, const std::vector<std::size_t>& measures, const Sampler& sampler,
                         const Instants& instants, const SampleFigures& empty, std::uint64_t kept_shapes)
    : scene_(&scene),
      measures_(&measures),
      sampler_(&sampler),
      instants_(&instants),
      empty_(&empty),
      kept_shapes_(kept_shapes),
      linear_(measures.size()),
      at_(InstantSolver::kSamples, std::vector<std::size_t>(measures.size())) {
  workers_.reserve(instants.size());
  for (const auto& instant : instants) workers_.emplace_back(*instant);
}

SampleBlock BlockWorker::start(std::uint64_t first, std::size_t count) const {
  const auto samples = static_cast<Eigen::Index>(count);
  SampleBlock block{first,
                    Eigen::MatrixXd(static_cast<Eigen::Index>(sampler_->variableCount()), samples),
                    Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(measures_->size()), samples),
                    std::vector<SampleOutcome>(count, SampleOutcome::solved),
                    *empty_,
                    false};
  for (Eigen::Index i = 0; i < samples; ++i)
    sampler_->sample(first + static_cast<std::uint64_t>(i), block.deviations.col(i).data());
  return block;
}

void BlockWorker::solveSome(SampleBlock& block, std::size_t at, std::size_t count) {
  const Eigen::MatrixXd deviations =
      block.deviations.middleCols(static_cast<Eigen::Index>(at), static_cast<Eigen::Index>(count));
  for (std::size_t instant = 0; instant < workers_.size(); ++instant) {
    const auto& solved = workers_[instant].solve(deviations);
    for (std::size_t i = 0; i < count; ++i) {
      SampleOutcome& outcome = block.outcomes[at + i];
      outcome = std::max(outcome, solved[i].outcome);
      block.figures.solved_again += solved[i].solved_again ? 1 : 0;
      if (!hasValues(solved[i].outcome)) continue;
      block.figures.undecided += solved[i].undecided ? 1 : 0;
      takeWorst(block, at + i, instant, solved[i]);
      addShapes(block, at + i, instant, solved[i]);
      block.figures.discretisation_error =
          std::max(block.figures.discretisation_error, solved[i].discretisation_error);
    }
  }
  addToMeasures(block, at, count, *instants_, linear_);
  for (std::size_t i = at; i < at + count; ++i) {
    const bool has_values = hasValues(block.outcomes[i]);
    for (const std::size_t instant : at_[i - at]) block.figures.worst[instant] += has_values ? 1 : 0;
  }
}

void BlockWorker::takeWorst(SampleBlock& block, std::size_t sample, std::size_t instant,
                            const SampleSolution& solved) {
  for (std::size_t m = 0; m < measures_->size(); ++m) {
    const Measure& measure = scene_->measures[(*measures_)[m]];
    const double nominal = instants_->front()->linear().values[m].value;
    double& value = block.values(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(sample));
    if (instant > 0 && !isWorse(measure, nominal, solved.values[m], value)) continue;
    value = solved.values[m];
    at_[sample % InstantSolver::kSamples][m] = instant;
  }
}

void BlockWorker::addShapes(SampleBlock& block, std::size_t sample, std::size_t instant,
                            const SampleSolution& solved) const {
  for (std::size_t cable = 0; cable < solved.points.size(); ++cable)
    block.figures.arcs[instant][cable].add(solved.points[cable]);
  const std::uint64_t index = block.first + sample;
  if (index < kept_shapes_) block.figures.shapes[instant].push_back({index, solved.outcome, solved.points});
}

}  // namespace cable_variation
