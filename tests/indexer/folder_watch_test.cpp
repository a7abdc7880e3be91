#include "indexer/folder_watch.h"

#include <catch2/catch.hpp>

#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace fs = std::filesystem;

namespace {

using Paths = std::set<std::string>;

Paths changes_of(FolderWatch& watch) {
  watch.wait(std::chrono::milliseconds(0));
  return watch.take_changes().paths;
}

}  // namespace

TEST_CASE("files that may be models, and folders, are heard of") {
  const TemporaryDirectory folder;
  fs::create_directories(folder / "a/b");
  const std::vector<std::string> roots = {folder.path()};
  FolderWatch watch(roots);
  CHECK(watch.limit().empty());
  CHECK_FALSE(watch.wait(std::chrono::milliseconds(0)));
  folder.write("a/b/model.OFF", "1");
  folder.write("notes.md", "2");
  folder.write("mdbd.db", "3");
  folder.write(".hidden.off", "4");
  CHECK(changes_of(watch) == Paths{folder / "a/b/model.OFF"});
  CHECK(changes_of(watch).empty());
  fs::remove(folder / "a/b/model.OFF");
  fs::create_directory(folder / ".git");
  CHECK(changes_of(watch) == Paths{folder / "a/b/model.OFF"});
  folder.write(".git/model.off", "5");
  CHECK(changes_of(watch).empty());
}

TEST_CASE("a new folder is watched, and a renamed one by its new name") {
  const TemporaryDirectory folder;
  const std::vector<std::string> roots = {folder.path()};
  FolderWatch watch(roots);
  fs::create_directories(folder / "new/deep");
  CHECK(changes_of(watch).contains(folder / "new"));
  folder.write("new/deep/a.off", "1");
  CHECK(changes_of(watch) == Paths{folder / "new/deep/a.off"});
  fs::rename(folder / "new", folder / "other");
  CHECK(changes_of(watch) == Paths{folder / "new", folder / "other"});
  folder.write("other/deep/b.off", "1");
  CHECK(changes_of(watch) == Paths{folder / "other/deep/b.off"});
}

TEST_CASE("of a root that is a file only itself is heard of") {
  const TemporaryDirectory folder;
  const std::vector<std::string> roots = {folder.write("a.off", "1")};
  FolderWatch watch(roots);
  folder.write("b.off", "2");
  CHECK(changes_of(watch).empty());
  folder.write("a.off", "3");
  CHECK(changes_of(watch) == Paths{folder / "a.off"});
}

TEST_CASE("a root that is not there is a limit until it comes") {
  const TemporaryDirectory folder;
  fs::create_directory(folder / "root");
  const std::vector<std::string> roots = {folder / "root"};
  FolderWatch watch(roots);
  fs::rename(folder / "root", folder / "away");
  changes_of(watch);
  CHECK(watch.limit() == (folder / "root").string() + " is not there");
  watch.watch_again();
  CHECK_FALSE(watch.limit().empty());
  fs::create_directory(folder / "root");
  watch.watch_again();
  CHECK(watch.limit().empty());
  folder.write("root/a.off", "1");
  CHECK(changes_of(watch) == Paths{folder / "root/a.off"});
}
