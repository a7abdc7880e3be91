#include "features/shape_io/assimp_reader.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>
#include <assimp/BaseImporter.h>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>

#include "features/core/errors.h"
#include "features/shape_io/input_file.h"
#include "features/shape_io/plain_file.h"
#include "features/shape_io/text_cursor.h"
#include "features/shape_io/zip_archive.h"

namespace mdbd {
namespace {

constexpr std::size_t most_corners = 100'000'000;  // of all nodes; a scene may repeat a mesh
constexpr std::size_t longest_reason = 200;        // characters

/// A name with "%20" for a blank, as glTF writes it.
std::string percent_decoded(std::string_view name) {
  std::string decoded;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto is_digit = [&](std::size_t at) {
      return at < name.size() && std::isxdigit(static_cast<unsigned char>(name[at])) != 0;
    };
    if (name[i] == '%' && is_digit(i + 1) && is_digit(i + 2)) {
      decoded += static_cast<char>(std::stoi(std::string(name.substr(i + 1, 2)), nullptr, 16));
      i += 2;
    } else {
      decoded += name[i];
    }
  }
  return decoded;
}

/// What assimp may see: the file, which is in memory, and regular files beside and below it.
class SceneFiles final : public Assimp::IOSystem {
 public:
  SceneFiles(std::filesystem::path folder, std::string name, const std::string& bytes)
      : folder_(std::move(folder)), name_(std::move(name)), bytes_(bytes) {}

  bool Exists(const char* file) const override { return file == name_ || find(file).has_value(); }
  char getOsSeparator() const override { return '/'; }
  void Close(Assimp::IOStream* stream) override { delete stream; }

  Assimp::IOStream* Open(const char* file, const char* mode) override {
    if (std::strchr(mode, 'r') == nullptr) return nullptr;
    if (file == name_) return stream_of(bytes_);
    const auto path = find(file);
    return path ? stream_of(read_input_file(*path)) : nullptr;
  }

 private:
  std::optional<std::filesystem::path> find(const std::string& file) const {
    for (const std::string& name : {file, percent_decoded(file)}) {
      const std::filesystem::path relative = std::filesystem::path(name).lexically_normal();
      if (relative.is_absolute() || relative.empty() || *relative.begin() == "..") continue;
      std::error_code error;
      if (std::filesystem::is_regular_file(folder_ / relative, error)) return folder_ / relative;
    }
    return std::nullopt;
  }

  static Assimp::IOStream* stream_of(const std::string& bytes) {
    auto copy = std::make_unique<std::uint8_t[]>(bytes.size());
    std::memcpy(copy.get(), bytes.data(), bytes.size());
    return new Assimp::MemoryIOStream(copy.release(), bytes.size(), true);
  }

  std::filesystem::path folder_;
  std::string name_;
  const std::string& bytes_;
};

bool reads(const aiImporterDesc& description, std::string_view ending) {
  TextCursor endings(description.mFileExtensions);
  for (std::string_view word = endings.next(); !word.empty(); word = endings.next()) {
    if (word == ending) return true;
  }
  return false;
}

// A file that is not what its ending says must not find another importer by its content.
void keep_importers(Assimp::Importer& importer, std::string_view ending) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    if (reads(*importer.GetImporterInfo(i), ending)) continue;
    const std::unique_ptr<Assimp::BaseImporter> other(importer.GetImporter(i));
    importer.UnregisterLoader(other.get());
  }
}

/// The first line of a message, in ASCII.
std::string one_line(std::string message) {
  message = message.substr(0, std::min(message.find_first_of("\r\n"), longest_reason));
  std::ranges::replace_if(
      message, [](char c) { return c < ' ' || c > '~'; }, '?');
  return message.empty() ? "no reason given" : message;
}

/// The value of an attribute of the first element of a name; empty if there is none.
std::string_view attribute(std::string_view xml, const std::string& element,
                           const std::string& name) {
  const std::size_t start = xml.find("<" + element + " ");
  if (start == xml.npos) return {};
  const std::string_view tag = xml.substr(start, xml.find('>', start) - start);
  const std::size_t at = tag.find(" " + name + "=");
  if (at == tag.npos || at + name.size() + 2 >= tag.size()) return {};
  const std::size_t quote = at + name.size() + 2;
  const std::size_t end = tag.find(tag[quote], quote + 1);
  return end == tag.npos ? std::string_view() : tag.substr(quote + 1, end - quote - 1);
}

/// A word that can stand in a record; else what is to stand there instead.
std::string plain_word(std::string_view word, std::string_view otherwise) {
  const auto is_plain = [](char c) { return c > ' ' && c <= '~' && c != '"' && c != '\\'; };
  const bool is_usable = !word.empty() && word.size() < 40 && std::ranges::all_of(word, is_plain);
  return std::string(is_usable ? word : otherwise);
}

/// The model part of a 3MF package; that of the shortest name is the root.
std::string model_part(std::string_view bytes) {
  std::vector<ZipEntry> parts = list_zip(bytes);
  std::erase_if(parts, [](const ZipEntry& entry) { return !entry.name.ends_with(".model"); });
  if (parts.empty()) throw InvalidInput("not a 3MF file: the archive holds no model");
  const auto size = [](const ZipEntry& entry) { return entry.name.size(); };
  return unpack(*std::ranges::min_element(parts, {}, size));
}

// assimp takes twelve numbers for granted.
void check_transforms(std::string_view xml) {
  constexpr std::string_view name = " transform=";
  for (std::size_t at = xml.find(name); at != xml.npos; at = xml.find(name, at + 1)) {
    const std::string_view value = xml.substr(std::min(at + name.size() + 1, xml.size()));
    TextCursor numbers(value.substr(0, value.find_first_of("\"'")));
    int count = 0;
    for (auto word = numbers.next(); !word.empty(); word = numbers.next()) {
      if (!parse_number(word)) throw InvalidInput("a transform of the 3MF model is no matrix");
      ++count;
    }
    if (count != 12) throw InvalidInput("a transform of the 3MF model has not twelve numbers");
  }
}

std::string examine_3mf(std::string_view bytes) {
  const std::string xml = model_part(bytes);
  if (xml.find(" p:path=") != xml.npos) {
    throw InvalidInput("the 3MF model has objects in other parts, which assimp does not read");
  }
  check_transforms(xml);
  return plain_word(attribute(xml, "model", "unit"), "millimeter");
}

std::string collada_unit(std::string_view xml) {
  const std::string_view meters = attribute(xml, "unit", "meter");
  const std::string name = plain_word(attribute(xml, "unit", "name"), "meter");
  const auto size = meters.empty() ? 1.0 : parse_number(meters);
  if (name == "meter" && size == 1.0) return name;
  return name + " (" + plain_word(meters, "1") + " m)";
}

/// The unit; refuses what assimp would stumble over.
std::string examine(std::string_view bytes, std::string_view ending) {
  if (ending == "3mf") return examine_3mf(bytes);
  if (ending == "dae") return collada_unit(bytes);
  return ending == "3ds" ? "" : "meter";
}

/// Puts the meshes of a scene together.
class SceneCollector {
 public:
  explicit SceneCollector(const aiScene& scene) : scene_(scene) {}

  /// @param keeps_root whether the transformation of the root is the file's
  PolygonMesh collect(bool keeps_root) {
    struct Visit {
      const aiNode* node;
      Eigen::Matrix4d parent;
    };
    std::vector<Visit> visits = {{scene_.mRootNode, Eigen::Matrix4d::Identity()}};
    while (!visits.empty()) {
      const auto [node, parent] = visits.back();
      visits.pop_back();
      const bool is_kept = keeps_root || node != scene_.mRootNode;
      const Eigen::Matrix4d placement = is_kept ? parent * to_eigen(node->mTransformation) : parent;
      for (unsigned i = 0; i < node->mNumMeshes; ++i) add(node->mMeshes[i], placement);
      for (unsigned i = node->mNumChildren; i-- > 0;) {
        visits.push_back({node->mChildren[i], placement});
      }
    }
    polygons_.file_vertices = polygons_.vertices.size();
    polygons_.file_faces = polygons_.face_count();
    return std::move(polygons_);
  }

 private:
  static Eigen::Matrix4d to_eigen(const aiMatrix4x4& matrix) {
    Eigen::Matrix4d result;
    for (unsigned row = 0; row < 4; ++row) {
      for (unsigned column = 0; column < 4; ++column) result(row, column) = matrix[row][column];
    }
    return result;
  }

  void add(unsigned index, const Eigen::Matrix4d& placement) {
    if (index >= scene_.mNumMeshes || scene_.mMeshes[index] == nullptr) {
      throw InvalidInput("a node has a mesh that is not there");
    }
    const aiMesh& mesh = *scene_.mMeshes[index];
    const std::size_t first = polygons_.vertices.size();
    const bool is_mirrored = placement.topLeftCorner<3, 3>().determinant() < 0;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& v = mesh.mVertices[i];
      const Eigen::Vector3d vertex = (placement * Eigen::Vector4d(v.x, v.y, v.z, 1.0)).head<3>();
      require_usable(vertex, polygons_.vertices.size());
      polygons_.vertices.push_back(vertex);
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      add_face(mesh.mFaces[i], mesh.mNumVertices, first, is_mirrored);
    }
    if (std::max(polygons_.vertices.size(), polygons_.corners.size()) > most_corners) {
      throw InvalidInput("the nodes show more than 100 million corners of faces");
    }
  }

  void add_face(const aiFace& face, unsigned vertices, std::size_t first, bool is_mirrored) {
    if (face.mNumIndices < 3) return;  // a line or a point
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      const unsigned corner = face.mIndices[is_mirrored ? face.mNumIndices - 1 - i : i];
      polygons_.corners.push_back(corner < vertices ? static_cast<std::uint32_t>(first + corner)
                                                    : invalid_index);
    }
    polygons_.face_ends.push_back(polygons_.corners.size());
  }

  const aiScene& scene_;
  PolygonMesh polygons_;
};

}  // namespace

SceneMesh read_with_assimp(const std::filesystem::path& path, std::string_view extension,
                           const std::string& bytes) {
  const std::string ending(extension.substr(1));
  const std::string name = "model." + ending;
  SceneMesh result;
  result.unit = examine(bytes, ending);

  Assimp::Importer importer;
  keep_importers(importer, ending);
  importer.SetIOHandler(new SceneFiles(path.parent_path(), name, bytes));  // owns it
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFile(name, 0);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw InvalidInput("assimp cannot read the file: " + one_line(importer.GetErrorString()));
  }
  // Of these two assimp puts the unit or an upward direction of its own into the root.
  const bool keeps_root = ending != "dae" && ending != "3ds";
  result.polygons = SceneCollector(*scene).collect(keeps_root);
  require_faces(result.polygons.file_vertices, result.polygons.file_faces);
  return result;
}

}  // namespace mdbd
