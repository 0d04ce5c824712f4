// A table as a texture: what renderers upload.
//
// An array of 33 x 33 texels, RGBA16F: texel (ix, jy) belongs to the node at offset (ix, jy) / 32,
// node 32 included. The channels of a layer are four taps, in the order of LayoutOf(footprint)
// (luts/tap_layout.h): of 16 taps layer k holds the taps -1, 0, 1, 2 of row k - 1. A sampler that
// filters linearly and clamps, at ((d * 32 + 1/2) / 33), gives the bilinear lookup of four taps in
// one fetch. Layers are apart, so that nothing bleeds from one into another.
//
// The weights are those of QuantizeToHalves: exactly halves, and the rows of each node sum to
// exactly 1.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "luts/table.h"

namespace warplut {

struct TableTexture {
  static constexpr int kSide = kTableNodes;  // texels per axis
  int layers = 0;
  std::vector<std::uint16_t> halves;  // layer by layer, row by row, RGBA
};

// A table whose weights are halves.
TableTexture TextureOf(const Table& table);

using KeyValues = std::vector<std::pair<std::string, std::string>>;  // sorted by key

// A KTX 2.0 file: VK_FORMAT_R16G16B16A16_SFLOAT, an array texture of one level, without
// supercompression, with its basic data format descriptor. Source: KTX File Format Specification
// 2.0, Khronos Data Format Specification 1.3.
std::string EncodeKtx2(const TableTexture& texture, const KeyValues& values);

// A DDS file with the header of Direct3D 10: DXGI_FORMAT_R16G16B16A16_FLOAT, an array of 2D
// textures. Source: "DDS_HEADER" and "DDS_HEADER_DXT10", Direct3D documentation.
std::string EncodeDds(const TableTexture& texture);

// The struct of luts/table_file.h.
std::string EncodeTableFile(const TableTexture& texture, const Prefilter& prefilter);

}  // namespace warplut
