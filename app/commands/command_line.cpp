/// The command line: what there is, what it means, with examples. Everything else is in the commands.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "app/commands/commands.h"
#include "app/commands/number_range.h"
#include "app/commands/usage_error.h"
#include "app/errors.h"
#include "app/version.h"

namespace halsted::app {
namespace {

const char* const kExamples =
    "Examples:\n"
    "  halsted scenes                                             what there is to train\n"
    "  halsted train purse_string                                 in a window: mouse and keys are the right hand (F1: help)\n"
    "  halsted train purse_string --left script:scenes/purse_string/expert.toml --record me.halsted\n"
    "  halsted replay scenes/purse_string/expert.toml --record run.halsted --report run.html\n"
    "  halsted replay run.halsted --verify                        the same bits, step by step\n"
    "  halsted capture run.halsted --video run.mp4 --out frames --at 5,20,60\n"
    "  halsted bench --json                                       what a step costs here\n"
    "  halsted devices                                            which haptic devices are attached, and what keeps one from working\n"
    "Exit codes: 0 done, 1 a check failed, 2 bad usage or input, 3 a device or system fault.";

struct CommandLine {
  PlayOptions play;
  FrameOptions frames;
  BenchOptions bench;
  DevicesOptions devices;
  TrainOptions train;
  SurveyOptions survey;
  bool scenesJson = false;
  std::string size;
};

void parseSize(const std::string& text, int& width, int& height) {
  constexpr int kLargest = 8192;               // pixels
  int w = 0, h = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &w, &h, &rest) != 2 || w < 16 || h < 16 || w > kLargest || h > kLargest)
    throw scenes::InputError("--size " + text + ": WIDTHxHEIGHT in pixels, 16 to 8192, like 1280x720");
  width = w;
  height = h;
}

/// After --set, so that a setting of one's own wins over the preset's.
void addPreset(CLI::App& command, std::vector<std::string>& overrides) {
  command.add_option_function<std::string>(
      "--preset", [&overrides](const std::string& name) { overrides.insert(overrides.begin(), "preset=" + name); },
      "settings that the scene keeps under this name: beginner (knots that the program places), friction (scene and thread made for knots that\n"
      "hold by friction) or paper; default: the scene as it is, which `train` takes only where the scene names no other");
}

void addPlayOptions(CLI::App& command, PlayOptions& play) {
  command.add_option("FILE", play.file, "an expert script (.toml) or a recorded session (.halsted)")->required();
  command.add_option("--set", play.overrides, "key=value: override a parameter of the scene; may be repeated")->allow_extra_args(false);
  addPreset(command, play.overrides);
  command.add_flag("--verify", play.verify, "check the hash of every state against the recording; exit code 1 when one differs");
  command.add_option("--record", play.record, "write a session file");
  command.add_option("--report", play.report, "write an HTML report: procedure, metrics, forces");
  command.add_option("--from", play.from, "go on from the last whole state that a recorded session holds by then, in seconds (one every 5000 steps)")
      ->check(numberFrom(0.0, 1e9));
  command.add_flag("--json", play.json, "print the outcome as JSON");
  command.add_flag("--require-complete", play.requireComplete, "exit code 1 unless the whole procedure was completed");
}

void addReplay(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("replay", "run a script or a recorded session in lockstep, as fast as the machine allows");
  addPlayOptions(*command, line.play);
  command->add_flag("--realtime", line.play.realtime, "no faster than real time");
  command->footer("Example: halsted replay scenes/purse_string/expert.toml --set tissue.youngs_modulus=60e3 --json");
}

void addCapture(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("capture", "the same as replay, with pictures: PNG frames and a video");
  addPlayOptions(*command, line.play);
  command->add_option("--out", line.frames.folder, "folder for PNG frames");
  command->add_option("--video", line.frames.video, "video file (.mp4), needs ffmpeg");
  command->add_option("--fps", line.frames.fps, "frames per second of simulated time")->capture_default_str()->check(numberFrom(0.1, 1000.0));
  command->add_option("--size", line.size, "WIDTHxHEIGHT in pixels (default 1280x720)");
  command->add_option("--at", line.frames.times,
                      "PNG frames at these times only, in seconds: 5,20,60; the run ends with the last, unless a video, record, report or check is asked for")
      ->delimiter(',')
      ->check(numberFrom(0.0, 1e9));
  command->footer("Example: halsted capture run.halsted --video run.mp4 --fps 30 --size 1280x720 --out frames --at 5,20,60\n"
                  "Example: halsted capture run.halsted --out frames --from 370 --at 372,380");
}

void addTrain(CLI::App& app, CommandLine& line) {
  TrainOptions& train = line.train;
  CLI::App* command = app.add_subcommand("train", "a session in real time, two hands, in a window");
  command->add_option("SCENE", train.scene, "a scene's name (see `halsted scenes`) or its folder")->required();
  command->add_option("--left", train.left, "device of the left hand: virtual (holds still), mouse, script:FILE, falcon[:SERIAL], open[:SERIAL], vendor[:NAME] (default: the second device attached, else virtual)");
  command->add_option("--right", train.right, "device of the right hand (default: the first device attached, else mouse, or virtual with --headless)");
  command->add_option("--firmware", train.firmware, "firmware file for a Falcon that has none (or HALSTED_FALCON_FIRMWARE)");
  command->add_option("--set", train.overrides, "key=value: override a parameter of the scene; may be repeated")->allow_extra_args(false);
  addPreset(*command, train.overrides);
  command->add_option("--trainee", train.trainee, "name kept in the recording");
  command->add_option("--record", train.record, "write a session file");
  command->add_flag("--headless", train.headless, "the same threads without a window");
  command->add_option("--seconds", train.seconds, "end after this much wall-clock time")->check(numberFrom(1e-3, 1e6));
  command->add_option("--size", line.size, "WIDTHxHEIGHT in pixels (default 1280x720)");
  command->add_flag("--json", train.json, "print the outcome as JSON");
  command->add_flag("--verbose", train.verbose, "log events and skipped ticks");
  command->footer("In the window: mouse moves the hand, wheel nearer and farther, right drag turns, left button or space closes the\n"
                  "jaws, C cuts a body open, N asks for a new needled thread, T changes both instruments, H hands a clamp to the assistant, F1 help, Esc ends.\n"
                  "Example: halsted train purse_string --headless --seconds 10 --json");
}

void addDevices(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("devices", "which haptic devices are attached, what can drive them, and why not");
  command->add_option("--test", line.devices.test, "a bounded force check on one: falcon, open, vendor or virtual, like --left of train");
  command->add_option("--firmware", line.devices.firmware, "firmware file for a Falcon that has none (or HALSTED_FALCON_FIRMWARE)");
  command->add_flag("--bench", line.devices.bench,
                    "no device: force quality of the servo loop in numbers with units and bounds (stability, energy, buzz, rates, faults, jitter);\n"
                    "some minutes; exit code 1 when a bound is missed; haptics/README.md explains the rows")
      ->excludes("--test");
  command->add_flag("--json", line.devices.json, "print JSON");
  command->footer("The check pushes with 1.5 N along each axis while you hold the grip loosely.\n"
                  "Example: halsted devices --test falcon\nExample: halsted devices --bench --json");
}

void addBench(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("bench", "what a physics step and a frame cost here, beside the published figures");
  command->add_option("--scene", line.bench.scene, "one scene only");
  command->add_option("--steps", line.bench.steps, "steps to measure")->capture_default_str()->check(CLI::Range(1, 100'000'000));
  command->add_option("--preset", line.bench.preset, "default, or beginner, paper or friction where the scene has it; all when not given")
      ->check(CLI::IsMember({"default", "beginner", "paper", "friction"}));
  CLI::Option* stress = command->add_option("--stress", line.bench.stress, "stitch after stitch to fifty: what a step costs, as in the paper's figures 20 to 23")
                            ->check(CLI::IsMember({"two-bodies", "one-body"}))->excludes("--scene", "--preset");
  command->add_option("--plot", line.bench.plot, "SVG file for the curve (default: stress-<series>.svg)")->needs(stress);
  command->add_flag("--json", line.bench.json, "print a JSON list");
  command->footer("Example: halsted bench --scene purse_string --preset paper\nExample: halsted bench --stress two-bodies --plot curve.svg");
}

void addSurvey(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("survey", "what raters thought of a simulator");
  command->require_subcommand(1);
  CLI::App* score = command->add_subcommand("score", "weights and final scores from a table of raters' scores");
  score->add_option("FILE", line.survey.scores, "CSV: system,rater,<one column per index>")->required();
  score->add_option("--questionnaire", line.survey.questionnaire, "acupuncture, rectal_prolapse, or a TOML file")->capture_default_str();
  score->add_option("--delphi", line.survey.delphi, "CSV of experts' weights: round,expert,<one column per index>");
  score->add_option("--mu", line.survey.preference, "share of the subjective weights (default: the questionnaire's)")->check(numberFrom(0.0, 1.0));
  score->add_flag("--json", line.survey.json, "print the outcome as JSON");
  score->footer("Example: halsted survey score raters.csv --delphi experts.csv --json");
}

int dispatch(const CLI::App& app, CommandLine& line) {
  if (!line.size.empty()) {
    parseSize(line.size, line.frames.width, line.frames.height);
    parseSize(line.size, line.train.width, line.train.height);
  }
  if (app.got_subcommand("scenes")) return listScenes(line.scenesJson);
  if (app.got_subcommand("replay")) return replay(line.play);
  if (app.got_subcommand("capture")) return capture(line.play, line.frames);
  if (app.got_subcommand("bench")) return bench(line.bench);
  if (app.got_subcommand("survey")) return scoreSurvey(line.survey);
  if (app.got_subcommand("devices")) return devices(line.devices);
  return train(line.train);
}

/// False: it only asked for --help or --version, which has been printed.
bool parsed(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {
    app.exit(request);
    return false;
  }
  return true;
}

/// What was printed has been lost where the disk is full: whoever reads it must not take the run for done.
int printed(int code) {
  std::cout.flush();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) || !std::cout) throw SystemFault("standard output: cannot be written");
  return code;
}

int report(const std::exception& error, int code) {
  std::fprintf(stderr, "halsted: %s\n", error.what());
  return code;
}

}  // namespace

int runCommandLine(int argc, char** argv) {
  CommandLine line;
  CLI::App app("Halsted: a surgical simulator for two hands that feel what they touch.");
  app.footer(kExamples);
  app.set_version_flag("--version", kVersionText);
  app.require_subcommand(1);
  app.add_subcommand("scenes", "list the scenes")->add_flag("--json", line.scenesJson, "print a JSON list");
  addTrain(app, line);
  addReplay(app, line);
  addCapture(app, line);
  addBench(app, line);
  addSurvey(app, line);
  addDevices(app, line);
  try {
    return printed(parsed(app, argc, argv) ? dispatch(app, line) : kDone);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "halsted: %s\n", usageLine(app, error).c_str());
    return kBadInput;
  } catch (const scenes::InputError& error) {
    return report(error, kBadInput);
  } catch (const SystemFault& error) {
    return report(error, kSystemFault);
  } catch (const std::exception& error) {
    return report(error, kSystemFault);
  }
}

}  // namespace halsted::app
