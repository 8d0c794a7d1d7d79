#include "core/session/fit_collection.h"

#include <doctest/doctest.h>

#include "core/base/error.h"
#include "core/session/evaluate_labelling.h"
#include "tests/support/imported_chairs.h"

using namespace archetype;
using namespace archetype::test;

namespace {

struct Chairs : ImportedChairs {
  using ImportedChairs::ImportedChairs;
  FitCollectionReport fit(const std::vector<PartTemplate>& templates, const JobControl& control = {}) {
    return fit_collection(project, templates, {}, 2, control);
  }
};

// A template that no chair looks like.
PartTemplate pole_template() {
  PartTemplate pole;
  pole.name = "pole";
  pole.parts.resize(1);
  pole.parts[0].name = "pole";
  pole.parts[0].scale.mean = {0.02, 3, 0.02};
  pole.parts[0].scale.stddev = {0.01, 0.01, 0.01};
  return pole;
}

}  // namespace

TEST_CASE("every shape gets the template that fits it best, with labels for all its faces") {
  Chairs chairs(6);
  const FitCollectionReport report = chairs.fit({pole_template(), chair_template()});
  CHECK(report.fitted == 6);
  CHECK(report.refused.empty());
  const std::vector<TemplateRecord> templates = chairs.project.templates();
  REQUIRE(templates.size() == 2);
  CHECK(templates[0].part_template == pole_template());
  for (const ShapeRecord& shape : chairs.project.shapes()) {
    CHECK(chairs.project.fit(shape.id)->part_template == templates[1].id);
    CHECK(chairs.project.labels(shape.id)->size() == shape.element_count);
  }
}

TEST_CASE("fits are kept while templates and options stay the same") {
  Chairs chairs(5);
  CHECK(chairs.fit({chair_template()}).fitted == 5);
  FitCollectionReport again = chairs.fit({chair_template()});
  CHECK(again.fitted == 0);
  CHECK(again.kept == 5);

  PartTemplate changed = chair_template();
  changed.parts[0].position.mean.y() += 0.01;
  CHECK(chairs.fit({changed}).fitted == 5);
  CHECK(chairs.project.templates().size() == 1);
  CHECK(chairs.project.templates(false).size() == 2);

  FitOptions options;
  options.max_alternations = 3;
  again = fit_collection(chairs.project, {changed}, options, 2, {});
  CHECK(again.fitted == 5);
  CHECK(chairs.project.templates(false).size() == 2);
}

TEST_CASE("a shape whose file is gone or changed is fitted, and labelled once the file is back") {
  Chairs chairs(3);
  const std::filesystem::path gone = chairs.project.shapes()[0].path;
  const std::filesystem::path changed = chairs.project.shapes()[1].path;
  std::filesystem::rename(gone, gone.string() + ".away");
  std::filesystem::copy_file(chairs.project.shapes()[2].path, changed,
                             std::filesystem::copy_options::overwrite_existing);
  FitCollectionReport report = chairs.fit({chair_template()});
  CHECK(report.fitted == 3);
  REQUIRE(report.refused.size() == 2);
  CHECK(report.refused[0].path == gone);
  CHECK(report.refused[1].reason.find("has changed") != std::string::npos);
  const std::vector<FitSummary> fits = chairs.project.fits();
  REQUIRE(fits.size() == 3);
  CHECK_FALSE(fits[0].has_labels);
  CHECK_FALSE(fits[1].has_labels);
  CHECK(fits[2].has_labels);

  std::filesystem::rename(gone.string() + ".away", gone);
  report = chairs.fit({chair_template()});
  CHECK(report.fitted == 0);
  CHECK(report.kept == 3);
  CHECK(report.refused.size() == 1);
  CHECK(chairs.project.fits()[0].has_labels);
}

TEST_CASE("a cancelled fit keeps what is done and goes on from there") {
  Chairs chairs(40);
  std::stop_source source;
  JobControl control;
  control.stop = source.get_token();
  control.report = [&](std::size_t done, std::size_t, std::string_view what) {
    if (done == 5 && what == "fitting") source.request_stop();
  };
  const FitCollectionReport first = chairs.fit({chair_template()}, control);
  CHECK(first.cancelled);
  CHECK(first.fitted >= 5);
  CHECK(first.fitted < 40);
  CHECK(chairs.project.fits().size() == first.fitted);
  const FitCollectionReport second = chairs.fit({chair_template()});
  CHECK(second.kept == first.fitted);
  CHECK(second.fitted == 40 - first.fitted);
}

TEST_CASE("a fit without a template is a mistake of the caller") {
  Project project = Project::in_memory();
  CHECK_THROWS_AS(fit_collection(project, {}, {}, 1, {}), PreconditionError);
}

TEST_CASE("evaluation measures what is labelled and lists what is left out") {
  Chairs chairs(5);
  chairs.fit({chair_template()});
  const std::filesystem::path labels = chairs.folder.path() / "labels";
  const std::string first = chairs.project.shapes()[0].name;
  const std::string second = chairs.project.shapes()[1].name;
  std::filesystem::remove(labels / (first + ".seg"));
  chairs.folder.write("labels/" + second + ".seg", "0\n1\nno number\n");
  // With a separator at its end, as shells complete it.
  const LabellingEvaluation evaluation = evaluate_labelling(chairs.project, labels / "", 2, {});
  CHECK(evaluation.without_truth == std::vector<std::string>{first});
  REQUIRE(evaluation.refused.size() == 1);
  CHECK(evaluation.refused[0].reason.find("line 3") != std::string::npos);
  REQUIRE(evaluation.report.shapes.size() == 3);
  CHECK(evaluation.parts.size() == 6);
  // The template is rough; what matters here is that parts and labels are not mixed up.
  CHECK(evaluation.report.mean.own.by_area > 0.7);
  CHECK(evaluation.report.total.best.by_area >= evaluation.report.total.own.by_area);

  chairs.project.clear_fits();
  CHECK(evaluate_labelling(chairs.project, labels, 2, {}).without_labels.size() == 5);
  CHECK_THROWS_AS(evaluate_labelling(chairs.project, labels / "none", 2, {}), FileError);
}

TEST_CASE("label files that name their labels in different orders agree") {
  Chairs chairs(2);
  chairs.fit({chair_template()});
  const std::filesystem::path labels = chairs.folder.path() / "labels";
  std::filesystem::remove_all(labels);
  // All faces are called "body", which is the first name of one file and the second of the other.
  std::string faces[2];
  for (std::size_t i = 0; i < 2; ++i) {
    const ShapeRecord shape = chairs.project.shapes()[i];
    for (std::size_t f = 1; f <= shape.element_count; ++f) faces[i] += std::to_string(f) + " ";
  }
  chairs.folder.write("labels/" + chairs.project.shapes()[0].name + "_labels.txt",
                      "body\n" + faces[0] + "\n");
  chairs.folder.write("labels/" + chairs.project.shapes()[1].name + "_labels.txt",
                      "none\n\nbody\n" + faces[1] + "\n");
  const LabellingEvaluation evaluation = evaluate_labelling(chairs.project, labels, 2, {});
  CHECK(evaluation.refused.empty());
  CHECK(evaluation.label_names == std::vector<std::string>{"body", "none"});
  for (const auto& [pair, share] : evaluation.report.own_confusion) CHECK(pair.second == 0);
}
