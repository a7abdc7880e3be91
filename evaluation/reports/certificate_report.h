#pragma once

#include <cstddef>

#include "evaluation/certificate/recheck.h"
#include "evaluation/evaluation_input.h"
#include "report/report.h"

namespace mdbd {

struct CertificateOptions {
  RecheckOptions search;   ///< its seed is derived from the report's
  std::size_t worst = 10;  ///< how many models of each kind of violation are listed
};

/// Re-checks for every model that its balls are contained, disjoint and maximal, in a way that
/// shares no code with the decomposition, and reports the largest violations with a verdict.
/// Containment and disjointness are measured; of maximality a search for a larger ball is all there
/// is: it can refute, not prove. Models whose surface is open, or whose triangles disagree on what
/// is outside, are measured, but only the disjointness of their balls is judged.
/// @throws as check_models
Report make_certificate_report(const EvaluationInput& input, const CertificateOptions& options);

}  // namespace mdbd
