// write_assembly FILE N: writes a STEP or IGES file of N boxes, the i-th of 1 x 2 x i.
#include <cstdlib>
#include <filesystem>

#include "tests/brep/occt_solids.h"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  using mdbd::test::OcctSolid;
  OcctSolid all = OcctSolid::box({0, 0, 0}, {1, 2, 1});
  const double count = std::atof(argv[2]);
  for (double i = 2; i <= count; ++i) {
    all = all.beside(OcctSolid::box({10 * i, 0, 0}, {10 * i + 1, 2, i}));
  }
  const std::filesystem::path path = argv[1];
  if (path.extension() == ".step") {
    all.write_step(path);
  } else {
    all.write_iges(path);
  }
}
