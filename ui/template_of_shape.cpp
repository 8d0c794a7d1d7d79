#include "ui/template_of_shape.h"

#include "core/learning/template_from_boxes.h"
#include "core/session/actions.h"
#include "ui/selection.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {

void make_template_of_shape(Studio& studio, ShapeId shape) {
  const auto path = studio.collection.path;
  const std::optional<std::size_t> row = find_row(studio.collection, shape);
  if (!row) return;
  const std::string name = studio.collection.rows()[*row].name;
  studio.jobs.start("Make a template from " + name,
                    [&studio, path, shape, name](const JobControl& control) -> Jobs::Apply {
                      const ShapeSamples samples = Project::open(path).samples(shape);
                      const std::optional<Segmentation> segmentation = segment_shape(samples, {}, control);
                      if (!segmentation) return {};
                      PartTemplate made = template_from_segmentation(*segmentation, samples);
                      made.name = "from " + name;
                      return [&studio, path, shape, name, made = std::move(made)] {
                        if (studio.collection.path != path) return;
                        add_template(studio.history, made, "Make a template from " + name);
                        select_only(studio.ui, std::nullopt);
                        studio.ui.centre = CentreView::shape;
                        show_shape(studio, shape);
                        say(studio, Severity::note,
                            "A template of " + plural(made.parts.size(), "part") + " was made from " + name);
                      };
                    });
}

}  // namespace archetype
