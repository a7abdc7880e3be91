#include "features/decomposition/decompose.h"

#include <algorithm>
#include <limits>
#include <set>
#include <span>
#include <utility>

#include "features/core/errors.h"
#include "features/decomposition/cell.h"
#include "features/decomposition/cell_queue.h"
#include "features/decomposition/local_maximum.h"

namespace mdbd {
namespace {

// A ball is polished until less than this is to be gained, relative to R.
constexpr double polish_precision = 4e-16;
// Ranks that differ by less, relative to them, are equal.
constexpr double rank_tie = 1e-10;
// Two climbs that end so close in rank (relative to it) and place (relative to R) found the same.
constexpr double same_rank = 1e-7;
constexpr double same_place = 1e-7;
// A ball of equal rank is the same only within this distance, relative to its radius: twins on both
// sides of a plane of symmetry overlap, too.
constexpr double twin_distance = 1e-2;
// Distances from the centroid that differ by less, relative to R, are equal.
constexpr double same_distance = 1e-6;
// Where the rank is lower than this, relative to the best, no candidate of equal rank is close.
constexpr double near_tie = 0.9999;
// A ball whose centre is farther from that of the enclosing ball, relative to R, is eccentric.
constexpr double least_eccentricity = 1e-2;
// How much work goes into telling near-equal maxima apart: for one ball, and for all.
constexpr std::uint64_t most_choice_work = 25'000;
constexpr std::uint64_t all_choice_work = 250'000;
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t overlapped = std::numeric_limits<std::size_t>::max();

// Candidates by their rank, the highest first; ties in order of discovery.
struct Entry {
  double rank;
  std::uint32_t candidate;
  bool operator<(const Entry& other) const {
    return rank != other.rank ? rank > other.rank : candidate < other.candidate;
  }
};

struct Node {
  Cell cell;
  std::uint32_t candidate = none;  // found from this cell or an ancestor
  bool has_climbed = false;        // from the centre
};

struct Candidate {
  LocalMaximum maximum;
  std::size_t balls_seen;             // it is known to be clear of so many balls
  std::vector<std::uint32_t> parked;  // cells in which nothing ranks higher
};

// Nodes by number, in blocks that are never moved.
class NodePool {
 public:
  Node& operator[](std::uint32_t index) { return blocks_[index / block_size][index % block_size]; }

  std::uint32_t add(const Node& node) {
    if (!free_.empty()) {
      const std::uint32_t index = free_.back();
      free_.pop_back();
      (*this)[index] = node;
      return index;
    }
    if (blocks_.empty() || blocks_.back().size() == block_size) {
      blocks_.emplace_back().reserve(block_size);
    }
    blocks_.back().push_back(node);
    return static_cast<std::uint32_t>((blocks_.size() - 1) * block_size + blocks_.back().size() -
                                      1);
  }

  void remove(std::uint32_t index) { free_.push_back(index); }

  /// How many are in use.
  std::size_t size() const {
    if (blocks_.empty()) return 0;
    return (blocks_.size() - 1) * block_size + blocks_.back().size() - free_.size();
  }

  void prefetch(std::uint32_t index) {
    const auto* bytes = reinterpret_cast<const char*>(&(*this)[index]);
    for (std::size_t offset = 0; offset < sizeof(Node); offset += 64)
      __builtin_prefetch(bytes + offset);
  }

 private:
  static constexpr std::uint32_t block_size = 1024;

  std::vector<std::vector<Node>> blocks_;
  std::vector<std::uint32_t> free_;
};

// How much the place of a ball counts (Preference): enough to tell balls apart whose radii differ
// by the rounding of a file, and a part of the tolerance.
double preference_weight(const DecompositionOptions& options) {
  return std::min(1e-4, 0.1 * options.radius_tolerance);
}

// Branch and bound over an octree, one heap for the whole run. The top of the heap bounds the rank
// of every ball still possible; bounds only fall as balls are placed, so they are brought up to
// date when a cell reaches the top.
class Search {
 public:
  Search(RemainingSpace& space, const Ball& enclosing, const DecompositionOptions& options)
      : options_(options), space_(space), scale_(enclosing.radius) {
    const double weight = preference_weight(options);
    rank_tolerance_ = (options.radius_tolerance - weight) / (1.0 + weight);
    keep(add({Cell(enclosing.center, scale_, scale_ * (1.0 + weight))}));
  }

  // Places the next ball. @returns false if there is none
  bool place_next(BallDecomposition& result) {
    const double bound = refine_until_certain();
    const std::uint32_t chosen = choose(result.balls);
    if (chosen == none) return false;
    const Ball ball = candidates_[chosen].maximum.ball;
    result.balls.push_back(ball);
    result.upper_bounds.push_back(std::max(bound, ball.radius));
    space_.place(ball, result.upper_bounds.back());
    return true;
  }

  std::uint64_t cell_count() const { return cell_count_; }

  // Whether cells were given up for want of room.
  bool has_given_up() const { return !given_up_.is_empty(); }

 private:
  double minimum_radius() const { return options_.minimum_radius * scale_; }

  // Works on the cell with the largest bound until everything that could rank as high as the best
  // candidate is a candidate, too; or, when that takes too long, until the best candidate is within
  // the tolerance of everything else that is possible. Returns the upper bound then.
  double refine_until_certain() {
    std::uint64_t left = std::min(choice_left_, most_choice_work);
    while (!cells_.is_empty()) {
      const double bound = cells_.top().bound;
      const double best = best_rank();
      if (bound <= enough()) break;
      const bool is_choice = bound <= best * (1.0 + rank_tolerance_);
      if (is_choice && left == 0) return bound;
      if (is_full() && is_exhausted(cells_.top().cell)) {
        give_up_top();
        continue;
      }
      const std::uint64_t before = work();
      refine_top();
      if (is_choice) {
        const std::uint64_t spent = std::min(work() - before, left);
        left -= spent;
        choice_left_ -= spent;
      }
    }
    if (given_up_.is_empty()) return best_rank() * (1.0 + contact_accuracy);
    climb_from_given_up();
    return std::max(best_rank() * (1.0 + contact_accuracy), given_up_bound_);
  }

  // What has been done so far, in about the time of a distance query.
  std::uint64_t work() const { return space_.query_count() + cell_count_; }

  bool is_full() const { return nodes_.size() + 8 > options_.most_cells; }

  // Whether nothing is left to do with a cell but to divide it.
  bool is_exhausted(std::uint32_t index) {
    const Node& node = nodes_[index];
    return node.cell.is_current(space_) && node.cell.is_measured() && !node.cell.wants_probe() &&
           (node.has_climbed || !is_promising(node.cell));
  }

  // For want of room the top is not divided: it only serves to climb from its centre.
  void give_up_top() {
    const std::uint32_t index = cells_.top().cell;
    given_up_bound_ = std::max(given_up_bound_, cells_.top().bound);
    given_up_.push({rank_at_center(nodes_[index].cell), index});
    cells_.pop();
  }

  // Climbs from the centres of cells that were given up, as long as one is better than the best
  // candidate.
  void climb_from_given_up() {
    while (!given_up_.is_empty() && given_up_.top().bound > best_rank()) {
      const std::uint32_t index = given_up_.top().cell;
      Cell& cell = nodes_[index].cell;
      cell.tighten(space_, enough());
      if (rank_at_center(cell) > best_rank()) climb(index, cell.center());
      given_up_.pop();
      if (cell.bound() <= minimum_radius()) continue;
      given_up_.push({std::min(rank_at_center(cell), best_rank()), index});
    }
  }

  // Does the cheapest thing that may lower the bound of the cell at the top.
  void refine_top() {
    const std::uint32_t index = cells_.top().cell;
    Cell& cell = nodes_[index].cell;
    if (!cell.is_current(space_)) {
      cell.tighten(space_, enough());
    } else if (!cell.is_measured()) {
      cell.measure(space_, enough());
    } else if (!nodes_[index].has_climbed && is_promising(cell)) {
      nodes_[index].has_climbed = true;
      explore(index);
    } else if (cell.wants_probe()) {
      const auto [point, value] = cell.probe(space_, enough());
      if (value * space_.preference().factor(point) > best_rank()) climb(index, point);
    } else {
      cells_.pop();
      divide(index);
      return;
    }
    if (set_aside(index)) {
      cells_.pop();
    } else {
      cells_.lower_top(cell.bound());
    }
    for (const CellQueue::Entry& entry : cells_.next()) nodes_.prefetch(entry.cell);
  }

  // A cell with a lower bound does not matter for the next ball.
  double enough() { return best_rank() * (1.0 - rank_tie); }

  double rank_at_center(const Cell& cell) const {
    return cell.value() * space_.preference().factor(cell.center());
  }

  // Whether the centre is better than the best candidate, or cannot be told from it.
  bool is_promising(const Cell& cell) {
    const double best = best_rank();
    const double rank = rank_at_center(cell);
    return rank > best ||
           (rank > near_tie * best && cell.bound() <= best * (1.0 + rank_tolerance_));
  }

  // Finds the candidate of a promising cell.
  void explore(std::uint32_t index) {
    nodes_[index].candidate = find_resolving_candidate(nodes_[index].cell);
    if (nodes_[index].candidate == none) climb(index, nodes_[index].cell.center());
  }

  // Climbs to a candidate, perhaps one that was found before.
  void climb(std::uint32_t index, const Eigen::Vector3d& start) {
    Node& node = nodes_[index];
    const LocalMaximum maximum =
        find_local_maximum(space_, start, node.cell.half_size(), polish_precision * scale_);
    if (maximum.ball.radius <= minimum_radius()) return;
    node.candidate = find_candidate(maximum);
    if (node.candidate != none) return;
    node.candidate = static_cast<std::uint32_t>(candidates_.size());
    candidates_.push_back({maximum, 0, {}});
    ranking_.insert({maximum.rank, node.candidate});
  }

  // A candidate of the highest rank that is as good as anything in a cell.
  std::uint32_t find_resolving_candidate(const Cell& cell) {
    const double least = best_rank() * (1.0 - rank_tie);
    for (auto it = ranking_.begin(); it != ranking_.end() && it->rank >= least; ++it) {
      if (resolves(candidates_[it->candidate].maximum, cell) && is_clear(it->candidate))
        return it->candidate;
    }
    return none;
  }

  // Whether nothing in a cell ranks higher than a candidate, and what ranks equally is the same.
  static bool resolves(const LocalMaximum& maximum, const Cell& cell) {
    const double reach = cell.reach(maximum.ball.center);
    return reach <= maximum.basin_radius || (cell.bound() <= maximum.rank * (1.0 + rank_tie) &&
                                             reach < twin_distance * maximum.ball.radius);
  }

  // The same local maximum, if it is known.
  std::uint32_t find_candidate(const LocalMaximum& maximum) {
    const auto begin = ranking_.lower_bound({maximum.rank * (1.0 + same_rank), none});
    for (auto it = begin; it != ranking_.end() && it->rank >= maximum.rank * (1.0 - same_rank);
         ++it) {
      const Ball& known = candidates_[it->candidate].maximum.ball;
      if ((known.center - maximum.ball.center).norm() > same_place * scale_) continue;
      if (is_clear(it->candidate)) return it->candidate;
    }
    return none;
  }

  void divide(std::uint32_t index) {
    const Node parent = nodes_[index];
    nodes_.remove(index);
    const OctantBounds bounds(parent.cell.witnesses(space_), parent.cell.center(),
                              parent.cell.half_size());
    for (int octant = 0; octant < 8; ++octant) {
      const std::uint32_t child = add({parent.cell.child(octant), parent.candidate});
      if (set_aside(child)) continue;
      nodes_[child].cell.tighten(bounds.of_octant(octant, space_.preference()), enough());
      keep(child);
    }
  }

  std::uint32_t add(const Node& node) {
    ++cell_count_;
    return nodes_.add(node);
  }

  // Puts a cell into the queue, unless it can be set aside.
  void keep(std::uint32_t index) {
    if (!set_aside(index)) cells_.push({nodes_[index].cell.bound(), index});
  }

  // Forgets a cell in which no ball of the minimum radius can be, and parks one that has nothing
  // better than a candidate. @returns whether it did
  bool set_aside(std::uint32_t index) {
    const Node& node = nodes_[index];
    if (node.cell.bound() <= minimum_radius()) {
      nodes_.remove(index);
    } else if (is_resolved(node)) {
      candidates_[node.candidate].parked.push_back(index);
    } else {
      return false;
    }
    return true;
  }

  bool is_resolved(const Node& node) {
    if (node.candidate == none || !is_clear(node.candidate)) return false;
    return resolves(candidates_[node.candidate].maximum, node.cell);
  }

  // Whether no ball placed since overlaps a candidate.
  bool is_clear(std::uint32_t index) {
    Candidate& candidate = candidates_[index];
    if (candidate.balls_seen == overlapped) return false;
    if (candidate.balls_seen == space_.balls().size()) return true;
    const bool is_clear = space_.balls().is_clear(candidate.maximum.ball, candidate.balls_seen);
    candidate.balls_seen = is_clear ? space_.balls().size() : overlapped;
    return is_clear;
  }

  // Forgets the candidates at the top that are overlapped; what was parked with them is open again.
  void drop_overlapped() {
    while (!ranking_.empty() && !is_clear(ranking_.begin()->candidate)) {
      const std::uint32_t index = ranking_.begin()->candidate;
      ranking_.erase(ranking_.begin());
      for (const std::uint32_t cell : std::exchange(candidates_[index].parked, {})) keep(cell);
    }
  }

  // What a new candidate must exceed.
  double best_rank() {
    drop_overlapped();
    return ranking_.empty() ? minimum_radius() : ranking_.begin()->rank;
  }

  // The best candidate. Among equals the one farthest from the centroid, which tells the two sides
  // of a shape apart that is nearly symmetric; then the one nearest to the last ball. `none` if
  // there is none.
  std::uint32_t choose(std::span<const Ball> placed) {
    const double least = best_rank() * (1.0 - rank_tie);
    const Eigen::Vector3d centroid = space_.centroid();
    std::uint32_t chosen = none;
    double farthest = 0.0;
    double nearest = 0.0;
    for (auto it = ranking_.begin(); it != ranking_.end() && it->rank >= least; ++it) {
      if (!is_clear(it->candidate)) continue;
      const Eigen::Vector3d& center = candidates_[it->candidate].maximum.ball.center;
      const double from_centroid = (center - centroid).norm();
      const double from_last = placed.empty() ? 0.0 : (center - placed.back().center).norm();
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

  DecompositionOptions options_;
  RemainingSpace& space_;
  double scale_;
  double rank_tolerance_;  // by as much may a rank be below the largest possible
  NodePool nodes_;
  std::uint64_t cell_count_ = 0;
  std::uint64_t choice_left_ = all_choice_work;
  CellQueue cells_;
  CellQueue given_up_;  // by the ranks at their centres
  double given_up_bound_ = 0.0;
  std::vector<Candidate> candidates_;
  std::set<Entry> ranking_;  // of the candidates
};

// The whole run: a search for the first balls, up to one that is not in the centre, and a search
// for the others, whose preference rests on it.
class Run {
 public:
  Run(const DistanceField& field, const DecompositionOptions& options)
      : options_(options),
        enclosing_(field.enclosing_ball()),
        space_(field, Preference::outward(enclosing_, preference_weight(options))) {
    result_.scale = enclosing_.radius;
    result_.is_certified = space_.is_closed();
  }

  BallDecomposition run() {
    const bool has_more = search([&] { return is_eccentric(result_.balls.back()); });
    if (has_more) {
      space_.prefer(
          Preference::opposite(enclosing_, result_.balls.back(), preference_weight(options_)));
      search([] { return false; });
    }
    if (!is_complete()) result_.termination = reason();
    result_.cost.distance_queries = space_.query_count();
    return std::move(result_);
  }

 private:
  Termination reason() const {
    if (is_out_of_room_) return Termination::cell_limit;
    return result_.balls.empty() ? Termination::empty_interior : Termination::minimum_radius;
  }

  bool is_complete() const {
    return result_.balls.size() == static_cast<std::size_t>(options_.balls);
  }

  bool is_eccentric(const Ball& ball) const {
    return (ball.center - enclosing_.center).norm() > least_eccentricity * enclosing_.radius;
  }

  // Places balls until `is_enough`, which is asked after each. @returns whether more are wanted
  template <typename Predicate>
  bool search(const Predicate& is_enough) {
    Search search(space_, enclosing_, options_);
    bool has_more = true;
    bool goes_on = !is_complete();
    while (goes_on) {
      has_more = search.place_next(result_);
      goes_on = has_more && !is_complete() && !is_enough();
    }
    result_.cost.cells += search.cell_count();
    if (search.has_given_up()) result_.is_certified = false;
    is_out_of_room_ = !has_more && search.has_given_up();
    return has_more && !is_complete();
  }

  DecompositionOptions options_;
  Ball enclosing_;
  RemainingSpace space_;
  bool is_out_of_room_ = false;
  BallDecomposition result_;
};

}  // namespace

BallDecomposition decompose(const DistanceField& field, const DecompositionOptions& options) {
  if (options.balls < 1) throw InvalidInput("the number of balls must be at least 1");
  if (!(options.radius_tolerance > 0)) throw InvalidInput("the radius tolerance must be above 0");
  if (!(options.minimum_radius > 0)) throw InvalidInput("the minimum radius must be above 0");
  if (options.most_cells < 1000) throw InvalidInput("the number of cells must be at least 1000");
  return Run(field, options).run();
}

}  // namespace mdbd
