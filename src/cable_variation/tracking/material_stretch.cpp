#include <cable_variation/tracking/material_stretch.h>

#include <algorithm>
#include <cmath>

namespace cable_variation {
namespace {

// Shares of a piece of less than this are none: they come from rounding [-].
constexpr double kNone = 1e-9;

// Where a piece of curve is cut: at the places that are to be, and so that no part is longer than `longest`.
std::vector<double> placesOfCuts(const Centreline::Piece& whole, double longest,
                                 const std::vector<double>& to_be) {
  const double least = kNone * (whole.end - whole.start);
  std::vector<double> places{whole.start};
  const auto upTo = [&](double next) {
    const double from = places.back();
    const int count = std::max(1, static_cast<int>(std::ceil((next - from) / longest)));
    for (int k = 1; k < count; ++k) places.push_back(from + (next - from) * k / count);
    places.push_back(next);
  };
  for (const double place : to_be) {
    if (place > places.back() + least && place < whole.end - least) upTo(place);
  }
  upTo(whole.end);
  return places;
}

}  // namespace

StationIntervals::StationIntervals(const CableView& view) : view_(&view) {
  const auto& pieces = view.pieces();
  first_.push_back(0);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    if (pieces[i].point != pieces[i - 1].point + 1) first_.push_back(i);
  }
  first_.push_back(pieces.size());
}

double StationIntervals::start(std::size_t interval) const {
  return view_->line().pieces[first_[interval]].start;
}

double StationIntervals::end(std::size_t interval) const {
  return view_->line().pieces[first_[interval + 1] - 1].end;
}

Place StationIntervals::at(std::size_t interval, double share) const {
  const double s = start(interval) + share * (end(interval) - start(interval));
  const auto& pieces = view_->line().pieces;
  std::size_t index = first_[interval];
  while (index + 1 < first_[interval + 1] && pieces[index].end <= s) ++index;
  const Centreline::Piece& piece = pieces[index];
  return {index, std::clamp((s - piece.start) / (piece.end - piece.start), 0.0, 1.0)};
}

void StationIntervals::appendControlPoints(const MaterialStretch& stretch,
                                           std::vector<Eigen::Vector3d>& points) const {
  const Place from = at(stretch.interval, stretch.from), to = at(stretch.interval, stretch.to);
  for (std::size_t piece = from.piece; piece <= to.piece; ++piece) {
    const double a = piece == from.piece ? from.t : 0.0, b = piece == to.piece ? to.t : 1.0;
    if (from.piece != to.piece && b - a < kNone) continue;
    const auto added = view_->line().pieces[piece].curve.controlPoints(a, b);
    points.insert(points.end(), added.begin(), added.end());
  }
}

double StationIntervals::largestRadius(const MaterialStretch& stretch) const {
  const Place from = at(stretch.interval, stretch.from), to = at(stretch.interval, stretch.to);
  double largest = std::max(view_->line().radius(from), view_->line().radius(to));
  for (std::size_t piece = from.piece; piece <= to.piece; ++piece) {
    if (piece > from.piece) largest = std::max(largest, view_->line().pieces[piece].start_radius);
    if (piece < to.piece) largest = std::max(largest, view_->line().pieces[piece].end_radius);
  }
  return largest;
}

std::vector<MaterialStretch> cutIntoStretches(std::size_t cable, const CableView& view, double longest,
                                              const std::vector<MaterialCut>& cuts) {
  std::vector<double> to_be;
  for (const MaterialCut& cut : cuts) {
    if (cut.cable == cable) to_be.push_back(cut.arc_length);
  }
  std::sort(to_be.begin(), to_be.end());
  const StationIntervals intervals(view);
  std::vector<MaterialStretch> stretches;
  std::size_t piece = 0;
  for (std::size_t interval = 0; interval < intervals.size(); ++interval) {
    const double start = intervals.start(interval), length = intervals.end(interval) - start;
    for (; piece < view.pieces().size() && view.line().pieces[piece].start < start + length * (1.0 - kNone);
         ++piece) {
      const std::vector<double> places = placesOfCuts(view.line().pieces[piece], longest, to_be);
      for (std::size_t k = 0; k + 1 < places.size(); ++k) {
        stretches.push_back({cable, interval, (places[k] - start) / length, (places[k + 1] - start) / length,
                             places[k], places[k + 1]});
      }
    }
  }
  return stretches;
}

}  // namespace cable_variation
