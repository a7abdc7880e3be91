// Files -> OpenCASCADE's shapes.
#include <array>
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>

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

// OpenCASCADE crashes on files that end too early. Lines have 80 columns; the 73rd tells their
// section, and the last line how many there are of each.
void require_complete_iges(const std::filesystem::path& path) {
  constexpr std::string_view sections = "SGDP";
  std::ifstream file = open_input_file(path);
  std::array<int, sections.size()> lines{};
  std::string last;
  for (std::string line; std::getline(file, line);) {
    if (line.size() < 73) continue;
    const std::size_t section = sections.find(line[72]);
    if (section != sections.npos) ++lines[section];
    last = line;
  }
  if (last.size() < 73 || last[72] != 'T') throw InvalidInput("cut off, or no IGES file");
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const std::string count = last.substr(8 * i + 1, 7);
    if (std::strtol(count.c_str(), nullptr, 10) != lines[i]) {
      throw InvalidInput("damaged: the lines of the file are not those that its end tells");
    }
  }
}

OcctFile read_iges(const std::filesystem::path& path) {
  require_complete_iges(path);
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
  read_beginning(path, 1);                                // says why a file cannot be opened
  Message::DefaultMessenger()->ChangePrinters().Clear();  // OpenCASCADE would write to the console
  OcctFile file = is_iges(path) ? read_iges(path) : read_step(path);
  if (file.shape.IsNull()) throw InvalidInput("holds no shape");
  return file;
}

}  // namespace mdbd
