#pragma once

#include <string>
#include <string_view>

namespace mdbd {

/// The style sheet of a report's page. It holds none of the characters & and <, so that it may
/// stand in HTML and in XML alike.
std::string_view page_style();

/// The beginning of a page, up to and with its head element.
/// @param title plain text
/// @param more_style rules after those of page_style(), free of & and <
std::string page_head(std::string_view title, std::string_view more_style = "");

}  // namespace mdbd
