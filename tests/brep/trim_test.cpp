#include "features/brep/trim.h"

#include <cmath>
#include <memory>
#include <numbers>

#include <catch2/catch.hpp>

using namespace mdbd;
using Eigen::Vector2d;

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

class UnitCircle final : public ParameterCurve {
 public:
  Vector2d at(double t) const override { return {std::cos(t), std::sin(t)}; }
};

/// The unit disc, with an outline of few chords.
BrepFace disc(int sides) {
  BrepFace face;
  const auto circle = std::make_shared<UnitCircle>();
  for (int i = 0; i < sides; ++i) {
    const double first = turn * i / sides;
    const double last = turn * (i + 1) / sides;
    face.outline.push_back({circle->at(first), circle->at(last), first, last, circle});
  }
  return face;
}

}  // namespace

TEST_CASE("an outline is exact between the ends of its chords") {
  for (const int sides : {3, 4, 17}) {
    const Trim trim(disc(sides));
    for (int i = 0; i < 100; ++i) {
      const double angle = 0.0137 + turn * i / 100;
      const Vector2d direction(std::cos(angle), std::sin(angle));
      CHECK(trim.contains((1.0 - 1e-9) * direction));
      CHECK_FALSE(trim.contains((1.0 + 1e-9) * direction));
      CHECK(trim.contains(0.3 * direction));
    }
  }
}

TEST_CASE("parameters are the same after whole periods") {
  BrepFace face;
  face.period = {turn, 0.0};
  const Vector2d corners[] = {{5, 0}, {8, 0}, {8, 1}, {5, 1}};
  for (int i = 0; i < 4; ++i) face.outline.push_back({corners[i], corners[(i + 1) % 4]});
  const Trim trim(face);
  CHECK(trim.contains({6.0, 0.5}));
  CHECK(trim.contains({6.0 - turn, 0.5}));
  CHECK(trim.contains({7.5 - 2 * turn, 0.5}));
  CHECK_FALSE(trim.contains({9.0, 0.5}));
  CHECK_FALSE(trim.contains({6.0, 1.5}));
}
