#pragma once  // internal to simulation/

#include <string>

#include <cable_variation/simulation/block_exchange.h>
#include <cable_variation/simulation/sample_block.h>

namespace cable_variation {

/// A complete block as bytes for another process: outcomes, deviations and values of its samples, and the
/// figures that are of more than these: of sections, times and solves. No shapes.
std::string toBytes(const SampleBlock& block);

/// The block again, bit for bit. @param range that it is of @param empty figures of no sample
/// Throws std::invalid_argument: they are no bytes of such a block.
SampleBlock fromBytes(const std::string& bytes, const BlockRange& range, std::size_t variables,
                      std::size_t measures, const BlockWorker::Instants& instants,
                      const SampleFigures& empty);

}  // namespace cable_variation
