// HdrCode and HdrValue of vectors, per target.
#if defined(WARPLUT_RUNTIME_HDR_CODE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_HDR_CODE_INL_H_
#undef WARPLUT_RUNTIME_HDR_CODE_INL_H_
#else
#define WARPLUT_RUNTIME_HDR_CODE_INL_H_
#endif

#include "runtime/color_encoding.h"
#include "runtime/core/warp_simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

HWY_INLINE Floats LimitHdrs(Floats x) {
  const FloatTag d;
  const auto limited = hn::Min(x, hn::Set(d, kLargestHdr));
  return hn::IfThenElseZero(hn::Gt(x, hn::Zero(d)), limited);
}

HWY_INLINE Floats HdrCodes(Floats x) {
  const FloatTag d;
  const IntTag di;
  const auto one = hn::Set(d, 1.0f);
  const auto one_bits = hn::Set(di, kOneBits);
  const auto v = hn::Add(hn::Mul(hn::Set(d, kHdrGain), x), one);
  const auto bits = hn::Sub(hn::BitCast(di, v), one_bits);
  const auto octave = hn::ConvertTo(d, hn::ShiftRight<kMantissaBits>(bits));
  const auto mantissa = hn::And(bits, hn::Set(di, (1 << kMantissaBits) - 1));
  const auto f = hn::Sub(hn::BitCast(d, hn::Or(mantissa, one_bits)), one);
  const auto within = hn::Mul(hn::Mul(f, hn::Sub(hn::Set(d, 4.0f), f)), hn::Set(d, 1.0f / 3));
  return hn::Mul(hn::Add(octave, within), hn::Set(d, 1.0f / kHdrOctaves));
}

HWY_INLINE Floats HdrValues(Floats code) {
  const FloatTag d;
  const IntTag di;
  const auto one = hn::Set(d, 1.0f);
  const auto logarithm = hn::Mul(code, hn::Set(d, static_cast<float>(kHdrOctaves)));
  const auto octave = hn::ConvertTo(di, logarithm);
  const auto within = hn::Sub(logarithm, hn::ConvertTo(d, octave));
  const auto root = hn::Sqrt(hn::Sub(hn::Set(d, 4.0f), hn::Mul(hn::Set(d, 3.0f), within)));
  const auto mantissa = hn::Add(one, hn::Sub(hn::Set(d, 2.0f), root));
  const auto bits = hn::Add(hn::BitCast(di, mantissa), hn::ShiftLeft<kMantissaBits>(octave));
  const auto value = hn::Mul(hn::Sub(hn::BitCast(d, bits), one), hn::Set(d, 1 / kHdrGain));
  return hn::Min(value, hn::Set(d, kLargestHdr));
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
