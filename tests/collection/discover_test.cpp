#include "collection/discover.h"

#include <catch2/catch.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "features/core/errors.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
namespace fs = std::filesystem;

namespace {

Discovery discover_one(const fs::path& path) { return discover(std::vector{path}); }

std::vector<std::string> names(const Discovery& found, const fs::path& folder) {
  std::vector<std::string> names;
  for (const FoundFile& file : found.files)
    names.push_back(fs::path(file.path).lexically_relative(folder));
  return names;
}

std::string reason(const Discovery& found, const fs::path& path) {
  for (const UnusablePath& unusable : found.unusable) {
    if (unusable.path == path) return unusable.reason;
  }
  return "";
}

}  // namespace

TEST_CASE("models are found at any depth, in order, with size and time") {
  test::TemporaryDirectory folder;
  folder.write("b/c/d.STL", "1234");
  folder.write("a.off", "");
  folder.write("b.ply", "");
  folder.write("notes.txt", "");
  folder.write(".git/e.off", "");
  folder.write(".f.off", "");
  const Discovery found = discover_one(folder.path());
  CHECK(names(found, folder.path()) == std::vector<std::string>{"a.off", "b.ply", "b/c/d.STL"});
  CHECK(found.files.back().size == 4);
  CHECK(found.files.back().modified_ns > 0);
  CHECK(found.unusable.empty());
}

TEST_CASE("point clouds are models, other texts beside them are not") {
  test::TemporaryDirectory folder;
  folder.write("a.pcd", "");
  folder.write("b.XYZ", "");
  folder.write("c.txt", "0 0 0\n1 0 0\n");
  folder.write("d.csv", "x,y,z\n0,0,0\n");
  folder.write("readme.txt", "Points of a chair.\n");
  folder.write("results.csv", "model,distance\na.pcd,0.1\n");
  const Discovery found = discover_one(folder.path());
  CHECK(names(found, folder.path()) ==
        std::vector<std::string>{"a.pcd", "b.XYZ", "c.txt", "d.csv"});
  CHECK(found.unusable.empty());
}

TEST_CASE("overlapping and untidy paths give each model once") {
  test::TemporaryDirectory folder;
  folder.write("a/b.off", "");
  const fs::path paths[] = {folder / "a/../a/b.off", folder / "a/", folder.path() / ".",
                            folder / "a//b.off"};
  const Discovery found = discover(paths);
  CHECK(names(found, folder.path()) == std::vector<std::string>{"a/b.off"});
  CHECK(found.roots == std::vector<std::string>{folder.path(), folder / "a", folder / "a/b.off"});
}

TEST_CASE("what looks like a model and is none has its own reason") {
  test::TemporaryDirectory folder;
  folder.write("a.off/inside.off", "");
  REQUIRE(mkfifo((folder / "pipe.ply").c_str(), 0600) == 0);
  fs::create_symlink("nowhere", folder / "link.obj");
  fs::create_symlink("/dev/null", folder / "device.stl");
  fs::create_symlink("loop.stl", folder / "loop.stl");
  const Discovery found = discover_one(folder.path());
  CHECK(names(found, folder.path()) == std::vector<std::string>{"a.off/inside.off"});
  CHECK(found.unusable.size() == 5);
  CHECK(reason(found, folder / "a.off") == "is a directory, not a model file");
  CHECK(reason(found, folder / "pipe.ply") == "is a named pipe, not a model file");
  CHECK(reason(found, folder / "link.obj") == "is a link to nothing");
  CHECK(reason(found, folder / "device.stl") == "is a device, not a model file");
  CHECK_THAT(reason(found, folder / "loop.stl"), Catch::Contains("cannot be read"));
}

TEST_CASE("links to files are followed, links to folders are not") {
  test::TemporaryDirectory folder;
  folder.write("real/a.off", "");
  fs::create_symlink("real/a.off", folder / "b.off");
  fs::create_directory_symlink("..", folder / "real/loop");
  const Discovery found = discover_one(folder.path());
  CHECK(names(found, folder.path()) == std::vector<std::string>{"b.off", "real/a.off"});
  fs::create_directory_symlink("real", folder / "other");
  CHECK(discover_one(folder / "other").files.size() == 1);
}

TEST_CASE("paths asked for by name") {
  test::TemporaryDirectory folder;
  const fs::path hidden = folder.write(".hidden.off", "");
  CHECK(discover_one(hidden).files.size() == 1);
  const fs::path text = folder.write("notes.md", "");
  CHECK_THAT(reason(discover_one(text), text),
             Catch::Contains("unsupported ending") && Catch::Contains(".off"));
  CHECK_THROWS_AS(discover_one(folder / "missing.off"), IoError);
  CHECK_THROWS_WITH(discover_one(folder / "missing.off"),
                    Catch::Contains("missing.off: No such file"));
}

TEST_CASE("a folder that cannot be read, or only listed, is unusable") {
  test::TemporaryDirectory folder;
  folder.write("closed/a.off", "");
  folder.write("closed/b.off", "");
  folder.write("open.off", "");
  fs::permissions(folder / "closed", GENERATE(fs::perms::none, fs::perms::owner_read));
  if (access((folder / "closed").c_str(), X_OK) != 0) {  // root may read everything
    const Discovery found = discover_one(folder.path());
    CHECK(found.files.size() == 1);
    CHECK(found.unusable.size() == 1);
    CHECK_THAT(reason(found, folder / "closed"), Catch::Contains("Permission denied"));
  }
  fs::permissions(folder / "closed", fs::perms::owner_all);
}

TEST_CASE("any name that a file can have") {
  test::TemporaryDirectory folder;
  for (const char* name : {"new\nline.off", "quote'\".off", "\xff\xfe.off", "-x.off"})
    folder.write(name, "");
  CHECK(discover_one(folder.path()).files.size() == 4);
}

TEST_CASE("within means at or below") {
  const std::vector<std::string> roots = {"/a/b", "/c.off"};
  CHECK(is_within("/a/b", roots));
  CHECK(is_within("/a/b/c.off", roots));
  CHECK(is_within("/c.off", roots));
  CHECK_FALSE(is_within("/a/bc", roots));
  CHECK_FALSE(is_within("/a", roots));
  CHECK(is_within("/a", std::vector<std::string>{"/"}));
  const std::vector<std::string> part{"/a/b.step"};
  CHECK(is_within("/a/b.step#2", part));
  CHECK_FALSE(is_within("/a/b.step#b", part));
  CHECK_FALSE(is_within("/a/b.step", std::vector<std::string>{"/a/b.step#2"}));
}

TEST_CASE("of changed paths what is gone, or no model, is a root and nothing else") {
  const test::TemporaryDirectory folder;
  const std::string model = folder.write("a.off", "");
  const std::string text = folder.write("notes.md", "");
  fs::create_directory(folder / "sub");
  const std::string below = folder.write("sub/b.off", "");
  const std::string gone = folder / "gone.off";
  const std::vector<fs::path> paths = {model, text, gone, folder / "sub"};
  const Discovery found = discover_changed(paths);
  CHECK(found.roots.size() == 4);
  CHECK(found.unusable.empty());
  REQUIRE(found.files.size() == 2);
  CHECK(found.files[0].path == model);
  CHECK(found.files[1].path == below);
}

TEST_CASE("paths that do not exist can be passed over, as no roots") {
  const test::TemporaryDirectory folder;
  const std::string model = folder.write("a.off", "");
  const std::vector<fs::path> paths = {model, folder / "gone"};
  const Discovery found = discover_existing(paths);
  CHECK(found.roots == std::vector<std::string>{model});
  CHECK(found.files.size() == 1);
}

TEST_CASE("one solid of a CAD file may be asked for, and a file may have a # in its name") {
  test::TemporaryDirectory folder;
  const fs::path part = folder.write("a#1.step", "123");
  const Discovery found = discover_one(part.string() + "#2");
  REQUIRE(found.files.size() == 1);
  CHECK(found.files[0].path == part.string() + "#2");
  CHECK(found.files[0].size == 3);
  folder.write("a.step#2", "");  // no model
  CHECK(names(discover_one(folder.path()), folder.path()) == std::vector<std::string>{"a#1.step"});
  CHECK_THROWS_AS(discover_one(folder / "b.step#2"), IoError);
}
