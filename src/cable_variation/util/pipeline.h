#pragma once

// TBB's pipelines with a filter's mode under one name: oneTBB (from 2021 on), and TBB up to 2020, which
// Debian 11 and Ubuntu 20.04 have.
#if __has_include(<tbb/parallel_pipeline.h>)
#include <tbb/parallel_pipeline.h>
#else
#include <tbb/pipeline.h>
#endif

namespace cable_variation {

#if __has_include(<tbb/parallel_pipeline.h>)
using PipelineMode = tbb::filter_mode;
#else
using PipelineMode = tbb::filter;
#endif

}  // namespace cable_variation
