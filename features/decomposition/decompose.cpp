#include "features/decomposition/decompose.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <queue>

#include "features/core/errors.h"
#include "features/decomposition/cell.h"
#include "features/decomposition/local_maximum.h"

namespace mdbd {
namespace {

// A ball is polished until less than this is to be gained, relative to R.
constexpr double polish_precision = 1e-12;
constexpr std::uint32_t no_candidate = std::numeric_limits<std::uint32_t>::max();

// Cells and candidates by their value, the largest first; ties in order of creation.
struct Entry {
  double value;
  std::uint32_t index;
  bool operator<(const Entry& other) const {
    return value != other.value ? value < other.value : index > other.index;
  }
};

struct Node {
  Cell cell;
  std::uint32_t candidate = no_candidate;  // found from this cell or an ancestor
  bool is_misleading = false;              // a climb from the centre led to nothing
};

struct Candidate {
  LocalMaximum maximum;
  std::size_t balls_seen;  // it is known to be clear of so many balls
};

// Branch and bound over an octree, one heap for the whole run. The top of the heap bounds every
// ball still possible; bounds only fall as balls are placed, so they are brought up to date when a
// cell reaches the top.
class Search {
 public:
  Search(const DistanceField& field, const DecompositionOptions& options)
      : options_(options), space_(field), scale_(field.enclosing_ball().radius) {
    const Ball whole = field.enclosing_ball();
    add({Cell(whole.center, whole.radius, whole.radius)});
  }

  BallDecomposition run() {
    BallDecomposition result;
    result.scale = scale_;
    result.is_certified = space_.is_closed();
    const auto wanted = static_cast<std::size_t>(options_.balls);
    while (result.balls.size() < wanted) {
      const double bound = refine_until_certain();
      const Candidate* best = best_candidate();
      if (best == nullptr) break;
      const Ball ball = best->maximum.ball;
      result.balls.push_back(ball);
      result.upper_bounds.push_back(std::max(bound, ball.radius));
      space_.place(ball);
    }
    if (result.balls.size() < wanted) {
      result.termination =
          result.balls.empty() ? Termination::empty_interior : Termination::minimum_radius;
    }
    result.cost = {space_.query_count(), cell_count_};
    return result;
  }

 private:
  double minimum_radius() const { return options_.minimum_radius * scale_; }

  // Works on the cell with the largest bound until the best candidate is within the tolerance of
  // everything else that is possible. Returns the upper bound then.
  double refine_until_certain() {
    while (!cells_.empty()) {
      const Entry top = cells_.top();
      if (top.value <= best_radius() * (1.0 + options_.radius_tolerance)) return top.value;
      cells_.pop();
      refine(top.index);
    }
    return minimum_radius();
  }

  // Does the cheapest thing that may lower the bound of a cell.
  void refine(std::uint32_t index) {
    Cell& cell = nodes_[index].cell;
    if (!cell.is_current(space_)) {
      cell.tighten(space_);
    } else if (!cell.is_measured()) {
      cell.measure(space_);
    } else if (!nodes_[index].is_misleading && cell.value() > best_radius()) {
      nodes_[index].is_misleading = !climb(index, cell.center());
    } else if (cell.wants_probe()) {
      const auto [point, value] = cell.probe(space_);
      if (value > best_radius()) climb(index, point);
    } else {
      divide(index);
      return;
    }
    keep(index);
  }

  // Climbs from a point that seems better than every candidate to one that is better still. False
  // if there is none, which happens where the sign of the field jumps at a hole of the boundary.
  bool climb(std::uint32_t index, const Eigen::Vector3d& start) {
    Node& node = nodes_[index];
    const LocalMaximum maximum =
        find_local_maximum(space_, start, node.cell.half_size(), polish_precision * scale_);
    if (maximum.ball.radius <= best_radius()) return false;
    node.candidate = static_cast<std::uint32_t>(candidates_.size());
    candidates_.push_back({maximum, space_.balls().size()});
    ranking_.push({maximum.ball.radius, node.candidate});
    apply_basin(node);
    return true;
  }

  // A cell inside the basin of a candidate has nothing better.
  void apply_basin(Node& node) const {
    if (node.candidate == no_candidate) return;
    const LocalMaximum& maximum = candidates_[node.candidate].maximum;
    if (node.cell.reach(maximum.ball.center) > maximum.basin_radius) return;
    node.cell.limit(maximum.ball.radius * (1.0 + contact_accuracy));
  }

  void divide(std::uint32_t index) {
    const Node parent = nodes_[index];
    free_.push_back(index);
    for (int octant = 0; octant < 8; ++octant) {
      Node child{parent.cell.child(octant), parent.candidate};
      apply_basin(child);
      add(child);
    }
  }

  void add(const Node& node) {
    ++cell_count_;
    std::uint32_t index;
    if (free_.empty()) {
      index = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back(node);
    } else {
      index = free_.back();
      free_.pop_back();
      nodes_[index] = node;
    }
    keep(index);
  }

  // Puts a cell into the heap, unless no ball of the minimum radius can be in it.
  void keep(std::uint32_t index) {
    const double bound = nodes_[index].cell.bound();
    if (bound > minimum_radius()) {
      cells_.push({bound, index});
    } else {
      free_.push_back(index);
    }
  }

  // The largest candidate that no ball placed since overlaps; null if there is none.
  const Candidate* best_candidate() {
    while (!ranking_.empty()) {
      Candidate& best = candidates_[ranking_.top().index];
      const Ball& ball = best.maximum.ball;
      if (best.balls_seen == space_.balls().size()) return &best;
      if (space_.balls().gap(ball.center) >= ball.radius) {
        best.balls_seen = space_.balls().size();
        return &best;
      }
      ranking_.pop();
    }
    return nullptr;
  }

  // What a new candidate must exceed.
  double best_radius() {
    const Candidate* best = best_candidate();
    return best != nullptr ? best->maximum.ball.radius : minimum_radius();
  }

  DecompositionOptions options_;
  RemainingSpace space_;
  double scale_;
  std::deque<Node> nodes_;           // never moved, so that growing needs no second copy
  std::vector<std::uint32_t> free_;  // nodes to be used again
  std::uint64_t cell_count_ = 0;
  std::priority_queue<Entry> cells_;
  std::vector<Candidate> candidates_;
  std::priority_queue<Entry> ranking_;  // of the candidates
};

}  // namespace

BallDecomposition decompose(const DistanceField& field, const DecompositionOptions& options) {
  if (options.balls < 1) throw InvalidInput("the number of balls must be at least 1");
  if (!(options.radius_tolerance > 0)) throw InvalidInput("the radius tolerance must be above 0");
  if (!(options.minimum_radius > 0)) throw InvalidInput("the minimum radius must be above 0");
  return Search(field, options).run();
}

}  // namespace mdbd
