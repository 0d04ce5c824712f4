// Baking: fit -> the files that a renderer compiles, uploads or reads.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "luts/certificate/certificate.h"
#include "luts/fit/fit.h"

namespace warplut {

struct BakeOptions {
  TableFormat format = TableFormat::kI16;  // of header and JSON; the EXR is always float
  double blend = kDefaultBlend;            // of the certificate, in [0, 1]

  bool IsValid(std::string* why) const;
};

// One file: NAME, then `ending` (".h").
struct BakedFile {
  std::string ending;
  std::string bytes;
};

// The bytes of the files, with NAME that of the fit.
struct BakedFiles {
  std::string name;
  std::string
      header;        // C++20 with luts/contract.h; C++17 and C11 the table and what is known of it
  std::string json;  // "warplut-table"; docs/FORMATS.md
  std::string exr;   // the released layout (released_layout.h); empty unless HasReleasedLayout
  // What GPUs take, of halves (table_texture.h): NAME.ktx2, NAME.dds, NAME.bin, NAME.test.json, and
  // where HasShaderSource NAME.glsl and NAME.hlsl.
  std::vector<BakedFile> gpu;

  // All files but those that are empty.
  std::vector<BakedFile> All() const;
};

// A pure function: the same fit and options give the same bytes. An Error names the field of the
// fit or option that is not valid, or the node and weight that the format cannot hold.
BakedFiles Bake(const Fit& fit, const BakeOptions& options = {});

// Writes the files into an existing folder, each atomically; no EXR where it is empty.
void WriteBaked(const std::filesystem::path& folder, const BakedFiles& files);

}  // namespace warplut
