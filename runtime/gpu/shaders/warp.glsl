// The history at p - m: runtime/warp.h. Before it come the samplers `history`, `coefficients` and
// `table`: an array of LAYERS layers of 33 x 33 texels, as NAME.ktx2 has it (docs/FORMATS.md).

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

vec4 FetchSummed(ivec2 p) {
  p = clamp(p, ivec2(0), frame.output_size - 1);
  return PREFILTERED ? texelFetch(coefficients, p, 0) : texelFetch(history, p, 0);
}

vec4 SumOfTable(ivec2 texel, vec2 d) {
  vec4 sum = vec4(0.0);
  for (int layer = 0; layer < LAYERS; ++layer) {
    vec4 w = LayerWeights(layer, d);
    for (int channel = 0; channel < 4; ++channel) {
      sum += w[channel] * FetchSummed(texel + TapOf(layer, channel));
    }
  }
  return sum;
}

vec4 SumOfAxes(ivec2 texel, vec2 d) {
  vec4 wx = AxisTaps(d.x);
  vec4 wy = AxisTaps(d.y);
  vec4 sum = vec4(0.0);
  for (int ky = 0; ky < 4; ++ky) {
    if (FILTER == kFilterBilinear && (ky == 0 || ky == 3)) continue;
    vec4 row = vec4(0.0);
    for (int kx = 0; kx < 4; ++kx) {
      if (FILTER == kFilterBilinear && (kx == 0 || kx == 3)) continue;
      row += wx[kx] * FetchSummed(texel + ivec2(kx - 1, ky - 1));
    }
    sum += wy[ky] * row;
  }
  return sum;
}

// The history at the centre of pixel p less `motion`, in output pixels.
vec4 WarpedHistory(ivec2 p, vec2 motion) {
  MotionSplit x = SplitMotion(motion.x);
  MotionSplit y = SplitMotion(motion.y);
  ivec2 size = frame.output_size;
  ivec2 texel = clamp(p + ivec2(x.whole, y.whole), ivec2(kFirstSampledTexel),
                      size - 1 - kFirstWindowTap);
  vec2 d = vec2(x.offset, y.offset);
  if (PREFILTERED) {
    MoveInside(size.x, texel.x, d.x);
    MoveInside(size.y, texel.y, d.y);
  }
  if (d.x == 0.0 && d.y == 0.0) {
    return texelFetch(history, clamp(texel, ivec2(0), size - 1), 0);
  }
  return FILTER == kFilterLut ? SumOfTable(texel, d) : SumOfAxes(texel, d);
}
