#include "features/decomposition/decompose.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "features/core/errors.h"
#include "features/decomposition/block_pool.h"
#include "features/decomposition/candidates.h"
#include "features/decomposition/cell.h"
#include "features/decomposition/cell_queue.h"
#include "features/decomposition/local_maximum.h"

namespace mdbd {
namespace {

// A ball is polished until less than this is to be gained, relative to R.
constexpr double polish_precision = 4e-16;
// Where the rank is lower than this, relative to the best, no candidate of equal rank is close.
constexpr double near_tie = 0.9999;
// A ball whose centre is farther from that of the enclosing ball, relative to R, is eccentric.
constexpr double least_eccentricity = 1e-2;
// How much work goes into telling near-equal maxima apart: for one ball, and for all.
constexpr std::uint64_t most_choice_work = 25'000;
constexpr std::uint64_t all_choice_work = 250'000;
struct Node {
  Cell cell;
  std::uint32_t candidate = Candidates::none;  // found from this cell or an ancestor
  bool has_climbed = false;                    // from the centre
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
      : options_(options),
        space_(space),
        scale_(enclosing.radius),
        candidates_(space.balls(), scale_) {
    const double weight = preference_weight(options);
    rank_tolerance_ = (options.radius_tolerance - weight) / (1.0 + weight);
    keep(add({Cell(space.in_domain(enclosing.center), scale_, scale_ * (1.0 + weight))}));
  }

  // Places the next ball. @returns false if there is none
  bool place_next(BallDecomposition& result) {
    update_best();
    const double bound = refine_until_certain();
    const std::uint32_t chosen = candidates_.choose(space_.centroid());
    if (chosen == Candidates::none) return false;
    const Ball ball = candidates_[chosen].ball;
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
      if (bound <= enough()) break;
      const bool is_choice = bound <= best_rank_ * (1.0 + rank_tolerance_);
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
    if (given_up_.is_empty()) return best_rank_ * (1.0 + contact_accuracy);
    climb_from_given_up();
    return std::max(best_rank_ * (1.0 + contact_accuracy), given_up_bound_);
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
    while (!given_up_.is_empty() && given_up_.top().bound > best_rank_) {
      const std::uint32_t index = given_up_.top().cell;
      Cell& cell = nodes_[index].cell;
      cell.tighten(space_, enough());
      if (rank_at_center(cell) > best_rank_) climb(index, cell.center());
      given_up_.pop();
      if (cell.bound() <= minimum_radius()) continue;
      given_up_.push({std::min(rank_at_center(cell), best_rank_), index});
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
      if (value * space_.preference().factor(point) > best_rank_) climb(index, point);
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
  double enough() const { return Candidates::equal_to(best_rank_); }

  double rank_at_center(const Cell& cell) const {
    return cell.value() * space_.preference().factor(cell.center());
  }

  // Whether the centre is better than the best candidate, or cannot be told from it.
  bool is_promising(const Cell& cell) const {
    const double rank = rank_at_center(cell);
    return rank > best_rank_ ||
           (rank > near_tie * best_rank_ && cell.bound() <= best_rank_ * (1.0 + rank_tolerance_));
  }

  // Finds the candidate of a promising cell.
  void explore(std::uint32_t index) {
    nodes_[index].candidate = candidates_.find_resolving(nodes_[index].cell);
    if (nodes_[index].candidate == Candidates::none) climb(index, nodes_[index].cell.center());
  }

  // Climbs to a candidate, perhaps one that was found before.
  void climb(std::uint32_t index, const Eigen::Vector3d& start) {
    Node& node = nodes_[index];
    const LocalMaximum maximum =
        find_local_maximum(space_, start, node.cell.half_size(), polish_precision * scale_);
    if (maximum.ball.radius <= minimum_radius()) return;
    node.candidate = candidates_.add(maximum);
    update_best();
  }

  void divide(std::uint32_t index) {
    const Node parent = nodes_[index];
    nodes_.remove(index);
    if (space_.is_planar()) {
      divide_planar(parent);
    } else {
      divide_solid(parent);
    }
  }

  void divide_planar(const Node& parent) {
    for (int quadrant = 0; quadrant < 4; ++quadrant) {
      keep(add({parent.cell.planar_child(quadrant), parent.candidate}));
    }
  }

  void divide_solid(const Node& parent) {
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
      candidates_.park(node.candidate, index);
    } else {
      return false;
    }
    return true;
  }

  bool is_resolved(const Node& node) {
    return node.candidate != Candidates::none && candidates_.resolves(node.candidate, node.cell);
  }

  // After a ball was placed or a candidate was found.
  void update_best() {
    candidates_.drop_overlapped([&](std::uint32_t cell) { keep(cell); });
    best_rank_ = std::max(candidates_.best_rank(), minimum_radius());
  }

  DecompositionOptions options_;
  RemainingSpace& space_;
  double scale_;
  double rank_tolerance_;  // by as much may a rank be below the largest possible
  BlockPool<Node> nodes_;
  double best_rank_ = 0.0;  // what a new candidate must exceed
  std::uint64_t cell_count_ = 0;
  std::uint64_t choice_left_ = all_choice_work;
  CellQueue cells_;
  CellQueue given_up_;  // by the ranks at their centres
  double given_up_bound_ = 0.0;
  Candidates candidates_;
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
