#include "luts/bake/table_texture.h"

#include <array>

#include "luts/bake/little_endian.h"

namespace warplut {
namespace {

constexpr int kChannels = 4;
constexpr std::uint32_t kTexelBytes = kChannels * sizeof(std::uint16_t);

std::string TexelBytes(const TableTexture& texture) {
  std::string bytes;
  bytes.reserve(texture.halves.size() * sizeof(std::uint16_t));
  for (const std::uint16_t half : texture.halves) bytes += Bytes(half);
  return bytes;
}

// The basic data format descriptor of RGBA16F.
std::string DataFormatDescriptor() {
  constexpr std::uint32_t kSamples = kChannels, kBlock = 24 + 16 * kSamples;
  constexpr std::uint32_t kRgbsda = 1, kUnspecifiedPrimaries = 0, kLinear = 1;
  constexpr std::uint32_t kFloatAndSigned = 0x80 | 0x40;
  constexpr std::array<std::uint32_t, kChannels> kRgba = {0, 1, 2, 15};
  std::string block = Bytes32(0);                     // Khronos, basic format
  block += Bytes(std::uint32_t{2 | (kBlock << 16)});  // version 1.3, size
  block += Bytes(std::uint32_t{kRgbsda | (kUnspecifiedPrimaries << 8) | (kLinear << 16)});
  block += Bytes32(0);                         // blocks of 1 x 1 x 1 x 1 texel
  block += Bytes32(kTexelBytes) + Bytes32(0);  // bytes of the planes
  for (std::uint32_t c = 0; c < kSamples; ++c) {
    const std::uint32_t bit = 16 * c, last_bit = 15;
    block += Bytes(std::uint32_t{bit | (last_bit << 16) | ((kRgba[c] | kFloatAndSigned) << 24)});
    block += Bytes32(0) + BytesOf(-1.0f) + BytesOf(1.0f);
  }
  return Bytes32(block.size() + 4) + block;
}

std::string KeyValueData(const KeyValues& values) {
  std::string data;
  for (const auto& [key, value] : values) {
    const std::string pair = key + '\0' + value + '\0';
    data += Bytes32(pair.size()) + pair + PaddingTo(4, pair.size());
  }
  return data;
}

}  // namespace

TableTexture TextureOf(const Table& table) {
  TableTexture texture;
  texture.layers = LayoutOf(table.footprint()).count;
  constexpr int kTexels = TableTexture::kSide * TableTexture::kSide;
  for (int layer = 0; layer < texture.layers; ++layer) {
    for (int texel = 0; texel < kTexels; ++texel) {
      const float* row = table.data() + texel * RowFloats(table.footprint());
      for (int c = 0; c < kChannels; ++c) {
        texture.halves.push_back(FloatToHalf(row[layer * kGroupTaps + c]));
      }
    }
  }
  return texture;
}

std::string EncodeKtx2(const TableTexture& texture, const KeyValues& values) {
  constexpr std::uint32_t kRgba16Sfloat = 97;  // VK_FORMAT_R16G16B16A16_SFLOAT
  constexpr std::size_t kHeaderBytes = 104;    // with the index of one level
  const std::string descriptor = DataFormatDescriptor();
  const std::string key_values = KeyValueData(values);
  const std::string texels = TexelBytes(texture);
  const std::size_t key_values_at = kHeaderBytes + descriptor.size();
  const std::size_t end = key_values_at + key_values.size();
  const std::string padding = PaddingTo(kTexelBytes, end);

  std::string file("\xABKTX 20\xBB\r\n\x1A\n", 12);
  file += Bytes(kRgba16Sfloat) + Bytes32(sizeof(std::uint16_t));
  file += Bytes32(TableTexture::kSide) + Bytes32(TableTexture::kSide) + Bytes32(0);
  file += Bytes32(static_cast<std::size_t>(texture.layers));
  file += Bytes32(1) + Bytes32(1) + Bytes32(0);  // faces, levels, no supercompression
  file += Bytes32(kHeaderBytes) + Bytes32(descriptor.size());
  file += Bytes32(key_values_at) + Bytes32(key_values.size());
  file += Bytes64(0) + Bytes64(0);  // no supercompression data
  file += Bytes64(end + padding.size()) + Bytes64(texels.size()) + Bytes64(texels.size());
  return file + descriptor + key_values + padding + texels;
}

std::string EncodeDds(const TableTexture& texture) {
  constexpr std::uint32_t kCapsHeightWidthPitchFormat = 0x100F;
  constexpr std::uint32_t kFourCc = 4, kTexture = 0x1000;
  constexpr std::uint32_t kRgba16Float = 10, kTexture2d = 3;
  std::string file = "DDS " + Bytes32(124) + Bytes(kCapsHeightWidthPitchFormat);
  file += Bytes32(TableTexture::kSide) + Bytes32(TableTexture::kSide);
  file += Bytes32(TableTexture::kSide * kTexelBytes);
  file += std::string(4 * 13, '\0');  // depth, levels, reserved
  file += Bytes32(32) + Bytes(kFourCc) + "DX10" + std::string(4 * 5, '\0');
  file += Bytes(kTexture) + std::string(4 * 4, '\0');
  file += Bytes(kRgba16Float) + Bytes(kTexture2d) + Bytes32(0);
  file += Bytes32(static_cast<std::size_t>(texture.layers)) + Bytes32(0);
  return file + TexelBytes(texture);
}

std::string EncodeTableFile(const TableTexture& texture, const Prefilter& prefilter) {
  const bool recursive = prefilter.kind == PrefilterKind::kRecursive;
  std::string file("warplut", 8);
  file += Bytes32(1) + Bytes32(TableTexture::kSide);
  file += Bytes32(static_cast<std::size_t>(texture.layers));
  file += Bytes32(static_cast<std::size_t>(prefilter.kind));
  file += BytesOf(prefilter.side);
  file += BytesOf(recursive ? static_cast<float>(PoleOfSide(prefilter.side)) : 0.0f);
  file += Bytes32(static_cast<std::size_t>(prefilter.reach));
  for (const float tap : prefilter.taps) file += BytesOf(tap);
  return file + Bytes32(0) + TexelBytes(texture);
}

}  // namespace warplut
