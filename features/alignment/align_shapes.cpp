#include "features/alignment/align_shapes.h"

#include <cstddef>
#include <limits>
#include <vector>

#include "features/alignment/rotation_search.h"
#include "features/alignment/surface_overlay.h"

namespace mdbd {
namespace {

constexpr std::size_t coarse_balls = 60;
constexpr std::size_t fine_balls = 500;
// Few points may fit worse than many do in the end.
constexpr double coarse_allowance = 2.0;

/// Improves motions with few points, and with many those that may be within the tolerance.
class MotionSearch {
 public:
  MotionSearch(const PackedShape& first, const PackedShape& second, double tolerance)
      : coarse_(first, second, coarse_balls),
        fine_(first, second, fine_balls),
        tolerance_(tolerance) {}

  /// Tries motions until one is within the tolerance.
  bool find(const std::vector<Similarity>& starts) {
    for (const Similarity& start : starts) {
      try_motion(start);
      if (best_.deviation <= tolerance_) return true;
    }
    return false;
  }

  const Alignment& best() const { return best_; }

 private:
  void try_motion(const Similarity& start) {
    const Alignment coarse = refine(coarse_, start);
    const bool is_promising = coarse.deviation <= coarse_allowance * tolerance_;
    const Alignment result = is_promising ? refine(fine_, coarse.motion) : coarse;
    if (result.deviation < best_.deviation) best_ = result;
  }

  static Alignment refine(const SurfaceOverlay& overlay, const Similarity& motion) {
    const Similarity refined = overlay.refine(motion);
    return {refined, largest_error(overlay.measure(refined))};
  }

  SurfaceOverlay coarse_;
  SurfaceOverlay fine_;
  double tolerance_;
  Alignment best_{.motion = {}, .deviation = std::numeric_limits<double>::infinity()};
};

}  // namespace

Alignment align_shapes(const PackedShape& first, const PackedShape& second, double tolerance) {
  MotionSearch motions(first, second, tolerance);
  const RotationSearch rotations(first.balls, second.balls);
  if (!motions.find(rotations.likely())) motions.find(rotations.polished());
  return motions.best();
}

}  // namespace mdbd
