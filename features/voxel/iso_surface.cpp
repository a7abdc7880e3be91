#include "features/voxel/iso_surface.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <Eigen/LU>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "features/core/errors.h"

namespace mdbd {
namespace {

/// Calls a function for all points with their place in the grid.
template <typename Use>
void for_each_point(const VoxelGrid& grid, const Use& use) {
  std::size_t index = 0;
  for (std::size_t z = 0; z < grid.size[2]; ++z) {
    for (std::size_t y = 0; y < grid.size[1]; ++y) {
      for (std::size_t x = 0; x < grid.size[0]; ++x) use(x, y, z, grid.values[index++]);
    }
  }
}

bool is_above_inside(const VoxelGrid& grid, double value) {
  std::int64_t above = 0;
  for_each_point(grid, [&](std::size_t x, std::size_t y, std::size_t z, double at) {
    const bool is_border = x == 0 || y == 0 || z == 0 || x + 1 == grid.size[0] ||
                           y + 1 == grid.size[1] || z + 1 == grid.size[2];
    if (is_border) above += at > value ? 1 : -1;
  });
  return above <= 0;
}

/// The grid, negative outside and positive inside, within a layer of outside.
vtkNew<vtkImageData> to_image(const VoxelGrid& grid, double value, bool is_above, double outside) {
  vtkNew<vtkImageData> image;
  int size[3];
  for (std::size_t i = 0; i < 3; ++i) size[i] = static_cast<int>(grid.size[i]) + 2;
  image->SetDimensions(size);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->AllocateScalars(VTK_DOUBLE, 1);
  auto* const values = static_cast<double*>(image->GetScalarPointer());
  std::fill_n(values, image->GetNumberOfPoints(), outside);
  const auto width = static_cast<std::size_t>(size[0]);
  const auto height = static_cast<std::size_t>(size[1]);
  for_each_point(grid, [&](std::size_t x, std::size_t y, std::size_t z, double at) {
    values[((z + 1) * height + y + 1) * width + x + 1] = is_above ? at - value : value - at;
  });
  return image;
}

TriangleMesh to_mesh(vtkPolyData& surface, const VoxelGrid& grid) {
  TriangleMesh mesh;
  for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i) {
    double point[3];
    surface.GetPoint(i, point);
    mesh.vertices.push_back(grid.origin +
                            grid.steps * Eigen::Vector3d(point[0], point[1], point[2]));
  }
  const bool is_mirrored = grid.steps.determinant() < 0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < surface.GetPolys()->GetNumberOfCells(); ++i) {
    surface.GetPolys()->GetCellAtId(i, corners);
    Triangle triangle;
    for (vtkIdType j = 0; j < 3; ++j) {
      triangle[static_cast<std::size_t>(j)] = static_cast<std::uint32_t>(corners->GetId(j));
    }
    if (is_mirrored) std::swap(triangle[1], triangle[2]);
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

}  // namespace

IsoSurface find_iso_surface(const VoxelGrid& grid) {
  const auto [least, largest] = std::ranges::minmax(grid.values);
  if (!(least < largest)) throw InvalidInput("the values of the grid are the same everywhere");
  const bool is_signed = least < 0 && largest > 0;
  IsoSurface surface;
  surface.kind = is_signed ? "signed distance" : "occupancy";
  surface.value = is_signed ? 0.0 : least + 0.5 * (largest - least);
  const bool is_above = is_above_inside(grid, surface.value);
  surface.inside = is_above ? "above" : "below";
  // Next to a distance that is cut off by the border, the boundary is a step away at most.
  const double step = grid.steps.colwise().norm().minCoeff();
  const double outside = is_signed ? -step : -0.5 * (largest - least);

  vtkObject::GlobalWarningDisplayOff();  // it would print
  const auto image = to_image(grid, surface.value, is_above, outside);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, 0.0);
  edges->ComputeNormalsOff();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  surface.mesh = to_mesh(*edges->GetOutput(), grid);
  return surface;
}

}  // namespace mdbd
