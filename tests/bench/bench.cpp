// Milliseconds of one core for the steps that everything waits for. Run one comparison within one run: ratios
// hold where absolute times do not.
#include <benchmark/benchmark.h>

#include <map>

#include "core/evaluation/label_elements.h"
#include "core/fitting/fit_template.h"
#include "core/fitting/label_costs.h"
#include "core/fitting/point_graph.h"
#include "core/fitting/template_surface.h"
#include "core/geometry/features.h"
#include "tests/support/made_shapes.h"
#include "tests/support/plain_fit.h"
#ifdef ARCHETYPE_BENCH_CGAL
#include "tests/bench/cgal_segmentation.h"
#endif

using namespace archetype;

namespace {

// A chair with arms: eight parts. The shape that is fitted is another one.
struct Case {
  PartTemplate part_template;
  test::MadeShape shape;
};

Case eight_parts() {
  GenerateOptions options;
  options.yaw = YawChoice::quarters;
  for (std::size_t i = 0;; ++i) {
    PartTemplate candidate = test::template_from(test::make_shape("chairs", options, i));
    if (candidate.parts.size() == 8)
      return {std::move(candidate), test::make_shape("chairs", options, i + 1)};
  }
}

// Every triangle cut in four until there are at least `faces`.
PolygonMesh refine(PolygonMesh mesh, std::size_t faces) {
  while (mesh.face_count() < faces) {
    PolygonMesh finer;
    finer.vertices = mesh.vertices;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, fresh] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(finer.vertices.size()));
      if (fresh) finer.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
      return at->second;
    };
    for (const auto& [a, b, c] : triangulate(mesh).triangles) {
      const auto ab = middle(a, b);
      const auto bc = middle(b, c);
      const auto ca = middle(c, a);
      for (const auto& t :
           {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}}) {
        finer.add_face(t);
      }
    }
    mesh = std::move(finer);
  }
  return mesh;
}

void sampling(benchmark::State& state) {
  const PolygonMesh mesh = refine(generate_shape("chairs", {}, 0).mesh, 10000);
  for (auto _ : state) benchmark::DoNotOptimize(sample_shape(mesh, {}, {}));
}
BENCHMARK(sampling)
    ->Name("import: samples, normals, features of a mesh of 10,000 faces")
    ->Unit(benchmark::kMillisecond);

void features(benchmark::State& state) {
  const Case c = eight_parts();
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        compute_features(c.shape.samples.points, feature_radius * c.shape.samples.radius));
  }
}
BENCHMARK(features)->Name("features of 1,000 points")->Unit(benchmark::kMillisecond);

void labelling(benchmark::State& state) {
  const Case c = eight_parts();
  const FitOptions options;
  const LabellingGraph graph = make_point_graph(c.shape.samples, options);
  const PartTemplate part_template = with_expected_features(c.part_template);
  std::vector<Box> boxes;
  for (const auto& part : part_template.parts) boxes.push_back(part.mean_box());
  const auto costs_of_features = feature_costs(part_template, c.shape.samples.features_x, options);
  LabelCosts costs;
  label_costs(c.shape.samples.points, boxes, costs_of_features,
              options.distance_unit * c.shape.samples.radius, options, costs);
  ExpansionWorkspace workspace;
  for (auto _ : state) {
    std::vector<std::int16_t> labels(c.shape.samples.size(), 0);
    benchmark::DoNotOptimize(expand_labels(graph, costs, boxes.size() + 1, labels, workspace));
  }
}
BENCHMARK(labelling)->Name("one labelling, 1,000 points, 9 labels, cold")->Unit(benchmark::kMillisecond);

void whole_fit(benchmark::State& state) {
  const Case c = eight_parts();
  double energy = 0;
  for (auto _ : state) energy = fit_template(c.part_template, c.shape.samples, {})->energy.total();
  state.counters["energy"] = energy;
}
BENCHMARK(whole_fit)->Name("whole fit, 1,000 points, 8 parts, 4 yaws")->Unit(benchmark::kMillisecond);

void plain_whole_fit(benchmark::State& state) {
  const Case c = eight_parts();
  double energy = 0;
  for (auto _ : state) energy = test::plain_fit(c.part_template, c.shape.samples, {}).energy.total();
  state.counters["energy"] = energy;
}
BENCHMARK(plain_whole_fit)
    ->Name("whole fit done plainly (Boost, no pruning, no warm start, brute force)")
    ->Unit(benchmark::kMillisecond);

void label_mesh(benchmark::State& state) {
  const Case c = eight_parts();
  const PolygonMesh mesh = refine(c.shape.generated.mesh, 10000);
  for (auto _ : state) {
    const ShapeSamples samples = sample_shape(mesh, {}, {});
    const auto fit = fit_template(c.part_template, samples, {});
    benchmark::DoNotOptimize(label_elements(mesh, samples, c.part_template, *fit, {}));
  }
  state.counters["faces"] = static_cast<double>(mesh.face_count());
}
BENCHMARK(label_mesh)
    ->Name("mesh to labels of faces: samples, fit with 4 yaws, cut")
    ->Unit(benchmark::kMillisecond);

#ifdef ARCHETYPE_BENCH_CGAL
void cgal(benchmark::State& state) {
  const PolygonMesh mesh = refine(eight_parts().shape.generated.mesh, 10000);
  for (auto _ : state) benchmark::DoNotOptimize(test::cgal_segmentation(mesh));
  state.counters["faces"] = static_cast<double>(mesh.face_count());
}
BENCHMARK(cgal)->Name("the same mesh by CGAL's segmentation_via_sdf_values")->Unit(benchmark::kMillisecond);
#endif

}  // namespace

BENCHMARK_MAIN();
