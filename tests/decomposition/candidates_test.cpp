#include "features/decomposition/candidates.h"

#include <vector>

#include <catch2/catch.hpp>

using namespace mdbd;

namespace {

LocalMaximum ball_at(double x, double y, double radius, double basin_radius = 0.0) {
  return {{{x, y, 0}, radius}, radius, basin_radius};
}

}  // namespace

TEST_CASE("a maximum that is found again is the same candidate") {
  const BallSet balls({{0, 0, 0}, 1.0});
  Candidates candidates(balls, 1.0);
  const std::uint32_t first = candidates.add(ball_at(0.3, 0, 0.1));
  CHECK(candidates.add(ball_at(0.3 + 1e-9, 0, 0.1 + 1e-10)) == first);
  CHECK(candidates.add(ball_at(-0.3, 0, 0.1)) != first);
  CHECK(candidates.add(ball_at(0.3, 0, 0.101)) != first);
  CHECK(candidates.best_rank() == 0.101);
}

TEST_CASE("candidates that a ball overlaps give their cells back") {
  BallSet balls({{0, 0, 0}, 1.0});
  Candidates candidates(balls, 1.0);
  const std::uint32_t best = candidates.add(ball_at(0.5, 0, 0.2, 0.05));
  const std::uint32_t other = candidates.add(ball_at(-0.5, 0, 0.1, 0.05));
  candidates.park(best, 7);
  candidates.park(best, 8);
  candidates.park(other, 9);
  std::vector<std::uint32_t> reopened;
  const auto reopen = [&](std::uint32_t cell) { reopened.push_back(cell); };
  candidates.drop_overlapped(reopen);
  CHECK(reopened.empty());
  CHECK(candidates.resolves(best, Cell({0.5, 0, 0}, 0.01, 0.3)));
  balls.add({{0.5, 0.1, 0}, 0.15}, 0.2);
  candidates.drop_overlapped(reopen);
  CHECK(reopened == std::vector<std::uint32_t>{7, 8});
  CHECK(!candidates.resolves(best, Cell({0.5, 0, 0}, 0.01, 0.3)));
  CHECK(candidates.choose({0, 0, 0}) == other);
}

TEST_CASE("a cell is resolved by a basin, or by the very ball that ranks as high") {
  const BallSet balls({{0, 0, 0}, 1.0});
  Candidates candidates(balls, 1.0);
  const std::uint32_t held = candidates.add(ball_at(0.5, 0, 0.2, 0.05));
  const std::uint32_t loose = candidates.add(ball_at(-0.5, 0, 0.2, 0.0));
  CHECK(candidates.find_resolving(Cell({0.5, 0.01, 0}, 0.01, 0.9)) == held);
  CHECK(candidates.find_resolving(Cell({0.5, 0.06, 0}, 0.01, 0.9)) == Candidates::none);
  CHECK(candidates.find_resolving(Cell({-0.5, 0, 0}, 0.0005, 0.2)) == loose);
  CHECK(candidates.find_resolving(Cell({-0.5, 0, 0}, 0.0005, 0.21)) == Candidates::none);
  // A twin may be within the ball.
  CHECK(candidates.find_resolving(Cell({-0.5, 0.1, 0}, 0.0005, 0.2)) == Candidates::none);
}

TEST_CASE("equal candidates are told apart by the centroid, then by the last ball") {
  BallSet balls({{0, 0, 0}, 1.0});
  balls.add({{0, 0.8, 0}, 0.1}, 0.1);
  Candidates candidates(balls, 1.0);
  const std::uint32_t left = candidates.add(ball_at(-0.5, 0.1, 0.1));
  const std::uint32_t right = candidates.add(ball_at(0.5, -0.1, 0.1));
  const std::uint32_t smaller = candidates.add(ball_at(0.9, 0, 0.1 * (1 - 1e-8)));
  CHECK(candidates.choose({0.1, 0, 0}) == left);
  CHECK(candidates.choose({-0.1, 0, 0}) == right);
  CHECK(candidates.choose({0, 0, 0}) == left);  // it is nearer to the ball
  CHECK(candidates.choose({-5, 0, 0}) != smaller);
}
