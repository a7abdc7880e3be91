#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mdbd {

/// "1 model", "2 models"
/// @param ending of the plural
inline std::string counted(std::size_t number, std::string_view one,
                           std::string_view ending = "s") {
  std::string text = std::to_string(number) + ' ';
  text += one;
  if (number != 1) text += ending;
  return text;
}

}  // namespace mdbd
