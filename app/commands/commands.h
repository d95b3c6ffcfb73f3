#pragma once
/// One function per command of DESIGN 5. Each returns the exit code and throws scenes::InputError (2) or SystemFault (3).
#include <array>
#include <string>
#include <vector>

#include "app/frame_writer.h"
#include "app/playback.h"

namespace halsted::app {

struct BenchOptions {
  std::string scene, preset;                   // empty: all of them
  int steps = 5000;
  std::string stress, plot;                    // two-bodies or one-body: that series instead, and the SVG file for its curve
  bool json = false;
};

struct DevicesOptions {
  std::string test;                            // the device to push: falcon, open, vendor, virtual, with a name; empty: list only
  std::string firmware;                        // file for a Falcon that has none
  bool bench = false;                          // force quality in numbers
  bool json = false;
};

struct TrainOptions {
  std::string scene;
  std::vector<std::string> overrides;          // --set
  std::string left, right;                     // devices; empty: the default
  std::string trainee, record;
  std::string firmware;                        // --firmware, for a Falcon that has none
  bool headless = false, json = false, verbose = false;
  double seconds = 0.0;                        // [s] 0: until the user ends it
  int width = 1280, height = 720;              // pixels
};

struct SurveyOptions {
  std::string scores;                          // CSV of the raters' scores
  std::string questionnaire = "acupuncture";   // a name or a TOML file
  std::string delphi;                          // CSV of the experts' weights; empty: the questionnaire's own
  double preference = -1.0;                    // [1] mu; negative: the questionnaire's own
  bool json = false;
};

int listScenes(bool json);
int scoreSurvey(const SurveyOptions&);
int replay(const PlayOptions&);
int capture(const PlayOptions&, const FrameOptions&);
int bench(const BenchOptions&);
int devices(const DevicesOptions&);
int train(const TrainOptions&);

/// Parses the command line, runs the command, turns exceptions into one line on standard error.
int runCommandLine(int argc, char** argv);

}  // namespace halsted::app
