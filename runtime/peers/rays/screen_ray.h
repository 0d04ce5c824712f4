// Rays as the screen shows them, and their way through its cells (docs/METHODS.md).
//
// Positions are those of pixels, the centre of the first one at (0.5, 0.5), y down. View space has
// x right, y down and z, the depth, away from the camera, all in the unit of the depth stream. A
// pinhole shows its point (x, y, z) at (cx + fx x / z, cy + fy y / z) with inverse depth g = 1 / z.
// This maps lines to lines and planes to planes, so a ray is from + t by in (position, g). Nothing
// here is rounded to float; functions run on the calling thread and in its float environment.
#pragma once

#include <array>

namespace warplut::peers {

// Focal lengths and principal point, in pixels.
struct Pinhole {
  double fx, fy, cx, cy;
};

struct ScreenRay {
  struct Point {
    double x, y, g;
  };
  Point from, by;
  // The t that lie on the screen, in front of the camera and not at infinity; begin < end, else
  // there is none.
  double begin, end;

  // The ray from `origin` along `direction` in view space, on a screen of width x height pixels.
  // Numbers that are not finite, an origin that is not in front of the camera, a direction along
  // which the ray stays at one position and depth: begin == end.
  static ScreenRay Of(const Pinhole& pinhole, const std::array<double, 3>& origin,
                      const std::array<double, 3>& direction, int width, int height);

  bool IsEmpty() const { return !(begin < end); }
  Point At(double t) const { return {from.x + t * by.x, from.y + t * by.y, InverseAt(t)}; }
  double InverseAt(double t) const { return from.g + t * by.g; }
};

// Where a ray was found to end, and the work until then.
struct ScreenHit {
  bool is_hit = false;
  double t = 0;         // of the ray
  double x = 0, y = 0;  // position
  double depth = 0;     // of the ray there
  int cells = 0;        // pixels, mip-map texels or tiles that were looked at
  int triangles = 0;    // tests of triangles

  void Take(const ScreenRay& ray, double at) {
    const ScreenRay::Point p = ray.At(at);
    is_hit = true;
    t = at;
    x = p.x;
    y = p.y;
    depth = 1 / p.g;
  }
};

// Keeps of [begin, end] the t with low <= from + t by <= high; nothing left: end < begin.
void ClipRay(double from, double by, double low, double high, double& begin, double& end);

// Whether and where a surface of inverse depth g that fills the depths from 1 / g to
// (1 + thickness) / g has the ray in it, for t in [first, last]. g = 0: there is no surface.
struct Touch {
  bool is_touched;
  double t;
};
Touch TouchOf(const ScreenRay& ray, double first, double last, double g, double thickness);

// A pixel on the way of a ray, and the t at which the ray comes to it.
class CellWalk {
 public:
  CellWalk(const ScreenRay& ray, int width, int height);

  int x() const { return x_; }
  int y() const { return y_; }
  double t() const { return t_; }
  bool IsDone() const { return !(t_ < ray_.end); }

  // The t at which the ray leaves the square of `side` pixels that has this pixel; squares begin at
  // multiples of their side.
  double Leaves(int side) const;
  // Goes to the first pixel behind that square.
  void Leave(int side);

 private:
  double Border(int pixel, int side, double from, double by) const;

  const ScreenRay& ray_;
  int x_, y_;
  double t_;
};

}  // namespace warplut::peers
