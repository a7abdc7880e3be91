#pragma once

#include <string>
#include <string_view>

#include "query/answer_query.h"

/// The part of a page that draws balls when a picture is clicked: plain JavaScript on canvases.
namespace mdbd {

/// The balls of a shape as a JSON array of integers, x, y, z, r of each in thousandths of R, about
/// the middle of the balls.
std::string balls_to_json(const std::vector<Ball>& balls, double scale);

/// A dialog element, hidden at first, and the script that opens it. A click on an element with
/// `data-match` shows the balls under that name, and beside them those under its `data-query`
/// unless they are the same; `data-differ` has the numbers, from 1, of balls to be highlighted.
/// Names are members of the JSON object in the element #balls. Well-formed as HTML and as XML.
std::string_view ball_viewer();

}  // namespace mdbd
