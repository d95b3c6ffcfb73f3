#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <fstream>

#include "app/stress/series.h"
#include "scenes/scene.h"

namespace halsted::app {
namespace {

constexpr double kWidth = 760.0, kHeight = 420.0, kLeft = 70.0, kRight = 20.0, kTop = 50.0, kBottom = 60.0;   // [px]
constexpr double kFrame = 12.0;                // [ms] of simulated time in a frame, as the paper's 82 a second
struct Mark { double stitches, milliseconds; };   // [1] [ms]
constexpr Mark kPublished[] = {{13.0, 10.0}, {26.0, 20.0}};      // paper 003, figure 21: solver time, two bodies; real time ended at 26

std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));
std::string format(const char* pattern, ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(text, sizeof text, pattern, arguments);
  va_end(arguments);
  return text;
}

/// From stitches and milliseconds to the picture.
struct Scale {
  double most;                                 // [ms]
  double x(double stitches) const { return kLeft + stitches / kMostStressed * (kWidth - kLeft - kRight); }   // [1] [px]
  double y(double ms) const { return kHeight - kBottom - ms / most * (kHeight - kTop - kBottom); }           // [ms] [px]
};

std::string axes(const Scale& s) {
  std::string out;
  for (int n = 0; n <= kMostStressed; n += 10)
    out += format("<text x='%.1f' y='%.1f' text-anchor='middle'>%d</text>\n", s.x(n), kHeight - kBottom + 18.0, n);
  const double every = s.most > 12.0 ? 4.0 : 1.0;                      // [ms]
  for (double ms = 0.0; ms <= s.most; ms += every)
    out += format("<line x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f' stroke='#ddd'/><text x='%.1f' y='%.1f' text-anchor='end'>%g</text>\n", kLeft,
                  s.y(ms), kWidth - kRight, s.y(ms), kLeft - 8.0, s.y(ms) + 4.0, ms);
  return out + format("<text x='%.1f' y='%.1f' text-anchor='middle'>stitches</text>\n", 0.5 * (kLeft + kWidth - kRight), kHeight - 14.0) +
         format("<text x='18' y='%.1f' transform='rotate(-90 18 %.1f)' text-anchor='middle'>ms of one core for 12 ms of simulation</text>\n",
                0.5 * kHeight, 0.5 * kHeight);
}

double frameOf(const StressSeries& series, const StressPoint& p) { return p.stepMedian * 1e-3 * kFrame / series.dt; }   // [ms]

std::string curve(const StressSeries& series, const Scale& s) {
  std::string out = "<polyline fill='none' stroke='#146' stroke-width='2' points='";
  for (const StressPoint& p : series.points) out += format("%.1f,%.1f ", s.x(p.stitches), s.y(frameOf(series, p)));
  return out + "'/>\n";
}

std::string publishedMarks(const Scale& s) {
  std::string out;
  for (const Mark& mark : kPublished)
    out += format("<circle cx='%.1f' cy='%.1f' r='5' fill='none' stroke='#b33' stroke-width='2'/>\n", s.x(mark.stitches), s.y(mark.milliseconds));
  return out + format("<text x='%.1f' y='%.1f' fill='#b33'>paper 003, figure 21: 16 cores</text>\n", s.x(kPublished[0].stitches) + 12.0,
                      s.y(kPublished[0].milliseconds) - 8.0);
}

}  // namespace

void writePlot(const StressSeries& series, const std::string& file) {
  const bool published = series.name == "two-bodies";
  double most = published ? 22.0 : kFrame + 1.0;                       // [ms]
  for (const StressPoint& p : series.points) most = std::max(most, frameOf(series, p) + 1.0);
  const Scale s{std::ceil(most)};
  std::ofstream out(file);
  out << format("<svg xmlns='http://www.w3.org/2000/svg' width='%g' height='%g' font-family='sans-serif' font-size='13'>\n", kWidth, kHeight)
      << "<rect width='100%' height='100%' fill='white'/>\n"
      << format("<text x='%.1f' y='24' font-size='15'>%s</text>\n", kLeft, series.what.c_str()) << axes(s)
      << format("<line x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f' stroke='#888' stroke-dasharray='6 4'/>\n", kLeft, s.y(kFrame), kWidth - kRight, s.y(kFrame))
      << format("<text x='%.1f' y='%.1f' text-anchor='end' fill='#666'>real time</text>\n", kWidth - kRight - 4.0, s.y(kFrame) - 5.0)
      << curve(series, s) << format("<text x='%.1f' y='42' fill='#146'>median of %d steps</text>\n", kLeft, kTimedSteps)
      << (published ? publishedMarks(s) : "") << "</svg>\n";
  out.flush();
  if (!out) throw scenes::InputError(file + ": cannot be written");
}

}  // namespace halsted::app
