// `warplut view` in process: what it writes, of methods and of folders.
#include "tools/view/view_job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/test_images.h"
#include "tests/train/replay/pan_sequence.h"
#include "tools/view/method_frames.h"
#include "tools/view/view_page.h"
#include "tools/view/view_video.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

// PATH for the time of a test.
class SearchPath {
 public:
  explicit SearchPath(const std::string& path) : old_(std::getenv("PATH")) {
    setenv("PATH", path.c_str(), 1);
  }
  ~SearchPath() { setenv("PATH", old_.c_str(), 1); }
  SearchPath(const SearchPath&) = delete;
  SearchPath& operator=(const SearchPath&) = delete;

 private:
  const std::string old_;
};

class ViewJob : public testing::Test {
 protected:
  ViewRequest Methods(const std::vector<std::string>& methods, const PanOptions& pan = {}) const {
    WritePan(folder_ / "pan", pan);
    ViewRequest request;
    request.sequence = folder_ / "pan";
    request.methods = methods;
    request.pipeline.filter = "catmull-rom";
    request.out = folder_ / "out";
    return request;
  }
  ViewRequest Folders() const {
    for (const char* name : {"a", "b", "ideal"}) {
      fs::create_directory(folder_ / name);
      for (const char* frame : {"f0.png", "f1.png", "f2.png"}) {
        Image image = WavyImage(60, 40);
        if (*name == 'a' && frame[1] == '2') image.at(7, 9, 1) = 1;
        WriteImage(folder_ / name / frame, image, PixelType::kUint8);
      }
    }
    ViewRequest request;
    request.folders = {folder_ / "a", folder_ / "b"};
    request.out = folder_ / "out";
    return request;
  }
  std::string Out(const std::string& name) const { return (folder_ / "out" / name).string(); }
  // Nothing is there under a name that is only for the time of writing.
  void ExpectNoTemporaries() const {
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out")) {
      EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path();
    }
  }

  const TemporaryFolder folder_;
  const SearchPath no_programs_{folder_.path()};
};

TEST_F(ViewJob, OfMethodsDrawsWhatIsThere) {
  const ViewResult result = RunView(Methods({"sr", "bilinear"}));
  for (const char* name : {"sheet.png", "worst-sr.png", "worst-bilinear.png", "error-0011.png",
                           "flip-0011.png", "index.html"}) {
    EXPECT_THAT(result.files, Contains(Out(name)));
    EXPECT_TRUE(fs::exists(Out(name))) << name;
  }
  for (const char* source : {"sr", "bilinear", "reference"}) {
    EXPECT_EQ(ReadImageInfo(Out("frames/") + source + "/0015.png").width, 80) << source;
  }
  EXPECT_FALSE(fs::exists(Out("frames/sr/0010.png"))) << "the first frame is not judged";
  EXPECT_THAT(result.sentences, Contains(HasSubstr("x 4: black is 0")));
  EXPECT_THAT(result.sentences, Contains(HasSubstr("ffmpeg is not installed")));
  ExpectNoTemporaries();
  const std::string page = ReadFile(Out("index.html"));
  EXPECT_THAT(page, HasSubstr("error of bilinear x 4"));
  EXPECT_THAT(page, HasSubstr("frame 0011"));
  EXPECT_THAT(page, HasSubstr("ffmpeg is not installed"));
}

TEST_F(ViewJob, ReadsWithoutReferencesToo) {
  ViewRequest request = Methods({"sr", "bicubic"}, {.streams = Streams::kRenderGrid});
  RunView(request);
  EXPECT_FALSE(fs::exists(Out("frames/reference")));
  EXPECT_TRUE(fs::exists(Out("worst-sr.png")));
  EXPECT_FALSE(fs::exists(Out("worst-bicubic.png")));
  EXPECT_THAT(ReadFile(Out("index.html")), HasSubstr("difference of R, G, B to bicubic"));
}

TEST_F(ViewJob, TakesTheFramesThatBothShow) {
  ViewRequest request = Methods({"sr", "isr"});
  const ViewedFrames frames = FramesOfMethods(request, folder_ / "frames");
  ASSERT_EQ(frames.files.size(), 2U);
  EXPECT_EQ(frames.files[0].name, "0011");
  EXPECT_EQ(frames.files[1].name, "0013");
  EXPECT_TRUE(frames.HasReference());
  request.pipeline.frames = "10:10";
  ExpectError([&] { FramesOfMethods(request, folder_ / "frames"); }, {"common frame"});
}

TEST_F(ViewJob, OfFoldersFindsWhereTheyDiffer) {
  ViewRequest request = Folders();
  request.shown = 1;
  request.reference = folder_ / "ideal";
  const ViewResult result = RunView(request);
  EXPECT_THAT(result.files, Contains(Out("worst-a.png")));
  EXPECT_THAT(result.files, Contains(Out("flip-f2.png")));
  EXPECT_THAT(result.files, Not(Contains(Out("worst-b.png"))));
  EXPECT_THAT(result.files, Not(Contains(Out("flip-f1.png"))));
  EXPECT_THAT(ReadFile(Out("index.html")), HasSubstr("of b: equal dB"));
  request.folders[0] = request.folders[1];
  request.reference.clear();
  EXPECT_THAT(RunView(request).sentences, Contains(HasSubstr("do not differ")));
}

TEST_F(ViewJob, RefusesWhatMakesNoSense) {
  const auto why = [](const ViewRequest& request) {
    std::string sentence;
    EXPECT_FALSE(request.IsValid(&sentence));
    return sentence;
  };
  ViewRequest request = Folders();
  EXPECT_TRUE(request.IsValid(nullptr));
  request.amplify = 0.5;
  EXPECT_THAT(why(request), HasSubstr("--amplify is 0.5"));
  request = Folders();
  request.shown = 0;
  EXPECT_THAT(why(request), HasSubstr("--shown is 0"));
  request = Folders();
  request.rate = 0;
  EXPECT_THAT(why(request), HasSubstr("--rate is 0"));
  request = Folders();
  request.folders.pop_back();
  EXPECT_THAT(why(request), HasSubstr("1 folder is given"));
  request.folders.clear();
  EXPECT_THAT(why(request), HasSubstr("not clear what to view"));
  request = Methods({"sr", "sr"});
  EXPECT_THAT(why(request), HasSubstr("two that differ"));
  request.methods = {"sr", "none"};
  EXPECT_THAT(why(request), HasSubstr("'none'"));
  request.methods = {"sr", "bilinear"};
  request.reference = folder_ / "a";
  EXPECT_THAT(why(request), HasSubstr("--reference"));
  ExpectError([&] { RunView(request); }, {"--reference"});
}

TEST_F(ViewJob, RefusesImagesThatDoNotFit) {
  ViewRequest request = Folders();
  WriteWavyImage(folder_ / "b" / "f1.png", 61, 40);
  ExpectError([&] { RunView(request); }, {"frame f1", "61 x 40", "60 x 40"});
  EXPECT_FALSE(fs::exists(Out("index.html")));
  fs::remove(folder_ / "b" / "f1.png");
  ExpectError([&] { RunView(request); }, {"f1.png", "no image of the same name"});
}

TEST_F(ViewJob, AVideoIsMadeByTheProgramThatIsThere) {
  // Takes the last argument for its output and says what it was given.
  WriteFile(folder_ / "ffmpeg",
            "#!/bin/sh\n[ \"$1\" = -version ] && exit 0\nfor last; do :; done\n"
            "echo \"$@\" > \"$last\"\n");
  fs::permissions(folder_ / "ffmpeg", fs::perms::owner_all);
  ViewRequest request = Folders();
  request.rate = 25;
  const ViewResult result = RunView(request);
  EXPECT_THAT(result.files, Contains(Out("video.mp4")));
  EXPECT_THAT(ReadFile(Out("video.mp4")), HasSubstr("-framerate 25 "));
  ExpectNoTemporaries();
  WriteFile(folder_ / "ffmpeg",
            "#!/bin/sh\n[ \"$1\" = -version ] && exit 0\n"
            "echo 'no encoder' >&2\nexit 1\n");
  fs::permissions(folder_ / "ffmpeg", fs::perms::owner_all);
  fs::remove(Out("video.mp4"));
  EXPECT_THAT(RunView(request).sentences, Contains(HasSubstr("ffmpeg says 'no encoder'")));
  EXPECT_FALSE(fs::exists(Out("video.mp4")));
}

TEST(ViewPage, StandsAloneAndEscapes) {
  const std::string page = ViewPage(
      "<a> & b", {"1 < 2"},
      {{.id = "x", .title = "<t>", .caption = "c & d", .layers = {{"<l>", "p"}, {"r", "q"}}}});
  EXPECT_THAT(page, HasSubstr("&lt;a&gt; &amp; b"));
  EXPECT_THAT(page, HasSubstr("&lt;l&gt;"));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,cA=="));
  EXPECT_THAT(page, HasSubstr("type=\"range\""));
  EXPECT_THAT(page, HasSubstr("class=\"flip\""));
  EXPECT_THAT(page, Not(HasSubstr("http")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
}

}  // namespace
}  // namespace warplut
