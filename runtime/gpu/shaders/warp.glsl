// An image at p - m: runtime/warp.h. Before it come formulas.glsl and
//   frame         with output_size and filter_parameter
//   table         a sampler: an array of LAYERS layers of 33 x 33 texels, as NAME.ktx2 has it
//                 (docs/FORMATS.md)
//   WarpedTexel   vec4(sampler2D image, ivec2 p), the texel p of an image or of its coefficients

// One axis of -m: whole texels and an offset in [0, 1).
struct MotionSplit {
  int whole;
  float offset;
};

MotionSplit SplitMotion(float m) {
  if (!IsFinite(m)) m = 0.0;
  float whole = floor(-m);
  float offset = -m - whole;
  if (offset >= 1.0) {
    offset = 0.0;
    whole += 1.0;
  }
  return MotionSplit(int(clamp(whole, -kFarthestTexel, kFarthestTexel)), offset);
}

// Moves a position beyond the centres of the outermost texels to them.
void MoveInside(int size, inout int texel, inout float offset) {
  if (texel < 0 || texel >= size - 1) offset = 0.0;
  texel = clamp(texel, 0, size - 1);
}

// Tap `channel` of a layer (luts/tap_layout.h).
ivec2 TapOf(int layer, int channel) {
  if (LAYERS == 4) return ivec2(channel - 1, layer - 1);
  return LAYERS == 6 ? kTaps24[4 * layer + channel] : kTaps36[4 * layer + channel];
}

vec4 LayerWeights(int layer, vec2 d) {
  if (LOOKUP == kLookupNearest) {
    return texelFetch(table, ivec3(ivec2(d * float(kNodes) + 0.5), layer), 0);
  }
  vec2 scaled = d * float(kNodes);
  ivec2 node = ivec2(scaled);
  vec2 f = scaled - vec2(node);
  vec4 upper = (1.0 - f.x) * texelFetch(table, ivec3(node, layer), 0) +
               f.x * texelFetch(table, ivec3(node + ivec2(1, 0), layer), 0);
  vec4 lower = (1.0 - f.x) * texelFetch(table, ivec3(node + ivec2(0, 1), layer), 0) +
               f.x * texelFetch(table, ivec3(node + ivec2(1, 1), layer), 0);
  return (1.0 - f.y) * upper + f.y * lower;
}

vec4 SplineTaps(float k, float d) {
  float e = 1.0 - d;
  float outer0 = (1.0 / 6.0) * e * e * e + k * e;
  float outer3 = (1.0 / 6.0) * d * d * d + k * d;
  float inner1 = 2.0 / 3.0 - d * d * (1.0 - 0.5 * d) + k * (3.0 * d - 2.0);
  return vec4(outer0, inner1, 1.0 - inner1 - outer0 - outer3, outer3);
}

vec4 AxisTaps(float d) {
  if (FILTER == kFilterBilinear) return vec4(0.0, 1.0 - d, d, 0.0);
  if (FILTER == kFilterSpline) return SplineTaps(frame.filter_parameter, d);
  return KeysTaps(frame.filter_parameter, d);
}

vec4 FetchSummed(sampler2D image, ivec2 p) {
  return WarpedTexel(image, clamp(p, ivec2(0), frame.output_size - 1));
}

vec4 SumOfTable(sampler2D image, ivec2 texel, vec2 d) {
  vec4 sum = vec4(0.0);
  for (int layer = 0; layer < LAYERS; ++layer) {
    vec4 w = LayerWeights(layer, d);
    for (int channel = 0; channel < 4; ++channel) {
      sum += w[channel] * FetchSummed(image, texel + TapOf(layer, channel));
    }
  }
  return sum;
}

vec4 SumOfAxes(sampler2D image, ivec2 texel, vec2 d) {
  vec4 wx = AxisTaps(d.x);
  vec4 wy = AxisTaps(d.y);
  vec4 sum = vec4(0.0);
  for (int ky = 0; ky < 4; ++ky) {
    if (FILTER == kFilterBilinear && (ky == 0 || ky == 3)) continue;
    vec4 row = vec4(0.0);
    for (int kx = 0; kx < 4; ++kx) {
      if (FILTER == kFilterBilinear && (kx == 0 || kx == 3)) continue;
      row += wx[kx] * FetchSummed(image, texel + ivec2(kx - 1, ky - 1));
    }
    sum += wy[ky] * row;
  }
  return sum;
}

// Where pixel p less a motion is sampled: at `texel`, plus `offset` in [0, 1).
struct SampledPlace {
  ivec2 texel;
  vec2 offset;
};

SampledPlace SampledPlaceOf(ivec2 p, vec2 motion) {
  MotionSplit x = SplitMotion(motion.x);
  MotionSplit y = SplitMotion(motion.y);
  ivec2 texel = clamp(p + ivec2(x.whole, y.whole), ivec2(kFirstSampledTexel),
                      frame.output_size - 1 - kFirstWindowTap);
  return SampledPlace(texel, vec2(x.offset, y.offset));
}

vec4 SumOfFilter(sampler2D image, ivec2 texel, vec2 d) {
  return FILTER == kFilterLut ? SumOfTable(image, texel, d) : SumOfAxes(image, texel, d);
}

// `image` at the centre of pixel p less `motion`, in output pixels. `coefficients` are those of the
// image where the filter has a prefilter; the image itself where nothing is between texels.
vec4 WarpedImage(sampler2D image, sampler2D coefficients, ivec2 p, vec2 motion) {
  SampledPlace place = SampledPlaceOf(p, motion);
  ivec2 size = frame.output_size;
  if (PREFILTERED) {
    MoveInside(size.x, place.texel.x, place.offset.x);
    MoveInside(size.y, place.texel.y, place.offset.y);
  }
  if (place.offset.x == 0.0 && place.offset.y == 0.0) return FetchSummed(image, place.texel);
  if (PREFILTERED) return SumOfFilter(coefficients, place.texel, place.offset);
  return SumOfFilter(image, place.texel, place.offset);
}
