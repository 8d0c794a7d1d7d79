// Fits a set of templates to every shape of a project and labels the faces (FitTemplateSet of figure 2).
#pragma once

#include <span>

#include "core/base/job_control.h"
#include "core/fitting/fit_options.h"
#include "core/io/project.h"

namespace archetype {

struct FitCollectionReport {
  std::size_t fitted = 0;
  std::size_t kept = 0;               // had a fit by the same templates and options already
  std::vector<RefusedInput> refused;  // shapes whose file is gone or changed, or whose fit failed
  bool cancelled = false;
};

// Each shape takes the template with the least choice_energy(). Fits and labels are stored as they are made,
// in batches, so a stopped run goes on from there. `templates` become the current set of the project. What
// was corrected by hand (Project::corrections()) is heeded: pinned yaws, templates and labels limit the fit
// of their own shape and say nothing to others, and what was marked as outlier or to be learned from has that
// status. A shape whose corrections have changed is fitted anew.
FitCollectionReport fit_collection(Project& project, const std::vector<PartTemplate>& templates,
                                   const FitOptions& options, unsigned threads, const JobControl& control);

// The same for these shapes alone, with the templates and the options that the project has (FitOptions{}):
// those whose corrections have changed since they were fitted. A shape without a fit stays without, and one
// whose correction names a template or a part that is not there (it was renamed, say) keeps the fit it has.
FitCollectionReport fit_corrected(Project& project, std::span<const ShapeId> shapes, unsigned threads,
                                  const JobControl& control);

}  // namespace archetype
