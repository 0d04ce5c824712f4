// Output grid: step 4 of runtime/super_resolution.h: the new samples enter; history and output are
// written.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "super_resolution.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, HISTORY_FORMAT) writeonly uniform image2D history;
layout(binding = 1, HISTORY_FORMAT) writeonly uniform image2D shown;
layout(binding = 2) uniform sampler2D color;
layout(binding = 3) uniform sampler2D predicted;
layout(binding = 4) uniform sampler2D residual;
layout(binding = 5) uniform sampler2D smoothing;

// `share` of `distance_`, lengthened where rounding would undo it.
vec3 HistoryStep(float share, vec3 distance_) {
  vec3 to = share * distance_;
  for (int c = 0; c < 3; ++c) {
    bool lengthened = share > 0.0 && abs(distance_[c]) > frame.settled_distance &&
                      abs(to[c]) < frame.least_step;
    if (lengthened) to[c] = distance_[c] < 0.0 ? -frame.least_step : frame.least_step;
  }
  return to;
}

// The sample form.
vec3 FromSamples(AxisPlace x, AxisPlace y, vec3 before, float validity) {
  float count = 0.0, weight_sum = 0.0;
  vec3 color_sum = vec3(0.0);
  for (int dj = -1; dj <= 1; ++dj) {
    for (int di = -1; di <= 1; ++di) {
      ivec2 p = ivec2(x.nearest + di, y.nearest + dj);
      bool in_frame = all(greaterThanEqual(p, ivec2(0))) && all(lessThan(p, frame.render_size));
      float distance_ = length(vec2(x.offset, y.offset) - vec2(di, dj));
      if (!in_frame || !(distance_ <= 1.0)) continue;
      float weight = SampleWeight(distance_);
      count += 1.0;
      weight_sum += weight;
      color_sum += weight * LoadColor(color, p);
    }
  }
  if (!(weight_sum > 0.0)) return before;
  float share = validity * BlendShare(weight_sum / count);
  return before + HistoryStep(share, color_sum / weight_sum - before);
}

float TileSmoothing(ivec2 tile) {
  ivec2 last = (frame.render_size + kAliasingTile - 1) / kAliasingTile - 1;
  return texelFetch(smoothing, clamp(tile, ivec2(0), last), 0).r;
}

// Smoothing of a sample, bilinear between the centres of tiles.
float SmoothingAt(ivec2 sample_) {
  ivec2 tile = (sample_ + kAliasingTile / 2) / kAliasingTile - 1;
  vec2 t = (vec2(sample_ - tile * kAliasingTile - kAliasingTile / 2) + 0.5) / float(kAliasingTile);
  float left = mix(TileSmoothing(tile), TileSmoothing(tile + ivec2(0, 1)), t.y);
  float right = mix(TileSmoothing(tile + ivec2(1, 0)), TileSmoothing(tile + ivec2(1, 1)), t.y);
  return left + t.x * (right - left);
}

vec3 Residual(ivec2 p) { return texelFetch(residual, min(p, frame.render_size - 1), 0).rgb; }

// The residual and the adaptive form.
vec3 FromResidual(AxisPlace x, AxisPlace y, vec3 before, float validity) {
  ivec2 cell = ivec2(x.cell, y.cell);
  float smooth_ = FORM == kHistoryFormAdaptive ? SmoothingAt(cell) : 0.0;
  float share = validity * (1.0 - smooth_) *
                BlendShare(SampleWeight(length(vec2(x.offset, y.offset))));
  vec3 left = mix(Residual(cell), Residual(cell + ivec2(0, 1)), y.fraction);
  vec3 right = mix(Residual(cell + ivec2(1, 0)), Residual(cell + ivec2(1, 1)), y.fraction);
  vec3 q = before + HistoryStep(share, left + x.fraction * (right - left));
  if (smooth_ > 0.0) {
    left = mix(LoadColor(color, cell), LoadColor(color, cell + ivec2(0, 1)), y.fraction);
    right = mix(LoadColor(color, cell + ivec2(1, 0)), LoadColor(color, cell + ivec2(1, 1)),
                y.fraction);
    vec3 current = left + x.fraction * (right - left);
    q += validity * smooth_ * kSmoothShare * (current - before);
  }
  return q;
}

// The brightest of the 4 x 4 samples around, at least kUnlimitedCode.
vec3 BrightestSamples(ivec2 cell) {
  vec3 brightest = vec3(kUnlimitedCode);
  for (int dj = -1; dj <= 2; ++dj) {
    for (int di = -1; di <= 2; ++di) {
      brightest = max(brightest, LoadColor(color, cell + ivec2(di, dj)));
    }
  }
  return brightest;
}

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, frame.output_size))) return;
  AxisPlace x = PlaceOf(p.x, frame.render_size.x, frame.output_size.x, frame.jitter.x);
  AxisPlace y = PlaceOf(p.y, frame.render_size.y, frame.output_size.y, frame.jitter.y);
  vec4 before = texelFetch(predicted, p, 0);
  vec3 q = before.rgb;
  if (HISTORY) {
    q = FORM == kHistoryFormSample ? FromSamples(x, y, q, before.a)
                                   : FromResidual(x, y, q, before.a);
    if (ENCODING == kColorEncodingLinearHdr) q = min(q, BrightestSamples(ivec2(x.cell, y.cell)));
  }
  q = clamp(q, 0.0, 1.0);
  imageStore(history, p, vec4(q, 1.0));
  // Display values are shown as the history holds them.
  if (ENCODING == kColorEncodingLinearHdr) imageStore(shown, p, vec4(DecodeColor(q), 1.0));
}
