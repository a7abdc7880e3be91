#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "features/decomposition/ball_set.h"
#include "features/decomposition/cell.h"
#include "features/decomposition/local_maximum.h"

namespace mdbd {

/// The local maxima that a search has found, by their rank, and the cells that hold nothing better
/// than one of them, which are parked with it. A candidate counts until a placed ball overlaps it.
/// Object units.
class Candidates {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// @param balls those placed so far; must outlive this object
  /// @param scale R
  Candidates(const BallSet& balls, double scale) : balls_(balls), scale_(scale) {}

  /// A rank from which on, down from the best, ranks are equal.
  static double equal_to(double best) { return best * (1.0 - rank_tie); }

  /// The number of a local maximum, be it known or new.
  std::uint32_t add(const LocalMaximum& maximum);

  const LocalMaximum& operator[](std::uint32_t candidate) const {
    return candidates_[candidate].maximum;
  }

  /// The highest rank of a candidate; 0 if there is none.
  /// @pre drop_overlapped() since the last ball was placed
  double best_rank() const { return ranking_.empty() ? 0.0 : ranking_.begin()->rank; }

  /// Whether nothing in a cell ranks higher than a candidate that counts, and what ranks equally is
  /// the same.
  bool resolves(std::uint32_t candidate, const Cell& cell) {
    return is_clear(candidate) && resolves(candidates_[candidate].maximum, cell);
  }

  /// A candidate of the highest rank that resolves a cell, or `none`.
  std::uint32_t find_resolving(const Cell& cell);

  /// @param cell number of a cell that the candidate resolves
  void park(std::uint32_t candidate, std::uint32_t cell) {
    candidates_[candidate].parked.push_back(cell);
  }

  /// Forgets the candidates at the top that are overlapped, and calls reopen(cell) with each cell
  /// that was parked with them.
  template <typename Reopen>
  void drop_overlapped(const Reopen& reopen) {
    while (!ranking_.empty() && !is_clear(ranking_.begin()->candidate)) {
      const std::uint32_t candidate = ranking_.begin()->candidate;
      ranking_.erase(ranking_.begin());
      for (const std::uint32_t cell : std::exchange(candidates_[candidate].parked, {})) {
        reopen(cell);
      }
    }
  }

  /// The best candidate. Among equals the one farthest from the centroid, which tells the two sides
  /// of a shape apart that is nearly symmetric; then the one nearest to the last ball. `none` if
  /// there is none.
  /// @pre drop_overlapped() since the last ball was placed
  std::uint32_t choose(const Eigen::Vector3d& centroid);

 private:
  /// Ranks that differ by less, relative to them, are equal.
  static constexpr double rank_tie = 1e-10;
  static constexpr std::size_t overlapped = std::numeric_limits<std::size_t>::max();

  /// Ordered with the highest rank first, ties in order of discovery.
  struct Entry {
    double rank;
    std::uint32_t candidate;
    bool operator<(const Entry& other) const {
      return rank != other.rank ? rank > other.rank : candidate < other.candidate;
    }
  };

  struct Candidate {
    LocalMaximum maximum;
    std::size_t balls_seen;             // it is known to be clear of so many balls
    std::vector<std::uint32_t> parked;  // cells
  };

  static bool resolves(const LocalMaximum& maximum, const Cell& cell);
  std::uint32_t find(const LocalMaximum& maximum);
  bool is_clear(std::uint32_t candidate);

  const BallSet& balls_;
  double scale_;
  std::vector<Candidate> candidates_;
  std::set<Entry> ranking_;
};

}  // namespace mdbd
