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
    case Termination::cell_limit:
      return "no room for more cells";
  }
  return "unknown";
}

}  // namespace mdbd
