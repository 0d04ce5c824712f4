// The files that `bake` writes for GPUs: read back, and compared with the fit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>

#include "luts/bake/assets.h"
#include "luts/bake/bake.h"
#include "luts/bake/shader_source.h"
#include "luts/bake/table_texture.h"
#include "luts/quantize/quantize.h"
#include "luts/table_file.h"
#include "tests/luts/test_fits.h"

namespace warplut {
namespace {

using testing::HasSubstr;

constexpr int kTexels = TableTexture::kSide * TableTexture::kSide;

std::string FileOf(const BakedFiles& files, const std::string& ending) {
  for (const BakedFile& file : files.gpu) {
    if (file.ending == ending) return file.bytes;
  }
  return "";
}

template <class T>
T At(const std::string& bytes, std::size_t offset) {
  T value{};
  EXPECT_LE(offset + sizeof(T), bytes.size());
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}
std::uint32_t U32(const std::string& bytes, std::size_t offset) {
  return At<std::uint32_t>(bytes, offset);
}

std::string HalfBytes(const TableTexture& texture) {
  return {reinterpret_cast<const char*>(texture.halves.data()),
          texture.halves.size() * sizeof(std::uint16_t)};
}

TableTexture TextureOfFit(const Fit& fit) {
  return TextureOf(Table(QuantizeToHalves(SampleFit(fit, kNodes)).view()));
}

Fit AssetFit(std::string_view name) {
  return ReadFit(std::filesystem::path(WARPLUT_LUTS_DIR) / "fits" / (std::string(name) + ".json"));
}

class HalvesTest : public testing::TestWithParam<std::string_view> {};
INSTANTIATE_TEST_SUITE_P(Assets, HalvesTest, testing::ValuesIn(kAssets),
                         [](const auto& test) { return std::string(test.param); });

// The bound of quantize.h: the rows of halves sum to 1 without an error.
TEST_P(HalvesTest, RowsSumToExactlyOneNearTheFit) {
  const Fit fit = AssetFit(GetParam());
  const RealTable real = SampleFit(fit, kNodes);
  const TableTexture texture = TextureOf(Table(QuantizeToHalves(real).view()));
  const TapLayout& layout = LayoutOf(fit.footprint);
  double worst = 0;
  for (int node = 0; node < kTexels; ++node) {
    const Weights<double>& exact = real.Row(node % TableTexture::kSide, node / TableTexture::kSide);
    double sum = 0, error = 0;
    for (int place = 0; place < 4 * texture.layers; ++place) {
      const auto at = static_cast<std::size_t>((place / 4 * kTexels + node) * 4 + place % 4);
      const auto weight = static_cast<double>(HalfToFloat(texture.halves[at]));
      sum += weight;
      error += std::abs(weight - exact[layout.Weight(place)]);
      EXPECT_NEAR(weight, exact[layout.Weight(place)], (kMostHalfStep + 0.5) * 0x1p-14);
    }
    EXPECT_EQ(sum, 1) << "node " << node;
    worst = std::max(worst, error);
  }
  RecordProperty("worst_weight_error", std::to_string(worst));
  EXPECT_LT(worst, 0.001);  // f16 of the contract, whose unit is 2^-11 throughout, has 0.0027
}

TEST(GpuFiles, KeepTheZerosOfTheContract) {
  const BakedTable table = QuantizeToHalves(SampleFit(MakeFit(0.2), kNodes));
  EXPECT_NO_THROW(CheckTable(table.view(), "halves"));
}

TEST(GpuFiles, SameFitGivesSameBytes) {
  const BakedFiles first = Bake(MakeFit(0.2)), second = Bake(MakeFit(0.2));
  ASSERT_EQ(first.gpu.size(), 6u);
  for (std::size_t i = 0; i < first.gpu.size(); ++i) {
    EXPECT_FALSE(first.gpu[i].bytes.empty());
    EXPECT_EQ(first.gpu[i].bytes, second.gpu[i].bytes) << first.gpu[i].ending;
  }
}

TEST(GpuFiles, Ktx2HoldsTheTexture) {
  const Fit fit = WithPrefilter(MakeFit(0));
  const std::string file = FileOf(Bake(fit), ".ktx2");
  const std::string texels = HalfBytes(TextureOfFit(fit));
  EXPECT_EQ(file.substr(0, 12), std::string("\xABKTX 20\xBB\r\n\x1A\n", 12));
  const std::uint32_t header[] = {97, 2, 33, 33, 0, 4, 1, 1, 0, 104, 92};
  for (std::size_t i = 0; i < std::size(header); ++i)
    EXPECT_EQ(U32(file, 12 + 4 * i), header[i]) << "field " << i;
  const std::size_t values_at = U32(file, 56), values_bytes = U32(file, 60);
  EXPECT_EQ(values_at, 196u);
  EXPECT_EQ(U32(file, 104), 92u);
  const auto level_at = static_cast<std::size_t>(At<std::uint64_t>(file, 80));
  EXPECT_EQ(level_at % 8, 0u);
  EXPECT_EQ(At<std::uint64_t>(file, 88), texels.size());
  EXPECT_EQ(At<std::uint64_t>(file, 96), texels.size());
  EXPECT_EQ(file.size(), level_at + texels.size());
  EXPECT_TRUE(file.substr(level_at) == texels);

  std::vector<std::string> keys;
  for (std::size_t at = values_at; at < values_at + values_bytes;) {
    const std::size_t bytes = U32(file, at);
    const std::string pair = file.substr(at + 4, bytes);
    keys.push_back(pair.substr(0, pair.find('\0')));
    if (keys.back() == "warplutProvenance") {
      const std::string value = pair.substr(pair.find('\0') + 1);
      EXPECT_EQ(nlohmann::json::parse(value.substr(0, value.size() - 1))["fit"], "test_fit");
    }
    at += 4 + (bytes + 3) / 4 * 4;
  }
  EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
  EXPECT_THAT(keys, testing::ElementsAre("KTXorientation", "KTXwriter", "warplutCertificate",
                                         "warplutPrefilter", "warplutProvenance", "warplutTaps"));
}

TEST(GpuFiles, DdsHoldsTheTexture) {
  const Fit fit = MakeFit(0.2);
  const std::string file = FileOf(Bake(fit), ".dds");
  EXPECT_EQ(file.substr(0, 4), "DDS ");
  EXPECT_EQ(U32(file, 4), 124u);
  EXPECT_EQ(U32(file, 12), 33u);
  EXPECT_EQ(U32(file, 16), 33u);
  EXPECT_EQ(U32(file, 76), 32u);  // size of the pixel format
  EXPECT_EQ(file.substr(84, 4), "DX10");
  EXPECT_EQ(U32(file, 128), 10u);
  EXPECT_EQ(U32(file, 132), 3u);
  EXPECT_EQ(U32(file, 140), 4u);
  EXPECT_TRUE(file.substr(148) == HalfBytes(TextureOfFit(fit)));
}

TEST(GpuFiles, BinIsTheStruct) {
  const Fit fit = WithPrefilter(MakeFit(0));
  const std::string file = FileOf(Bake(fit), ".bin");
  const auto header = At<WarplutTableFile>(file, 0);
  EXPECT_STREQ(header.magic, "warplut");
  EXPECT_EQ(header.version, 1u);
  EXPECT_EQ(header.nodes, 33u);
  EXPECT_EQ(header.layers, 4u);
  EXPECT_EQ(header.prefilter, 1u);
  EXPECT_EQ(header.side, fit.prefilter.side);
  EXPECT_EQ(header.pole, static_cast<float>(PoleOfSide(header.side)));
  EXPECT_TRUE(file.substr(offsetof(WarplutTableFile, halves)) == HalfBytes(TextureOfFit(fit)));
}

TEST(GpuFiles, TestVectorsAreThoseOfTheHalves) {
  const Fit fit = MakeFit(0.2);
  const BakedTable halves = QuantizeToHalves(SampleFit(fit, kNodes));
  const Table table(halves.view());
  const auto json = nlohmann::json::parse(FileOf(Bake(fit), ".test.json"));
  EXPECT_GE(json["vectors"].size(), 20u);
  for (const auto& vector : json["vectors"]) {
    EXPECT_EQ(vector["patch"].size(), 36u);
    for (const Lookup lookup : {Lookup::kNearest, Lookup::kBilinear}) {
      const auto weights = table.At(vector["offset"][0], vector["offset"][1], lookup);
      const auto& stored = vector[Name(lookup)];
      double value = 0;
      for (int k = 0; k < 16; ++k) {
        const int place = TapsOf(Footprint::k16)[k];
        EXPECT_EQ(stored["weights"][k].get<float>(), weights[place]);
        value += stored["weights"][k].get<double>() * vector["patch"][place].get<double>();
      }
      EXPECT_NEAR(stored["value"].get<double>(), value, 1e-12);
    }
  }
}

TEST(GpuFiles, TablesOfMoreTapsHaveNoSource) {
  const Fit fit = AssetFit("warplut_t24_x2");
  const BakedFiles files = Bake(fit);
  EXPECT_EQ(FileOf(files, ".glsl"), "");
  EXPECT_EQ(U32(FileOf(files, ".ktx2"), 12 + 4 * 5), 6u);  // layers
}

// Sources compile as a shader that calls each function.
class ShaderSourceTest : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    if (std::string(WARPLUT_GLSLANG).empty())
      GTEST_SKIP() << "glslangValidator (Debian: glslang-tools) is not installed";
    fit_ = GetParam() ? WithPrefilter(MakeFit(0)) : MakeFit(0.2);
    folder_ = TestFolder();
  }

  void Compile(const std::string& name, const std::string& text, const std::string& options) {
    WriteFile(folder_ / name, text);
    const std::string log = (folder_ / (name + ".log")).string();
    const std::string command = std::string(WARPLUT_GLSLANG) + " " + options + " " +
                                (folder_ / name).string() + " > " + log;
    EXPECT_EQ(std::system(command.c_str()), 0) << ReadFile(log);
  }

  std::string Uses(const std::string& vec4) const {
    return "  " + vec4 +
           " sum = test_fit_sample(image, size, p) + test_fit_weights(p)[1]"
           " + test_fit_nearest_weights(p)[2];\n" +
           (GetParam() ? "  sum += test_fit_prefilter(image, size, texel, axis);\n" : "");
  }

  Fit fit_;
  std::filesystem::path folder_;
};
INSTANTIATE_TEST_SUITE_P(Prefilter, ShaderSourceTest, testing::Bool());

TEST_P(ShaderSourceTest, GlslCompiles) {
  const std::string source = FileOf(Bake(fit_), ".glsl");
  const std::string body =
      "layout(local_size_x = 8, local_size_y = 8) in;\n"
      "layout(binding = 0) uniform highp sampler2D image;\n"
      "layout(binding = 1, rgba32f) writeonly uniform highp image2D result;\n" +
      source +
      "void main() {\n  ivec2 size = ivec2(8), texel = ivec2(1), axis = ivec2(1, 0);\n"
      "  vec2 p = vec2(0.25);\n" +
      Uses("vec4") + "  imageStore(result, texel, sum);\n}\n";
  const std::string es = "#version 310 es\nprecision highp float;\nprecision highp int;\n";
  Compile("gl.comp", "#version 430\n" + body, "");
  Compile("es.comp", es + body, "");
  Compile("vulkan.comp", "#version 450\n" + body, "-V -o /dev/null");
}

TEST_P(ShaderSourceTest, HlslCompiles) {
  const std::string source = FileOf(Bake(fit_), ".hlsl");
  const std::string body =
      source +
      "Texture2D<float4> image : register(t0);\nRWTexture2D<float4> result : register(u0);\n"
      "[numthreads(8, 8, 1)] void main(uint3 id : SV_DispatchThreadID) {\n"
      "  int2 size = int2(8, 8), texel = int2(id.xy), axis = int2(1, 0);\n"
      "  float2 p = float2(0.25, 0.5);\n" +
      Uses("float4") + "  result[texel] = sum;\n}\n";
  Compile("hlsl.comp", body, "-D -e main -V -o /dev/null");
}

}  // namespace
}  // namespace warplut
