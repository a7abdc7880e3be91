#include "evaluation/labelled_collection.h"

#include <algorithm>
#include <cstdlib>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> names(const LabelledCollection& collection) {
  std::vector<std::string> names;
  for (const LabelledModel& model : collection.models) names.push_back(model.name);
  return names;
}

std::string all_notes(const LabelledCollection& collection) {
  std::string text;
  for (const std::string& note : collection.notes) text += note + '\n';
  return text;
}

void write_class(const test::TemporaryDirectory& folder, const std::string& label, int models) {
  for (int i = 0; i < models; ++i) folder.write(label + '/' + std::to_string(i) + ".off", "x");
}

}  // namespace

TEST_CASE("the first folder on the way to a model is its class") {
  test::TemporaryDirectory folder;
  folder.write("chair/b.off", "x");
  folder.write("chair/a.stl", "xx");
  folder.write("chair-high/deep/er/c.obj", "x");
  folder.write("chair/notes.txt", "x");
  const LabelledCollection found = find_labelled_models(folder.path(), 0, 1);
  CHECK(names(found) ==
        std::vector<std::string>{"chair/a.stl", "chair/b.off", "chair-high/deep/er/c.obj"});
  CHECK(found.models[0].label == "chair");
  CHECK(found.models[0].file.size == 2);
  CHECK(found.models[0].file.path == (folder / "chair/a.stl").string());
  CHECK(found.models[2].label == "chair-high");
  CHECK_THAT(all_notes(found), Contains("1 class of one model: chair-high."));
  CHECK_THAT(all_notes(found), Contains("distractor"));
}

TEST_CASE("a relative path to a collection and a slash at its end change nothing") {
  test::TemporaryDirectory folder;
  write_class(folder, "a", 2);
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  const LabelledCollection here = find_labelled_models(".", 0, 1);
  fs::current_path(before);
  CHECK(names(here) == std::vector<std::string>{"a/0.off", "a/1.off"});
  CHECK(names(find_labelled_models(folder.path() / "", 0, 1)) == names(here));
  CHECK(here.notes.empty());
}

TEST_CASE("models outside the classes and unusable paths are noted") {
  test::TemporaryDirectory folder;
  write_class(folder, "a", 2);
  for (const char* name : {"1.off", "2.off", "3.off", "4.off"}) folder.write(name, "x");
  fs::create_symlink("nowhere", folder / "a/broken.off");
  const LabelledCollection found = find_labelled_models(folder.path(), 0, 1);
  CHECK(names(found) == std::vector<std::string>{"a/0.off", "a/1.off"});
  CHECK_THAT(all_notes(found), Contains("4 models in no folder of a class, left out: 1.off, "
                                        "2.off, 3.off and 1 more."));
  CHECK_THAT(all_notes(found), Contains("broken.off (is a link to nothing)"));
  REQUIRE(found.unusable.size() == 1);
}

TEST_CASE("what is no collection is refused with a reason") {
  test::TemporaryDirectory folder;
  CHECK_THROWS_AS(find_labelled_models(folder / "missing", 0, 1), IoError);
  const fs::path file = folder.write("file.off", "x");
  CHECK_THROWS_AS(find_labelled_models(file, 0, 1), IoError);
  CHECK_THROWS_WITH(find_labelled_models(file, 0, 1), Contains("is no folder"));
  CHECK_THROWS_AS(find_labelled_models(folder.path(), 0, 1), InvalidInput);
  CHECK_THROWS_WITH(find_labelled_models(folder.path(), 0, 1),
                    Contains("1 model but no folders of classes"));
  fs::remove(file);
  CHECK_THROWS_WITH(find_labelled_models(folder.path(), 0, 1), Contains("holds no models"));
}

TEST_CASE("a sample is drawn from each class with a seed") {
  test::TemporaryDirectory folder;
  write_class(folder, "a", 30);
  write_class(folder, "b", 2);
  const LabelledCollection first = find_labelled_models(folder.path(), 3, 7);
  CHECK(first.models.size() == 5);
  const std::vector<std::string> drawn = names(first);
  CHECK(std::ranges::is_sorted(drawn));
  CHECK(std::ranges::adjacent_find(drawn) == drawn.end());
  CHECK_THAT(all_notes(first), Contains("at most 3 models of each class, drawn with seed 7"));
  CHECK(names(find_labelled_models(folder.path(), 3, 7)) == names(first));
  CHECK(names(find_labelled_models(folder.path(), 3, 8)) != names(first));

  SECTION("it does not depend on the other classes") {
    write_class(folder, "0", 9);
    std::vector<std::string> more = names(find_labelled_models(folder.path(), 3, 7));
    more.erase(more.begin(), more.begin() + 3);
    CHECK(more == names(first));
  }
  SECTION("it does not depend on the order in which files were made") {
    test::TemporaryDirectory other;
    for (int i = 29; i >= 0; --i) other.write("a/" + std::to_string(i) + ".off", "x");
    write_class(other, "b", 2);
    CHECK(names(find_labelled_models(other.path(), 3, 7)) == names(first));
  }
}

TEST_CASE("every model of a class is drawn about equally often") {
  test::TemporaryDirectory folder;
  write_class(folder, "a", 5);
  std::vector<int> counts(5);
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    for (const std::string& name : names(find_labelled_models(folder.path(), 2, seed))) {
      ++counts[name[2] - '0'];
    }
  }
  for (const int count : counts) CHECK(std::abs(count - 200) < 60);  // five standard deviations
}
