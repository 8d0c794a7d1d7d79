// Shapes one after the other, several at once; then their points are mixed.
#include "core/session/coaligned_cloud.h"

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>

#include "core/base/random.h"
#include "core/session/ordered_pipeline.h"

namespace archetype {

namespace {

struct Work {
  ShapeId id = 0;
  std::optional<FitRecord> fit;  // nothing: the shape is left out
  std::size_t place = 0;         // of its template
  std::shared_ptr<const PartTemplate> part_template;
  ShapeSamples samples;
  Coaligned coaligned;
};

class CloudReader {
 public:
  CloudReader(const Project& project, const CloudRequest& request) : project_(project), request_(request) {}

  std::optional<CoalignedCloud> run(const JobControl& control) {
    ring_.resize(pipeline_window(request_.threads));
    const PipelineSteps steps{.prepare = [this](std::size_t i) { load(i); },
                              .compute = [this](std::size_t i) { compute(slot(i)); },
                              .finish = [this](std::size_t i) { take(slot(i)); }};
    if (!ordered_pipeline(request_.shapes.size(), request_.threads, control, "co-aligning", steps))
      return std::nullopt;
    shuffle();
    return std::move(cloud_);
  }

 private:
  Work& slot(std::size_t i) { return ring_[i % ring_.size()]; }

  void load(std::size_t i) {
    Work& work = slot(i) = {};
    work.id = request_.shapes[i];
    work.fit = project_.fit(work.id);
    if (!work.fit) return;
    const auto place = template_place(work.fit->part_template);
    if (place) work.samples = project_.samples(work.id);
    // Another program may have read the shape anew between the two.
    if (!place || work.samples.size() != work.fit->fit.labels.size()) {
      work.fit.reset();
      return;
    }
    work.place = *place;
    work.part_template = templates_[*place];
  }

  std::optional<std::size_t> template_place(TemplateId id) {
    const auto known = places_.find(id);
    if (known != places_.end()) return known->second;
    std::optional<TemplateRecord> record = project_.find_template(id);
    if (!record) return std::nullopt;
    templates_.push_back(std::make_shared<const PartTemplate>(record->part_template));
    cloud_.templates.push_back(std::move(*record));
    return places_[id] = templates_.size() - 1;
  }

  static void compute(Work& work) {
    if (!work.fit) return;
    const std::vector<Box> boxes = free_boxes(*work.part_template, work.samples, work.fit->fit);
    work.coaligned = coalign(*work.part_template, work.samples, work.fit->fit, boxes);
  }

  void take(const Work& work) {
    if (!work.fit) return;
    const auto number = static_cast<std::uint32_t>(cloud_.shapes.size());
    cloud_.shapes.push_back({work.id, work.place});
    cloud_.samples += work.samples.size();
    cloud_.sharpness += work.coaligned.sharpness;
    const std::size_t share = std::max<std::size_t>(1, request_.most_points / request_.shapes.size());
    const auto seed = derive_seed(1, static_cast<std::uint64_t>(work.id));
    for (const std::size_t i : random_subset(work.samples.size(), share, seed)) {
      cloud_.points.push_back({number, work.fit->fit.labels[i]});
      cloud_.rigid.emplace_back(work.coaligned.rigid[i].cast<float>());
      cloud_.deformed.emplace_back(work.coaligned.deformed[i].cast<float>());
      cloud_.normals.emplace_back(
          turn_quarters(work.samples.normals[i], -work.fit->fit.yaw_quarters).cast<float>());
    }
  }

  void shuffle() {
    std::vector<std::uint32_t> order(cloud_.points.size());
    std::iota(order.begin(), order.end(), 0U);
    RandomStream random(1);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    reorder(cloud_.points, order);
    reorder(cloud_.rigid, order);
    reorder(cloud_.deformed, order);
    reorder(cloud_.normals, order);
  }

  template <typename Value>
  static void reorder(std::vector<Value>& values, const std::vector<std::uint32_t>& order) {
    std::vector<Value> sorted;
    sorted.reserve(values.size());
    for (const std::uint32_t i : order) sorted.push_back(values[i]);
    values = std::move(sorted);
  }

  const Project& project_;
  const CloudRequest& request_;
  std::map<TemplateId, std::size_t> places_;
  std::vector<std::shared_ptr<const PartTemplate>> templates_;
  std::vector<Work> ring_;
  CoalignedCloud cloud_;
};

}  // namespace

std::optional<CoalignedCloud> read_coaligned_cloud(const Project& project, const CloudRequest& request,
                                                   const JobControl& control) {
  return CloudReader(project, request).run(control);
}

}  // namespace archetype
