#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mdbd {

/// Cells by their bounds, the largest first; equal ones in the order of their numbers, so that the
/// order does not depend on the history of the queue. A heap of four children to a node.
class CellQueue {
 public:
  struct Entry {
    double bound;
    std::uint32_t cell;
  };

  bool is_empty() const { return heap_.empty(); }
  std::size_t size() const { return heap_.size(); }
  /// @pre not empty
  const Entry& top() const { return heap_.front(); }

  /// The entries of which one is at the top after the top is gone.
  std::span<const Entry> next() const {
    return std::span(heap_)
        .subspan(std::min<std::size_t>(1, heap_.size()))
        .first(std::min(arity, heap_.empty() ? 0 : heap_.size() - 1));
  }

  void push(const Entry& entry) {
    std::size_t at = heap_.size();
    heap_.push_back(entry);
    while (at > 0 && comes_before(entry, heap_[(at - 1) / arity])) {
      heap_[at] = heap_[(at - 1) / arity];
      at = (at - 1) / arity;
    }
    heap_[at] = entry;
  }

  /// Gives the top cell a lower bound. @pre not empty
  void lower_top(double bound) { sink({bound, heap_.front().cell}); }

  /// @pre not empty
  void pop() {
    const Entry last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) sink(last);
  }

 private:
  static constexpr std::size_t arity = 4;

  static bool comes_before(const Entry& a, const Entry& b) {
    return a.bound != b.bound ? a.bound > b.bound : a.cell < b.cell;
  }

  // Puts an entry in the place of the top.
  void sink(const Entry& entry) {
    std::size_t at = 0;
    while (true) {
      const std::size_t first = arity * at + 1;
      if (first >= heap_.size()) break;
      const std::size_t end = first + arity < heap_.size() ? first + arity : heap_.size();
      std::size_t best = first;
      for (std::size_t child = first + 1; child < end; ++child) {
        if (comes_before(heap_[child], heap_[best])) best = child;
      }
      if (!comes_before(heap_[best], entry)) break;
      heap_[at] = heap_[best];
      at = best;
    }
    heap_[at] = entry;
  }

  std::vector<Entry> heap_;
};

}  // namespace mdbd
