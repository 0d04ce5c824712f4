#include "tools/reflections/reflection_job.h"

#include <limits>

#include "tools/scene_rendering.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/usage_error.h"

namespace warplut {
namespace {

Cell PercentCell(double share) { return {FiniteJson(share), NumberCell(100 * share, 1).text}; }

const Columns<ReflectionScores> kColumns = {
    {"method", "", [](const ReflectionScores& s) { return TextCell(s.method); }},
    {"thickness", "thickness",
     [](const ReflectionScores& s) { return NumberCell(s.thickness, 2); }},
    {"found", "found %", [](const ReflectionScores& s) { return PercentCell(s.found); }},
    {"misplaced", "misplaced %",
     [](const ReflectionScores& s) { return PercentCell(s.misplaced); }},
    {"false_hits", "false %", [](const ReflectionScores& s) { return PercentCell(s.false_hits); }},
    {"cells", "steps", [](const ReflectionScores& s) { return NumberCell(s.cells, 1); }},
    {"triangles", "triangles",
     [](const ReflectionScores& s) { return NumberCell(s.triangles, 1); }}};

ReflectionReport MeasureScene(const std::string& scene, const ReflectionSettings& settings) {
  RenderOptions options;
  options.width = settings.width;
  options.height = settings.height;
  options.frames = settings.frame + 1;
  options.samples = 1;
  options.seed = settings.seed;
  options.inputs = false;
  const SceneRenderer renderer(scene, options);
  const Frame frame = renderer.Render(settings.frame);
  Image depth = frame.reference_depth;
  for (float& value : depth.data) {
    value = value < 1 ? value * static_cast<float>(renderer.far_plane())
                      : std::numeric_limits<float>::infinity();
  }
  std::vector<Vec2> positions;
  for (int y = settings.step / 2; y < settings.height; y += settings.step) {
    for (int x = settings.step / 2; x < settings.width; x += settings.step) {
      positions.push_back({x + 0.5, y + 0.5});
    }
  }
  const Camera& camera = *frame.camera;
  const peers::Pinhole pinhole{camera.projection[0] * settings.width / 2,
                               camera.projection[5] * settings.height / 2, 0.5 * settings.width,
                               0.5 * settings.height};
  const ImageView view{depth.data.data(), depth.width, depth.height,
                       static_cast<std::ptrdiff_t>(sizeof(float)) * depth.width,
                       PixelFormat::kR32F};
  return ScoreReflections(scene, view, pinhole, renderer.Reflect(settings.frame, positions),
                          settings);
}

}  // namespace

std::vector<ReflectionReport> MeasureReflections(const std::vector<std::string>& scenes,
                                                 const ReflectionSettings& settings) {
  std::vector<std::string> names;
  for (const std::string& selection : scenes) {
    for (const std::string& scene : AsUsage([&] { return SelectScenes(selection); })) {
      names.push_back(scene);
    }
  }
  std::vector<ReflectionReport> reports;
  {
    Progress progress("tracing", static_cast<double>(names.size()), "scenes");
    for (const std::string& name : names) {
      ThrowIfInterrupted("reflections", "nothing was printed");
      reports.push_back(MeasureScene(name, settings));
      progress.Add(1);
    }
  }
  if (reports.size() > 1) reports.push_back(MeanReflections(reports));
  return reports;
}

TextTable ReflectionTable(const ReflectionReport& report) {
  TextTable table = RecordTable(kColumns, report.methods);
  table.header.insert(table.header.begin(),
                      report.scene + ", " + PercentCell(report.findable).text + " % findable");
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    table.rows[i].insert(table.rows[i].begin(), report.methods[i].method);
  }
  return table;
}

Json ToJson(const ReflectionReport& report) {
  return {{"scene", report.scene},
          {"rays", report.rays},
          {"findable", FiniteJson(report.findable)},
          {"methods", RecordsJson(kColumns, report.methods)}};
}

}  // namespace warplut
