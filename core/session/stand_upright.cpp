// Reads samples twice rather than hold them: once to look at, once to turn.
#include "core/session/stand_upright.h"

#include "core/base/parallel.h"
#include "core/geometry/features.h"
#include "core/geometry/straighten.h"
#include "core/geometry/upright.h"

namespace archetype {

namespace {

// The same samples with another axis of the file pointing up, and straight about it; features are made anew.
ShapeSamples turned(ShapeSamples samples, UpAxis up) {
  const Mat3 rotation = upright_rotation(up);
  const Mat3 turn = rotation * samples.frame.rotation.transpose();
  samples.frame.rotation = rotation;
  samples.frame.centroid = turn * samples.frame.centroid;
  for (Vec3& p : samples.points) p = turn * p;
  for (Vec3& n : samples.normals) n = turn * n;
  straighten(samples);
  PointFeatures features = compute_features(samples.points, feature_radius * samples.radius);
  samples.features_x = std::move(features.x);
  samples.features_z = std::move(features.z);
  return samples;
}

}  // namespace

std::size_t stand_upright(Project& project, unsigned threads, const JobControl& control) {
  std::vector<ShapeRecord> records;
  for (ShapeRecord& record : project.shapes()) {
    if (record.up_decided) records.push_back(std::move(record));
  }
  constexpr std::size_t batch = 256;  // shapes whose samples are held at once
  std::vector<UprightLook> looks(records.size());
  std::vector<ShapeSamples> samples;
  for (std::size_t begin = 0; begin < records.size(); begin += batch) {
    const std::size_t count = std::min(batch, records.size() - begin);
    samples.clear();
    for (std::size_t i = 0; i < count; ++i) {
      if (control.cancelled()) return 0;
      samples.push_back(project.samples(records[begin + i].id));
    }
    const bool done = parallel_for(count, threads, control, "looking which way is up",
                                   [&](std::size_t i) { looks[begin + i] = look_upright(samples[i]); });
    if (!done) return 0;
  }
  const std::vector<UpAxis> ups = decide_upright(looks, control);
  if (ups.size() != records.size()) return 0;
  const std::stop_token stop = control.stop;  // no pause from here on: others could not write
  Project::Transaction transaction(project);
  std::size_t count = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (stop.stop_requested()) return 0;
    if (records[i].up == ups[i]) continue;
    const ShapeSamples upright = turned(project.samples(records[i].id), ups[i]);
    records[i].up = ups[i];
    records[i].frame = upright.frame;
    project.add_shape(records[i], upright);
    ++count;
  }
  transaction.commit();
  return count;
}

}  // namespace archetype
