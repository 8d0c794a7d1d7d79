// The sections of the report, one function each. Not for others.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/base/job_control.h"
#include "core/io/project.h"
#include "core/report/html_report.h"
#include "core/session/evaluate_labelling.h"
#include "core/session/learn_templates.h"

namespace archetype {

// What all of them are written from, read once.
struct ReportContent {
  const Project& project;
  std::vector<TemplateRecord> templates;  // the current ones, then others that fits still have
  std::vector<FitSummary> fits;           // ordered by name
  std::map<ShapeId, std::string> names;
  std::vector<RefusedInput> refused;
  std::optional<LearningRecord> learning;
  const JobControl& control;
  const DrawShape& draw;
  std::size_t pictures = 0;  // so far
};

std::string collection_section(const ReportContent& content);
std::string templates_section(const ReportContent& content);
// Thumbnails of the members of each template, best first, and of the outliers.
std::string clusters_section(ReportContent& content);
std::string worst_fits_section(ReportContent& content);
std::string accuracy_section(const LabellingEvaluation& evaluation);
std::string learning_section(const ReportContent& content);  // "" where nothing was learned
std::string settings_section(const ReportContent& content);
std::string refused_section(const ReportContent& content);  // "" where nothing was

}  // namespace archetype
