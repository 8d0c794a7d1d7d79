// The weights and limits of section 4.1.
#pragma once

#include <array>

#include "core/fitting/alpha_expansion.h"

namespace archetype {

// Energies are means over points: E = E_s->t + E_t->s + gamma E_feat + alpha E_deform + beta E_smooth +
// E_exist.
struct FitOptions {
  // Distances count in this unit, a share of R, so that 1 is a bad distance as 1 is a bad feature.
  // Differs from the paper: it divides by R itself; terms of its sizes would be lost beside the others.
  double distance_unit = 0.1;
  double alpha = 0.005;          // weight of the deformation, summed over parts and axes
  double deformation_tail = 16;  // in variances: deviations beyond it count less and less
  double turn_stddev = 0.2;      // of the rotation of a box against its template's, in radians; 0: none
  double round_share = 0.8;      // see choose_solids(); 0: all parts are boxes
  double beta = 0.15;            // weight of smoothness
  double gamma = 0.5;            // weight of features
  double null_cost = 5.0;        // distance and feature cost of a point without a part
  double feature_clip = 9.0;     // squared deviation (in variances, mean over the features) that counts as 1
  double existence_weight = 0.05;  // weight of -log(existence) per part
  int graph_neighbours = 8;        // of each sample in the labelling graph
  double face_smoothness = 0.02;   // weight of boundary lengths when faces are labelled, in roots of the area
  double crease_reach = 0.08;      // over which the bend of the surface is measured, in roots of the area
  double face_core = 0.7;     // samples deeper in their part than this share of its depth keep their faces
  int face_neighbours = 60;   // other faces may take the labels of that many samples around them
  int template_points = 600;  // samples of the template's boxes for E_t->s

  // Of the candidate quarter turns about up, beside the energies that they reach (see AgreedYaws). One with
  // an infinite cost is not tried.
  std::array<double, 4> yaw_costs{};
  int max_alternations = 100;  // the paper's
  bool drop_parts = true;      // leave out parts that the shape gives no evidence for (part_evidence())
  double odds_weight = 0.1;    // what the odds of a part's existence count as evidence
  ExpansionOptions expansion;
};

}  // namespace archetype
