#pragma once

#include <string>

#include "report/report.h"

namespace mdbd {

/// A table as an HTML table with its caption; rows that are too short are filled with empty cells.
std::string html_table(const Table& table);

/// A confusion matrix as an HTML table: counts shaded by their share of the row, and beside them
/// how many models each class has and which share of them was recognised (recall), below them which
/// share of what was taken for the class belongs to it (precision), in the corner the accuracy.
/// @throws InvalidInput if the counts are not one row and one column for each class
std::string html_confusion_matrix(const ConfusionMatrix& matrix);

}  // namespace mdbd
