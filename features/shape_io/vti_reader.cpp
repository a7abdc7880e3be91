#include "features/shape_io/vti_reader.h"

#include <cstdint>

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLImageDataReader.h>

#include "features/core/errors.h"

namespace mdbd {
namespace {

constexpr std::int64_t most_points = std::int64_t{1} << 27;
constexpr std::int64_t most_points_per_byte = 1032;  // zlib does no better

// Before VTK allocates what the extent claims.
void check_extent(vtkXMLImageDataReader& reader, std::size_t bytes) {
  int extent[6] = {0, -1, 0, -1, 0, -1};
  reader.GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  std::int64_t points = 1;
  for (int i = 0; i < 3; ++i) {
    const std::int64_t size = std::int64_t{extent[2 * i + 1]} - extent[2 * i] + 1;
    if (size < 1) throw InvalidInput("VTK finds no grid in the file");
    if (size > most_points / points) {
      throw InvalidInput("the grid has not three sizes that multiply to 1 to 512^3 points");
    }
    points *= size;
  }
  if (points / most_points_per_byte > static_cast<std::int64_t>(bytes)) {
    throw InvalidInput("truncated: the file is too short for the points that it claims");
  }
}

VoxelGrid to_grid(vtkImageData& image) {
  vtkDataArray* values = image.GetPointData()->GetScalars();
  if (values == nullptr) values = image.GetPointData()->GetArray(0);
  if (values == nullptr) throw InvalidInput("the file has no values at the points of its grid");
  if (values->GetNumberOfComponents() != 1) {
    throw InvalidInput("the grid has several values at a point");
  }
  VoxelGrid grid;
  int size[3];
  image.GetDimensions(size);
  for (std::size_t i = 0; i < 3; ++i) grid.size[i] = static_cast<std::size_t>(size[i]);
  const vtkIdType count = values->GetNumberOfTuples();
  if (static_cast<std::size_t>(count) != grid.size[0] * grid.size[1] * grid.size[2]) {
    throw InvalidInput("truncated: the file has not a value for each point");
  }
  grid.values.reserve(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i) grid.values.push_back(values->GetComponent(i, 0));
  double first[3];
  image.GetPoint(0, first);
  for (int row = 0; row < 3; ++row) {
    grid.origin[row] = first[row];
    for (int column = 0; column < 3; ++column) {
      grid.steps(row, column) =
          image.GetDirectionMatrix()->GetElement(row, column) * image.GetSpacing()[column];
    }
  }
  return grid;
}

}  // namespace

VoxelGrid read_vti(const std::string& bytes) {
  vtkObject::GlobalWarningDisplayOff();  // it would print
  vtkNew<vtkXMLImageDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->UpdateInformation();
  if (reader->GetErrorCode() != 0) throw InvalidInput("VTK cannot read the file's header");
  check_extent(*reader, bytes.size());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  if (reader->GetErrorCode() != 0 || image == nullptr) {
    throw InvalidInput("VTK cannot read the file's values");
  }
  return to_grid(*image);
}

}  // namespace mdbd
