#include "features/decomposition/candidates.h"

namespace mdbd {
namespace {

// Two climbs that end so close in rank (relative to it) and place (relative to R) found the same.
constexpr double same_rank = 1e-7;
constexpr double same_place = 1e-7;
// A ball of equal rank is the same only within this distance, relative to its radius: twins on both
// sides of a plane of symmetry overlap, too.
constexpr double twin_distance = 1e-2;
// Distances from the centroid that differ by less, relative to R, are equal.
constexpr double same_distance = 1e-6;

}  // namespace

std::uint32_t Candidates::add(const LocalMaximum& maximum) {
  const std::uint32_t known = find(maximum);
  if (known != none) return known;
  const auto candidate = static_cast<std::uint32_t>(candidates_.size());
  candidates_.push_back({maximum, 0, {}});
  ranking_.insert({maximum.rank, candidate});
  return candidate;
}

std::uint32_t Candidates::find(const LocalMaximum& maximum) {
  const auto begin = ranking_.lower_bound({maximum.rank * (1.0 + same_rank), none});
  for (auto it = begin; it != ranking_.end() && it->rank >= maximum.rank * (1.0 - same_rank);
       ++it) {
    const Ball& known = candidates_[it->candidate].maximum.ball;
    if ((known.center - maximum.ball.center).norm() > same_place * scale_) continue;
    if (is_clear(it->candidate)) return it->candidate;
  }
  return none;
}

std::uint32_t Candidates::find_resolving(const Cell& cell) {
  const double least = equal_to(best_rank());
  for (auto it = ranking_.begin(); it != ranking_.end() && it->rank >= least; ++it) {
    if (resolves(candidates_[it->candidate].maximum, cell) && is_clear(it->candidate)) {
      return it->candidate;
    }
  }
  return none;
}

bool Candidates::resolves(const LocalMaximum& maximum, const Cell& cell) {
  const double reach = cell.reach(maximum.ball.center);
  return reach <= maximum.basin_radius || (cell.bound() <= maximum.rank * (1.0 + rank_tie) &&
                                           reach < twin_distance * maximum.ball.radius);
}

bool Candidates::is_clear(std::uint32_t candidate) {
  std::size_t& balls_seen = candidates_[candidate].balls_seen;
  if (balls_seen == overlapped) return false;
  if (balls_seen == balls_.size()) return true;
  const bool is_clear = balls_.is_clear(candidates_[candidate].maximum.ball, balls_seen);
  balls_seen = is_clear ? balls_.size() : overlapped;
  return is_clear;
}

std::uint32_t Candidates::choose(const Eigen::Vector3d& centroid) {
  const double least = equal_to(best_rank());
  const auto last = static_cast<std::uint32_t>(balls_.size()) - 1;
  std::uint32_t chosen = none;
  double farthest = 0.0;
  double nearest = 0.0;
  for (auto it = ranking_.begin(); it != ranking_.end() && it->rank >= least; ++it) {
    if (!is_clear(it->candidate)) continue;
    const Eigen::Vector3d& center = candidates_[it->candidate].maximum.ball.center;
    const double from_centroid = (center - centroid).norm();
    const double from_last =
        balls_.size() == 0 ? 0.0 : (center - balls_.witness(last).center).norm();
    const double lead = from_centroid - farthest;
    const bool is_better =
        lead > same_distance * scale_ ||
        (lead >= -same_distance * scale_ && from_last < nearest - same_place * scale_);
    if (chosen != none && !is_better) continue;
    chosen = it->candidate;
    farthest = from_centroid;
    nearest = from_last;
  }
  return chosen;
}

}  // namespace mdbd
