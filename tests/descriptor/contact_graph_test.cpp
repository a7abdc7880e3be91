#include "features/descriptor/contact_graph.h"

#include <catch2/catch.hpp>

#include "features/decomposition/decompose.h"
#include "tests/support/analytic_fields.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {
using Neighbours = std::vector<std::uint32_t>;
}

TEST_CASE("balls that touch within the tolerance are joined") {
  const std::vector<Ball> balls{
      {{0, 0, 0}, 1.0}, {{1.5, 0, 0}, 0.5}, {{0, 1.2505, 0}, 0.25}, {{0, 0, 5}, 1.0}};
  const ContactGraph strict = build_contact_graph(balls, 1e-3);
  CHECK(strict.neighbours[0] == Neighbours{1});
  CHECK(strict.neighbours[1] == Neighbours{0});
  CHECK(strict.neighbours[2].empty());
  CHECK(strict.neighbours[3].empty());
  // The gap of 0.0005 counts relative to the smaller radius, 0.25.
  const ContactGraph loose = build_contact_graph(balls, 2.1e-3);
  CHECK(loose.neighbours[0] == Neighbours{1, 2});
}

TEST_CASE("no balls, no contacts") { CHECK(build_contact_graph({}, 1e-3).neighbours.empty()); }

TEST_CASE("the eight corner balls of a cube touch the first ball and nothing else") {
  const BallDecomposition cube = decompose(BoxField({0.5, 0.5, 0.5}), {.balls = 9});
  const ContactGraph graph = build_contact_graph(cube.balls, 1e-6);
  CHECK(graph.neighbours[0] == Neighbours{1, 2, 3, 4, 5, 6, 7, 8});
  for (int i = 1; i < 9; ++i) CHECK(graph.neighbours[i] == Neighbours{0});
}
