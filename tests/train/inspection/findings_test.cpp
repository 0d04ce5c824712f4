// Faults are found in each of ten variants, and not where there are none.
#include "train/inspection/findings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "datasets/sequence/sequence_writer.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/train/inspection/exported_scene.h"
#include "train/inspection/inspection.h"

namespace warplut {
namespace {

constexpr int kFrames = 7, kVariants = 10;

SceneFrames& Street() {
  static SceneFrames scene("street", kFrames, 320, 180);
  return scene;
}

bool Has(const Inspection& inspection, const std::string& what) {
  return std::any_of(inspection.findings.begin(), inspection.findings.end(),
                     [&](const Finding& finding) { return finding.what == what; });
}

// Inspects the scene after `change` to a copy of its frames and of its manifest.
Inspection InspectChanged(const std::function<void(std::vector<Frame>&, Sequence&)>& change) {
  const TemporaryFolder folder;
  SceneFrames& scene = Street();
  const std::vector<Frame> kept = scene.frames();
  Sequence stated = scene.Stated();
  change(scene.frames(), stated);
  Sequence written = stated;
  written.depth->background.reset();
  scene.Write(folder.path(), written, stated);
  scene.frames() = kept;
  return Inspect(ReadSequence(folder.path()), [] {});
}

TEST(Findings, AreNoneInAScene) {
  const Inspection inspection = InspectChanged([](auto&, auto&) {});
  for (const Finding& finding : inspection.findings) ADD_FAILURE() << finding.sentence;
  EXPECT_EQ(inspection.Contradictions(), 0);
}

TEST(Findings, HaveAnUnmarkedCut) {
  for (int variant = 0; variant < kVariants; ++variant) {
    const Inspection inspection = InspectChanged([&](std::vector<Frame>& frames, Sequence&) {
      // Later frames show the same world mirrored, upside down or another part of it: the motion
      // goes on, what is seen does not.
      const int from = 2 + variant % 4;
      for (int i = from; i < kFrames; ++i) {
        Image& color = frames[static_cast<std::size_t>(i)].color;
        const Image before = color;
        const int shift = color.width / 4 + 5 * variant;
        color = Mapped(color, [&](int x, int y, int c, float) {
          const int at = (x + shift) % before.width;
          return before.at(variant % 2 == 0 ? before.width - 1 - at : at, y, c);
        });
      }
    });
    EXPECT_TRUE(Has(inspection, "unmarked cut")) << variant;
  }
}

// White text with soft edges over the frame.
Image SoftLayer(bool premultiplied, float brightness) {
  Image layer(32, 16, 4);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 32; ++x) {
      const float alpha = static_cast<float>(x) / 31;
      for (int c = 0; c < 3; ++c) layer.at(x, y, c) = brightness * (premultiplied ? alpha : 1);
      layer.at(x, y, 3) = alpha;
    }
  }
  return layer;
}

std::vector<std::string> LayerFaults(AlphaKind stated, bool premultiplied, float brightness) {
  const TemporaryFolder folder;
  Sequence sequence = StandardSequence("layer", 0, 1, {32, 16}, {32, 16}, ColorSpace::kSrgb,
                                       Streams::kColor | Streams::kHud, 0.1, 100);
  Frame frame;
  frame.color = Image(32, 16, 3);
  frame.hud = SoftLayer(premultiplied, brightness);
  const SequenceWriter writer(folder.path(), sequence);
  writer.Write(0, frame);
  writer.Finish();
  Sequence read = ReadSequence(folder.path());
  read.hud->alpha = stated;
  std::vector<std::string> found;
  for (const Finding& finding : FindLayerFaults(read)) found.push_back(finding.what);
  return found;
}

TEST(Findings, HaveAnAlphaThatIsNotAsStated) {
  using Found = std::vector<std::string>;
  constexpr AlphaKind kStraight = AlphaKind::kStraight, kMultiplied = AlphaKind::kPremultiplied;
  EXPECT_EQ(LayerFaults(kMultiplied, true, 1), Found());
  EXPECT_EQ(LayerFaults(kMultiplied, true, 0.5F), Found());
  EXPECT_EQ(LayerFaults(kStraight, false, 1), Found());
  EXPECT_EQ(LayerFaults(kStraight, false, 0.5F), Found());
  EXPECT_EQ(LayerFaults(kStraight, false, 0), Found());
  EXPECT_EQ(LayerFaults(kMultiplied, false, 1), Found{"straight alpha"});
  EXPECT_EQ(LayerFaults(kMultiplied, false, 0.5F), Found{"straight alpha"});
  EXPECT_EQ(LayerFaults(kStraight, true, 1), Found{"premultiplied alpha"});
}

TEST(Findings, AChangeOfLightIsNoCut) {
  for (const float gain : {0.5F, 0.8F, 1.15F}) {
    const Inspection inspection = InspectChanged([&](std::vector<Frame>& frames, Sequence&) {
      for (int i = 3; i < kFrames; ++i) {
        for (float& value : frames[static_cast<std::size_t>(i)].color.data) {
          value = std::min(gain * value, 1.0F);
        }
      }
    });
    EXPECT_FALSE(Has(inspection, "unmarked cut")) << gain;
  }
}

TEST(Findings, HaveAHud) {
  for (int variant = 0; variant < kVariants; ++variant) {
    const Inspection inspection = InspectChanged([&](std::vector<Frame>& frames, Sequence&) {
      for (Frame& frame : frames) {
        const int x0 = 4 + 12 * (variant % 5), y0 = variant % 2 == 0 ? 6 : 58;
        for (int y = y0; y < y0 + 24; ++y) {
          for (int x = x0; x < x0 + 60; ++x) {
            const bool ink = (x * 7 + y * 5 + variant) % 11 < 4;
            for (int c = 0; c < 3; ++c) frame.color.at(x, y, c) = ink ? 0.95F : 0.1F;
          }
        }
      }
    });
    EXPECT_TRUE(Has(inspection, "HUD")) << variant;
  }
}

TEST(Findings, HaveAnInvalidSentinel) {
  for (int variant = 0; variant < kVariants; ++variant) {
    const float sentinel[] = {-512, 1e9F, 3e38F, -1e4F, 65504, 999, -999, 100, -128, 2048};
    const Inspection inspection = InspectChanged([&](std::vector<Frame>& frames, Sequence&) {
      for (Frame& frame : frames) {
        for (int y = 0; y < frame.motion.height; ++y) {
          for (int x = variant; x < frame.motion.width; x += 11) {
            frame.motion.at(x, y, 0) = sentinel[variant];
            frame.motion.at(x, y, 1) = variant % 2 == 0 ? sentinel[variant] : 0;
          }
        }
      }
    });
    EXPECT_TRUE(Has(inspection, "invalid motion")) << variant;
  }
}

TEST(Findings, HaveARepeatedFrame) {
  for (int at = 1; at < kFrames; ++at) {
    const Inspection inspection = InspectChanged([&](std::vector<Frame>& frames, Sequence&) {
      frames[static_cast<std::size_t>(at)].color = frames[static_cast<std::size_t>(at - 1)].color;
    });
    EXPECT_TRUE(Has(inspection, "repeated frame")) << at;
  }
}

TEST(Findings, HaveASkyWithoutMotion) {
  const Inspection inspection = InspectChanged([](std::vector<Frame>& frames, Sequence&) {
    for (Frame& frame : frames) {
      for (std::size_t i = 0; i < frame.depth.data.size(); ++i) {
        // The upper third is sky in this variant, so that there is enough of it.
        if (i * 3 < frame.depth.data.size()) frame.depth.data[i] = 1;
        if (frame.depth.data[i] >= 1) frame.motion.data[2 * i] = frame.motion.data[2 * i + 1] = 0;
      }
    }
  });
  EXPECT_TRUE(Has(inspection, "sky without motion"));
}

TEST(Findings, HaveQuantisedMotion) {
  const Inspection inspection = InspectChanged([](std::vector<Frame>& frames, Sequence&) {
    for (Frame& frame : frames) {
      frame.motion =
          Mapped(frame.motion, [](int, int, int, float v) { return std::round(v * 8) / 8; });
    }
  });
  EXPECT_TRUE(Has(inspection, "quantised motion"));
}

TEST(Findings, HaveAFirstFrameWithoutMotion) {
  const Inspection inspection = InspectChanged([](std::vector<Frame>& frames, Sequence&) {
    std::fill(frames[0].motion.data.begin(), frames[0].motion.data.end(), 0.0F);
  });
  EXPECT_TRUE(Has(inspection, "first motion"));
}

TEST(Findings, HaveAHugeBackground) {
  const Inspection inspection = InspectChanged([](std::vector<Frame>& frames, Sequence& s) {
    for (Frame& frame : frames) {
      for (std::size_t i = 0; i * 3 < frame.depth.data.size(); ++i) {
        frame.depth.data[i] = static_cast<float>(1e10 / s.depth->far);
      }
    }
  });
  EXPECT_TRUE(Has(inspection, "background depth"));
}

TEST(Findings, HaveFilteredColour) {
  const Inspection inspection = InspectChanged([](std::vector<Frame>& frames, Sequence&) {
    for (Frame& frame : frames) {
      const Image before = frame.color;
      frame.color = Mapped(before, [&](int x, int y, int c, float) {
        float sum = 0;
        for (int j = -1; j <= 1; ++j) {
          for (int i = -1; i <= 1; ++i) {
            sum += before.at(std::clamp(x + i, 0, before.width - 1),
                             std::clamp(y + j, 0, before.height - 1), c);
          }
        }
        return sum / 9;
      });
    }
  });
  EXPECT_TRUE(Has(inspection, "filtered colour"));
}

// Colour spaces, and values that colour should not have, in .exr.
Inspection InspectLinear(const std::function<float(float)>& value) {
  return InspectChanged([&](std::vector<Frame>& frames, Sequence& s) {
    s.color_space = ColorSpace::kLinear;
    s.color.path = "lr/color/%04d.exr";
    s.reference->path = "hr/color/%04d.exr";
    for (Frame& frame : frames) {
      for (float& v : frame.color.data) v = value(v);
      for (float& v : frame.reference.data) v = value(v);
    }
  });
}

TEST(Findings, HaveDisplayValuesTakenForLinear) {
  EXPECT_TRUE(
      Has(InspectLinear([](float v) { return std::round(v * 255) / 255; }), "colour space"));
  EXPECT_FALSE(Has(InspectLinear([](float v) { return v * v; }), "colour space"));
}

TEST(Findings, HaveNegativeAndInfiniteColour) {
  const Inspection negative = InspectLinear([](float v) { return 4 * v * v - 0.3F; });
  EXPECT_TRUE(Has(negative, "negative colour"));
  const Inspection infinite = InspectLinear(
      [](float v) { return v > 0.9F ? std::numeric_limits<float>::infinity() : 2 * v; });
  EXPECT_TRUE(Has(infinite, "infinite colour"));
}

TEST(Findings, HaveAVignette) {
  const Inspection inspection = InspectChanged([](std::vector<Frame>& frames, Sequence&) {
    for (Frame& frame : frames) {
      const double cx = frame.color.width / 2.0, cy = frame.color.height / 2.0;
      frame.color = Mapped(frame.color, [&](int x, int y, int, float v) {
        const double r2 = ((x + 0.5 - cx) * (x + 0.5 - cx) + (y + 0.5 - cy) * (y + 0.5 - cy)) /
                          (cx * cx + cy * cy);
        return v * static_cast<float>(1 - 0.7 * r2);
      });
    }
  });
  EXPECT_TRUE(Has(inspection, "vignette"));
}

}  // namespace
}  // namespace warplut
