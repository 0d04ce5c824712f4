// NAME.glsl on a GPU: its weights, its sampling function and its prefilter against the test vectors
// that are baked beside it. Nodes come from the texture, or from the array of the source, which is
// moved into an image: lavapipe compiles the array for eight seconds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>

#include "datasets/file.h"
#include "luts/bake/bake.h"
#include "luts/bake/table_texture.h"
#include "luts/half.h"
#include "luts/quantize/quantize.h"
#include "runtime/gpu/vulkan/vulkan_commands.h"
#include "runtime/gpu/vulkan/vulkan_pass.h"
#include "runtime/prefilter.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/luts/test_fits.h"
#include "tests/runtime/gpu/gpu_fixture.h"

namespace warplut {
namespace {

// Weights are halves, sums are of floats: what rounding makes of 16 products and of the bilinear
// means.
constexpr double kTolerance = 2e-6;
constexpr int kRowLength = 40;  // pixels of the row that is prefiltered

// Row v of the result: 4 texels of bilinear weights, 4 of nearest ones, the warped value; below
// them the prefiltered row.
constexpr const char* kTables = R"(#version 450
layout(binding = 4) uniform sampler2DArray table;
layout(binding = 5) uniform sampler2D halves;

// Vector i of the array of rows: eight halves, whose bits are numbers in two texels.
uvec4 RowOf(int i) {
  uvec4 a = uvec4(texelFetch(halves, ivec2(2 * i, 0), 0));
  uvec4 b = uvec4(texelFetch(halves, ivec2(2 * i + 1, 0), 0));
  return uvec4(a.x | a.y << 16, a.z | a.w << 16, b.x | b.y << 16, b.z | b.w << 16);
}
)";
constexpr const char* kMain = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D patches;
layout(binding = 1) uniform sampler2D offsets;
layout(binding = 2) uniform sampler2D row;
layout(binding = 3, rgba32f) writeonly uniform image2D result;
layout(push_constant) uniform Numbers { int vectors; } numbers;

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (p.y > numbers.vectors) return;
  if (p.y == numbers.vectors) {
#ifdef PREFILTER
    ivec2 size = textureSize(row, 0);
    if (p.x >= size.x) return;
    imageStore(result, p, test_fit_prefilter(row, size, ivec2(p.x, 0), ivec2(1, 0)));
#endif
    return;
  }
  vec2 offset = texelFetch(offsets, ivec2(p.y, 0), 0).xy;
  vec4 value = vec4(0.0);
  if (p.x < 4) value = test_fit_weights(offset)[p.x];
  else if (p.x < 8) value = test_fit_nearest_weights(offset)[p.x - 4];
  else if (p.x > 8) return;
  vec2 position = vec2(6 * p.y + 2, 2) + 0.5 + offset;
  if (p.x == 8) value = test_fit_sample(patches, textureSize(patches, 0), position);
  imageStore(result, p, value);
}
)";

// Where nodes come from, and whether there is a prefilter.
struct BakedForm {
  const char* name;
  bool texture, prefilter;
};

constexpr int kVectors = 306;  // of the array: two for each of 153 rows

// Cuts the array of rows out of the source, reads RowOf in its place, and returns its halves.
std::vector<float> TakeArray(std::string* source) {
  const std::string start = "uvec4 test_fit_rows[306] = uvec4[306](", end = ");\n";
  const std::size_t from = source->find(start), to = source->find(end, from);
  EXPECT_NE(from, std::string::npos);
  std::vector<float> halves;
  for (std::size_t at = source->find("0x", from); at < to; at = source->find("0x", at + 1)) {
    const unsigned long word = std::stoul(source->substr(at, 10), nullptr, 16);
    halves.push_back(static_cast<float>(word & 0xFFFF));
    halves.push_back(static_cast<float>(word >> 16));
  }
  source->erase(from, to + end.size() - from);
  for (std::size_t at = 0; (at = source->find("test_fit_rows[", at)) != std::string::npos;) {
    source->replace(at, 14, "RowOf(");
    source->replace(source->find(']', at), 1, ")");
  }
  EXPECT_EQ(halves.size(), std::size_t{8 * kVectors});
  return halves;
}

class BakedShaderTest : public GpuTest, public testing::WithParamInterface<BakedForm> {
 protected:
  std::vector<std::uint32_t> Compile(const std::string& source) const {
    const auto path = [&](const char* name) { return (folder_ / name).string(); };
    WriteFile(path("test.comp"),
              std::string(kTables) + (GetParam().texture ? "#define test_fit_TABLE table\n" : "") +
                  source + (GetParam().prefilter ? "#define PREFILTER\n" : "") + kMain);
    const std::string command = std::string(WARPLUT_GLSLANG) + " -V " + path("test.comp") + " -o " +
                                path("test.spv") + " > " + path("log");
    EXPECT_EQ(std::system(command.c_str()), 0) << ReadFile(path("log"));
    const std::string bytes = ReadFile(path("test.spv"));
    std::vector<std::uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
  }

  const TemporaryFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(Forms, BakedShaderTest,
                         testing::Values(BakedForm{"TextureAndPrefilter", true, true},
                                         BakedForm{"ArrayAndPrefilter", false, true},
                                         BakedForm{"Array", false, false}),
                         [](const auto& test) { return test.param.name; });

TEST_P(BakedShaderTest, GivesTheTestVectors) {
  const Fit fit = GetParam().prefilter ? WithPrefilter(MakeFit(0)) : MakeFit(0.2);
  const BakedFiles files = Bake(fit);
  std::string source, vectors_text;
  for (const BakedFile& file : files.gpu) {
    if (file.ending == ".glsl") source = file.bytes;
    if (file.ending == ".test.json") vectors_text = file.bytes;
  }
  const auto vectors = nlohmann::json::parse(vectors_text)["vectors"];
  const int count = static_cast<int>(vectors.size());
  ASSERT_GT(count, 0);

  const auto& vulkan = dynamic_cast<const VulkanDevice&>(device());
  // In the order of their bindings; the fourth is stored to.
  constexpr TexelFormat kRgba = TexelFormat::kRgba32F;
  const std::vector<ImagePlan> images = {{kRgba, 6 * count, 6},
                                         {kRgba, count, 1},
                                         {kRgba, kRowLength, 1},
                                         {kRgba, kRowLength, count + 1},
                                         {kRgba, kTableNodes, kTableNodes, 4},
                                         {kRgba, 2 * kVectors, 1}};
  std::vector<BufferPlan> buffers;
  for (const ImagePlan& image : images) buffers.push_back({image.bytes()});
  const VulkanResources resources(vulkan, images, buffers);
  const auto floats = [&](int i) { return reinterpret_cast<float*>(resources.buffer(i).bytes); };
  for (int v = 0; v < count; ++v) {
    for (int k = 0; k < 36; ++k)
      floats(0)[4 * (k / 6 * 6 * count + 6 * v + k % 6)] = vectors[v]["patch"][k];
    for (int c = 0; c < 2; ++c) floats(1)[4 * v + c] = vectors[v]["offset"][c];
  }
  ImageBuffer row(kRowLength, 1, PixelFormat::kRgba32F);
  ImageBuffer expected_row(kRowLength, 1, PixelFormat::kRgba32F);
  for (int i = 0; i < 4 * kRowLength; ++i) {
    const float sample = i % 7 == 0 ? 1.0f : 0.1f * static_cast<float>(i % 5);
    row.view().Row<float>(0)[i] = sample;
    floats(2)[i] = sample;
  }

  const BakedTable halves = QuantizeToHalves(SampleFit(fit, kNodes));
  const TableTexture texture = TextureOf(Table(halves.view()));
  for (std::size_t k = 0; k < texture.halves.size(); ++k)
    floats(4)[k] = HalfToFloat(texture.halves[k]);
  if (!GetParam().texture) {
    const std::vector<float> array = TakeArray(&source);
    std::copy(array.begin(), array.end(), floats(5));
  }

  const std::vector<std::uint32_t> code = Compile(source);
  VkSampler sampler = VK_NULL_HANDLE;
  VkSamplerCreateInfo sampling = {};
  sampling.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  sampling.maxAnisotropy = 1;
  CheckVulkan(vkCreateSampler(vulkan.handle(), &sampling, nullptr, &sampler), "to test");
  {
    PassPlan plan = {.name = "test",
                     .constants = {},
                     .sets = {},
                     .numbers_bytes = 4,
                     .width = kRowLength,
                     .height = count + 1};
    plan.sets.resize(1);
    for (int i = 0; i < 6; ++i) plan.sets[0].push_back(i == 3 ? Stored(i) : Sampled(i));
    const VulkanPass pass(vulkan, resources, plan, code, {sampler, sampler});
    VulkanCommands commands(vulkan, 1);
    commands.Run([&](VkCommandBuffer recorded) {
      for (const VulkanImage& image : resources.images()) PrepareImage(recorded, image);
      for (const int i : {0, 1, 2, 4, 5}) {
        const VulkanImage& image = resources.image(i);
        CopyToImage(recorded, resources.buffer(i), image, image.plan.width, image.plan.height);
      }
      pass.Record(recorded, &count, 0, plan.width, plan.height);
      CopyToBuffer(recorded, resources.image(3), resources.buffer(3));
    });
  }
  vkDestroySampler(vulkan.handle(), sampler, nullptr);

  const float* result = floats(3);
  for (int v = 0; v < count; ++v) {
    const float* found = result + 4 * v * kRowLength;
    for (int k = 0; k < 16; ++k) {
      EXPECT_NEAR(found[k], vectors[v]["bilinear"]["weights"][k].get<float>(), kTolerance);
      EXPECT_EQ(found[16 + k], vectors[v]["nearest"]["weights"][k].get<float>());
    }
    EXPECT_NEAR(found[32], vectors[v]["bilinear"]["value"].get<double>(), 10 * kTolerance);
  }
  if (!GetParam().prefilter) return;
  PrefilterPass::Reference(halves.view().prefilter, static_cast<const ImageBuffer&>(row).view(),
                           expected_row.view());
  for (int i = 0; i < 4 * kRowLength; ++i) {
    // kShaderPrefilterRest of the largest sample, and rounding.
    EXPECT_NEAR(result[4 * count * kRowLength + i], expected_row.view().Row<float>(0)[i], 5e-5);
  }
}

}  // namespace
}  // namespace warplut
