#pragma once

#include <cstdint>

#include "features/shape_io/triangle_mesh.h"

/// Closed meshes that face outward, of about size 2.
namespace mdbd::bench {

/// A torus with about so many triangles. Points of its core circle are equally far from very many
/// of them, which is the worst case of a distance query. @pre triangles >= 100
TriangleMesh make_torus(std::int64_t triangles);

/// A wavy ring of elliptical section that swells three times on the way round, with about so many
/// triangles: a smooth shape without equal distances. @pre triangles >= 100
TriangleMesh make_ring(std::int64_t triangles);

/// A piece of pipe with walls of a fortieth of its diameter and about so many triangles: thin and
/// round, so that very many balls are equally large. @pre triangles >= 100
TriangleMesh make_pipe(std::int64_t triangles);

/// A bracket of bent sheet, an L of a thirtieth of its length in thickness: 20 triangles.
TriangleMesh make_bracket();

}  // namespace mdbd::bench
