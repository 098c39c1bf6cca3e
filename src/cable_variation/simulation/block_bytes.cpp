#include <cable_variation/simulation/block_bytes.h>

#include <stdexcept>

#include <cable_variation/util/byte_stream.h>

namespace cable_variation {

namespace {

SampleOutcome outcomeOf(std::uint8_t number) {
  if (number >= kSampleOutcomes)
    throw std::invalid_argument("outcome " + std::to_string(number) + " of a sample; expected less than " +
                                std::to_string(kSampleOutcomes));
  return static_cast<SampleOutcome>(number);
}

void read(ByteReader& reader, Eigen::MatrixXd& matrix) {
  reader.read(matrix.data(), static_cast<std::size_t>(matrix.size()));
}

}  // namespace

std::string toBytes(const SampleBlock& block) {
  ByteWriter bytes;
  bytes.write<std::uint64_t>(block.first);
  bytes.write<std::uint64_t>(block.outcomes.size());
  for (const SampleOutcome outcome : block.outcomes) bytes.write(static_cast<std::uint8_t>(outcome));
  bytes.write(block.deviations.data(), static_cast<std::size_t>(block.deviations.size()));
  bytes.write(block.values.data(), static_cast<std::size_t>(block.values.size()));
  const SampleFigures& figures = block.figures;
  for (const auto& cables : figures.arcs) {
    for (const ArcVariation& arc : cables) {
      const Eigen::VectorXd collected = arc.collected();
      bytes.write(collected.data(), static_cast<std::size_t>(collected.size()));
    }
  }
  bytes.write(figures.worst.data(), figures.worst.size());
  bytes.write(figures.solved_again);
  bytes.write(figures.undecided);
  bytes.write(figures.discretisation_error);
  return bytes.take();
}

SampleBlock fromBytes(const std::string& bytes, const BlockRange& range, std::size_t variables,
                      std::size_t measures, const BlockWorker::Instants& instants,
                      const SampleFigures& empty) {
  ByteReader reader(bytes);
  const auto first = reader.read<std::uint64_t>(), count = reader.read<std::uint64_t>();
  if (first != range.first || count != range.count) {
    throw std::invalid_argument("a block of " + std::to_string(count) + " samples from " +
                                std::to_string(first) + "; expected " + std::to_string(range.count) +
                                " from " + std::to_string(range.first));
  }
  const auto samples = static_cast<Eigen::Index>(count);
  SampleBlock block{first,
                    Eigen::MatrixXd(static_cast<Eigen::Index>(variables), samples),
                    Eigen::MatrixXd(static_cast<Eigen::Index>(measures), samples),
                    {},
                    empty,
                    true};
  for (std::size_t i = 0; i < count; ++i) block.outcomes.push_back(outcomeOf(reader.read<std::uint8_t>()));
  read(reader, block.deviations);
  read(reader, block.values);
  SampleFigures& figures = block.figures;
  for (auto& cables : figures.arcs) {
    for (ArcVariation& arc : cables) {
      Eigen::VectorXd collected(arc.collectedSize());
      reader.read(collected.data(), static_cast<std::size_t>(collected.size()));
      arc.restore(collected);
    }
  }
  reader.read(figures.worst.data(), figures.worst.size());
  figures.solved_again = reader.read<std::uint64_t>();
  figures.undecided = reader.read<std::uint64_t>();
  figures.discretisation_error = reader.read<double>();
  if (reader.left() > 0)
    throw std::invalid_argument(std::to_string(reader.left()) + " bytes more than a block has");
  std::vector<double> linear(measures);
  addToMeasures(block, 0, count, instants, linear);
  return block;
}

}  // namespace cable_variation
