// The vector kernels of linear HDR rows.
#if defined(WARPLUT_RUNTIME_GENERATION_HDR_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_GENERATION_HDR_ROWS_INL_H_
#undef WARPLUT_RUNTIME_GENERATION_HDR_ROWS_INL_H_
#else
#define WARPLUT_RUNTIME_GENERATION_HDR_ROWS_INL_H_
#endif

#include "runtime/core/hdr_code-inl.h"
#include "runtime/core/pixels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut::generation {
namespace HWY_NAMESPACE {

using namespace warplut::HWY_NAMESPACE;

// EncodeHdrRowReference.
inline void EncodeHdrRow(const ImageView& linear, int y, const MutableImageView& to) {
  for (int x = 0; x < linear.width; x += kLanes) {
    Pixels p = LoadPixels(linear, x, y, linear.width - x);
    for (Floats* channel : {&p.r, &p.g, &p.b}) *channel = HdrCodes(LimitHdrs(*channel));
    p.a = hn::Set(FloatTag(), 1.0f);
    StorePixels(p, to, x, y, linear.width - x);
  }
}

// DecodeHdrRowReference.
inline void DecodeHdrRow(const ImageView& codes, int y, const MutableImageView& to) {
  for (int x = 0; x < codes.width; x += kLanes) {
    Pixels p = LoadPixels(codes, x, y, codes.width - x);
    for (Floats* channel : {&p.r, &p.g, &p.b}) *channel = HdrValues(Limit(*channel));
    p.a = hn::Set(FloatTag(), 1.0f);
    StorePixels(p, to, x, y, codes.width - x);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::generation
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
