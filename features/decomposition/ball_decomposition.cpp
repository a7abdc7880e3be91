#include "features/decomposition/ball_decomposition.h"

namespace mdbd {

std::string_view to_string(Termination termination) {
  switch (termination) {
    case Termination::ball_count:
      return "number of balls reached";
    case Termination::minimum_radius:
      return "minimum radius reached";
    case Termination::empty_interior:
      return "empty interior";
  }
  return "unknown";
}

}  // namespace mdbd
