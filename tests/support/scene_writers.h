#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "tests/support/mesh_writers.h"

/// Scenes as 3MF, DAE, glTF, GLB and 3DS files, written by hand after the specifications, so that
/// no reader is tested by its own writer.
namespace mdbd::test {

/// One mesh, shown by several nodes below an outer one.
struct Scene {
  TriangleMesh mesh;
  std::vector<Eigen::Affine3d> nodes = {Eigen::Affine3d::Identity()};
  Eigen::Affine3d outer = Eigen::Affine3d::Identity();
};

/// The mesh that a scene shows. A placement that mirrors keeps the outside outside.
inline TriangleMesh flattened(const Scene& scene) {
  TriangleMesh all;
  for (const Eigen::Affine3d& node : scene.nodes) {
    const Eigen::Affine3d placement = scene.outer * node;
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    for (const auto& vertex : scene.mesh.vertices) all.vertices.push_back(placement * vertex);
    for (auto [a, b, c] : scene.mesh.triangles) {
      if (placement.linear().determinant() < 0) std::swap(a, c);
      all.triangles.push_back({a + first, b + first, c + first});
    }
  }
  return all;
}

inline std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320 : 0);
  }
  return ~crc;
}

/// A zip archive that stores its files as they are.
inline std::string to_zip(const std::vector<std::pair<std::string, std::string>>& files) {
  std::string archive;
  std::string directory;
  for (const auto& [name, content] : files) {
    std::string entry;  // what the local and the central header have in common
    for (const std::uint16_t field : {20, 0, 0, 0, 33}) append_number(entry, field);
    append_number(entry, crc32(content));
    for (int i = 0; i < 2; ++i) append_number(entry, static_cast<std::uint32_t>(content.size()));
    append_number(entry, static_cast<std::uint16_t>(name.size()));
    append_number(entry, std::uint16_t{0});
    directory += std::string("PK\1\2\24\0", 6) + entry + std::string(10, '\0');
    append_number(directory, static_cast<std::uint32_t>(archive.size()));
    directory += name;
    archive += "PK\3\4" + entry + name + content;
  }
  std::string end("PK\5\6\0\0\0\0", 8);
  for (int i = 0; i < 2; ++i) append_number(end, static_cast<std::uint16_t>(files.size()));
  append_number(end, static_cast<std::uint32_t>(directory.size()));
  append_number(end, static_cast<std::uint32_t>(archive.size()));
  return archive + directory + end + std::string(2, '\0');
}

/// A 3MF package of this model part.
inline std::string to_3mf_package(const std::string& model) {
  return to_zip(
      {{"[Content_Types].xml",
        "<?xml version=\"1.0\"?><Types "
        "xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"><Default "
        "Extension=\"rels\" "
        "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default "
        "Extension=\"model\" "
        "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>"},
       {"_rels/.rels",
        "<?xml version=\"1.0\"?><Relationships "
        "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
        "Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
       {"3D/3dmodel.model", model}});
}

/// Twelve numbers, column after column.
inline std::string to_3mf_matrix(const Eigen::Affine3d& transform) {
  std::ostringstream out = text_stream();
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      out << (column + row == 0 ? "" : " ") << transform(row, column);
    }
  }
  return out.str();
}

/// @param unit an attribute: " unit=\"inch\""
inline std::string to_3mf(const Scene& scene, const std::string& unit = "") {
  std::ostringstream out = text_stream();
  out << "<?xml version=\"1.0\"?>\n<model" << unit
      << " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>\n"
      << "<object id=\"1\" type=\"model\"><mesh><vertices>\n";
  for (const auto& v : scene.mesh.vertices) {
    out << "<vertex x=\"" << v.x() << "\" y=\"" << v.y() << "\" z=\"" << v.z() << "\"/>\n";
  }
  out << "</vertices><triangles>\n";
  for (const auto& [a, b, c] : scene.mesh.triangles) {
    out << "<triangle v1=\"" << a << "\" v2=\"" << b << "\" v3=\"" << c << "\"/>\n";
  }
  out << "</triangles></mesh></object>\n<object id=\"2\" type=\"model\"><components>\n";
  for (const Eigen::Affine3d& node : scene.nodes) {
    out << "<component objectid=\"1\" transform=\"" << to_3mf_matrix(node) << "\"/>\n";
  }
  out << "</components></object></resources>\n<build><item objectid=\"2\" transform=\""
      << to_3mf_matrix(scene.outer) << "\"/></build></model>\n";
  return to_3mf_package(out.str());
}

/// Sixteen numbers, row after row (COLLADA) or column after column (glTF).
inline std::string to_matrix_text(const Eigen::Affine3d& transform, bool by_rows,
                                  const char* separator) {
  std::ostringstream out = text_stream();
  for (int i = 0; i < 16; ++i) {
    out << (i == 0 ? "" : separator)
        << (by_rows ? transform(i / 4, i % 4) : transform(i % 4, i / 4));
  }
  return out.str();
}

/// @param unit an element: "<unit name=\"centimeter\" meter=\"0.01\"/>"
inline std::string to_dae(const Scene& scene, const std::string& unit = "") {
  std::ostringstream out = text_stream();
  out << "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<COLLADA "
         "xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">\n<asset>"
      << unit << "<up_axis>Z_UP</up_axis></asset>\n"
      << "<library_geometries><geometry id=\"g\" name=\"g\"><mesh>\n<source id=\"p\">"
      << "<float_array id=\"a\" count=\"" << 3 * scene.mesh.vertices.size() << "\">";
  for (const auto& v : scene.mesh.vertices) out << v.x() << ' ' << v.y() << ' ' << v.z() << ' ';
  out << "</float_array><technique_common><accessor source=\"#a\" count=\""
      << scene.mesh.vertices.size()
      << "\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
         "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>\n"
         "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>\n"
         "<triangles count=\""
      << scene.mesh.triangles.size()
      << "\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>";
  for (const auto& [a, b, c] : scene.mesh.triangles) out << a << ' ' << b << ' ' << c << ' ';
  out << "</p></triangles></mesh></geometry></library_geometries>\n"
         "<library_visual_scenes><visual_scene id=\"s\">\n<node id=\"outer\"><matrix>"
      << to_matrix_text(scene.outer, true, " ") << "</matrix>\n";
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    out << "<node id=\"n" << i << "\"><matrix>" << to_matrix_text(scene.nodes[i], true, " ")
        << "</matrix><instance_geometry url=\"#g\"/></node>\n";
  }
  out << "</node></visual_scene></library_visual_scenes>\n"
         "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>\n";
  return out.str();
}

/// The buffer of a glTF file: the vertices in single precision, then the corners.
inline std::string to_gltf_buffer(const Scene& scene) {
  std::string bytes;
  for (const auto& vertex : scene.mesh.vertices) {
    for (const double x : vertex) append_number(bytes, static_cast<float>(x));
  }
  for (const Triangle& triangle : scene.mesh.triangles) {
    for (const std::uint32_t corner : triangle) append_number(bytes, corner);
  }
  return bytes;
}

/// @param uri of the buffer; empty for the second part of a GLB file
inline std::string to_gltf(const Scene& scene, const std::string& uri) {
  const std::size_t vertices = scene.mesh.vertices.size();
  const std::size_t corners = 3 * scene.mesh.triangles.size();
  Eigen::AlignedBox3d box;
  for (const auto& vertex : scene.mesh.vertices) box.extend(vertex);
  std::ostringstream out = text_stream();
  out << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"matrix":[)"
      << to_matrix_text(scene.outer, false, ",") << R"(],"children":[)";
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) out << (i == 0 ? "" : ",") << i + 1;
  out << "]}";
  for (const Eigen::Affine3d& node : scene.nodes) {
    out << R"(,{"mesh":0,"matrix":[)" << to_matrix_text(node, false, ",") << "]}";
  }
  out << R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{)";
  if (!uri.empty()) out << R"("uri":")" << uri << R"(",)";
  out << R"("byteLength":)" << 12 * vertices + 4 * corners
      << R"(}],"bufferViews":[{"buffer":0,"byteLength":)" << 12 * vertices
      << R"(},{"buffer":0,"byteOffset":)" << 12 * vertices << R"(,"byteLength":)" << 4 * corners
      << R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)"
      << vertices << R"(,"min":[)" << box.min().x() << ',' << box.min().y() << ',' << box.min().z()
      << R"(],"max":[)" << box.max().x() << ',' << box.max().y() << ',' << box.max().z()
      << R"(]},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" << corners
      << "}]}\n";
  return out.str();
}

inline std::string to_glb(const Scene& scene) {
  std::string json = to_gltf(scene, "");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string buffer = to_gltf_buffer(scene);
  std::string bytes = "glTF";
  append_number(bytes, std::uint32_t{2});
  append_number(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + buffer.size()));
  append_number(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  append_number(bytes, static_cast<std::uint32_t>(buffer.size()));
  return bytes + std::string("BIN\0", 4) + buffer;
}

inline std::string to_base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = i; j < i + 3; ++j) {
      group = group << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text += i + j <= bytes.size() ? digits[group >> (18 - 6 * j) & 63] : '=';
    }
  }
  return text;
}

/// With its buffer in the file.
inline std::string to_gltf_whole(const Scene& scene) {
  return to_gltf(scene, "data:application/octet-stream;base64," + to_base64(to_gltf_buffer(scene)));
}

inline std::string to_3ds_chunk(std::uint16_t kind, const std::string& content) {
  std::string chunk;
  append_number(chunk, kind);
  append_number(chunk, static_cast<std::uint32_t>(6 + content.size()));
  return chunk + content;
}

/// One object with everything in place, since 3DS keeps coordinates in the world's.
inline std::string to_3ds(const Scene& scene) {
  const TriangleMesh mesh = flattened(scene);
  std::string vertices;
  append_number(vertices, static_cast<std::uint16_t>(mesh.vertices.size()));
  for (const auto& vertex : mesh.vertices) {
    for (const double x : vertex) append_number(vertices, static_cast<float>(x));
  }
  std::string faces;
  append_number(faces, static_cast<std::uint16_t>(mesh.triangles.size()));
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      append_number(faces, static_cast<std::uint16_t>(corner));
    }
    append_number(faces, std::uint16_t{7});
  }
  std::string version;
  append_number(version, std::uint32_t{3});
  const std::string object =
      std::string("object\0", 7) +
      to_3ds_chunk(0x4100, to_3ds_chunk(0x4110, vertices) + to_3ds_chunk(0x4120, faces));
  return to_3ds_chunk(
      0x4d4d, to_3ds_chunk(0x0002, version) + to_3ds_chunk(0x3d3d, to_3ds_chunk(0x4000, object)));
}

/// The scene in each format, by ending.
inline std::vector<std::pair<std::string, std::string>> scene_files(const Scene& scene) {
  return {{".3mf", to_3mf(scene)},
          {".3ds", to_3ds(scene)},
          {".dae", to_dae(scene)},
          {".glb", to_glb(scene)},
          {".gltf", to_gltf_whole(scene)}};
}

}  // namespace mdbd::test
