#pragma once

#include <string_view>

namespace mdbd {

/// The style sheet of a report's page. It holds none of the characters & and <, so that it may
/// stand in HTML and in XML alike.
std::string_view page_style();

}  // namespace mdbd
