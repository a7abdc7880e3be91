// Files -> OpenCASCADE's shapes.
#include <IFSelect_ReturnStatus.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>

#include "features/brep/occt_shape.h"
#include "features/core/errors.h"
#include "features/shape_io/input_file.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

bool is_iges(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  return equals_ignoring_case(ending, ".iges") || equals_ignoring_case(ending, ".igs");
}

void require_read(IFSelect_ReturnStatus status, const char* kind) {
  if (status != IFSelect_RetDone) {
    throw InvalidInput(std::string("damaged, or no ") + kind + " file");
  }
}

OcctFile read_step(const std::filesystem::path& path) {
  STEPControl_Reader reader;
  require_read(reader.ReadFile(path.c_str()), "STEP");
  TColStd_SequenceOfAsciiString lengths;
  TColStd_SequenceOfAsciiString angles;
  TColStd_SequenceOfAsciiString solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  OcctFile file{.shape = {}, .format = "step", .unit = {}};
  if (!lengths.IsEmpty()) file.unit = lengths.First().ToCString();
  reader.TransferRoots();
  file.shape = reader.OneShape();
  return file;
}

OcctFile read_iges(const std::filesystem::path& path) {
  IGESControl_Reader reader;
  require_read(reader.ReadFile(path.c_str()), "IGES");
  OcctFile file{.shape = {}, .format = "iges", .unit = {}};
  const Handle(IGESData_IGESModel) model = reader.IGESModel();
  const Handle(TCollection_HAsciiString) unit = model->GlobalSection().UnitName();
  if (!unit.IsNull()) file.unit = unit->ToCString();
  reader.TransferRoots();
  file.shape = reader.OneShape();
  return file;
}

}  // namespace

OcctFile read_occt_file(const std::filesystem::path& path) {
  read_beginning(path, 1);  // says why a file cannot be opened
  Message::DefaultMessenger()->ChangePrinters().Clear();  // OpenCASCADE would write to the console
  OcctFile file = is_iges(path) ? read_iges(path) : read_step(path);
  if (file.shape.IsNull()) throw InvalidInput("holds no shape");
  return file;
}

}  // namespace mdbd
