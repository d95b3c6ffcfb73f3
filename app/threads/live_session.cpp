#include "app/threads/live_session.h"

#include "app/render_scene.h"
#include "app/threads/realtime.h"

namespace halsted::app {
namespace {

std::array<ToolSample, kHands> restingSamples(const Scenario& scenario) {
  std::array<ToolSample, kHands> samples;
  for (int hand = 0; hand < kHands; ++hand) samples[hand].pose = scenario.start[hand];
  return samples;
}

RenderSnapshot firstSnapshot(const Scenario& scenario, const State& state) {
  RenderSnapshot snapshot;
  prepareSnapshot(scenario.model, snapshot);
  fillSnapshot(scenario.model, state, snapshot);
  return snapshot;
}

render::Frame blankFrame(const RenderOptions& options) {
  render::Frame frame;
  if (!options.toWindow) return frame;
  frame.width = options.width;
  frame.height = options.height;
  frame.rgba.assign(4u * static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height), 0);
  return frame;
}

}  // namespace

LiveSession::LiveSession(const Scenario& scenario, const LiveOptions& options)
    : scenario_(scenario), options_(options), surgeons_(scenario), scene_(renderScene(scenario)), state_(initialState(scenario.model, scenario.start)),
      links_(restingSamples(scenario), firstSnapshot(scenario, state_), blankFrame(options.render), state_) {
  for (int hand = 0; hand < kHands; ++hand) hands_[hand] = makeHand(scenario.devices[hand], scenario.start[hand]);
  if (!options.record.empty()) writer_ = std::make_unique<SessionWriter>(options.record, sessionHeader(scenario, options.trainee));
}

LiveSession::~LiveSession() { stop(); }

void LiveSession::start() {
  if (!lockMemory()) links_.physicsNotices.push({NoticeKind::kMemoryNotLocked, 0, 0});
  const std::array<Mover, kHands> movers{scenario_.devices[kLeft].mover, scenario_.devices[kRight].mover};
  recorder_ = std::thread([this] { runRecorder(writer_.get(), links_, finishRecording_, outcome_.recorder); });
  render_ = std::thread([this] { runRender(scene_, options_.render, scenario_.model, links_, outcome_.render); });
  physics_ = std::thread([this] { runPhysics(surgeons_, state_, links_, outcome_.physics); });
  for (int hand = 0; hand < kHands; ++hand)
    if (hands_[hand].device->served()) service_[hand] = std::thread([this, hand] { runDevice(*hands_[hand].device, links_.stop); });
  haptic_ = std::thread([this, movers] { runHaptic(hands_, movers, links_, outcome_.haptic); });
  if (options_.measureBareLoop) bare_ = std::thread([this] { runBareLoop(links_.stop, outcome_.bareLateness); });
}

const LiveOutcome& LiveSession::stop() {
  links_.stop.store(true);
  for (std::thread* thread : {&haptic_, &service_[kLeft], &service_[kRight], &physics_, &render_, &bare_})
    if (thread->joinable()) thread->join();
  finishRecording_.store(true);
  if (!recorder_.joinable()) return outcome_;
  recorder_.join();
  if (writer_ && outcome_.recorder.failure.empty()) {
    try {
      writer_->addState(state_.step, save(state_));
      writer_->close();
    } catch (const std::exception& error) {
      outcome_.recorder.failure = error.what();
    }
  }
  outcome_.fault = faultText();
  return outcome_;
}

std::string LiveSession::faultText() const {
  const int gone = links_.goneHand.load();
  if (gone >= 0) {
    const std::string kept = writer_ ? "; the recording up to here is kept in " + writer_->path() : "";
    return std::string(gone == kLeft ? "left" : "right") + " device (" + scenario_.devices[gone].text + "): gone" + kept;
  }
  if (!outcome_.physics.fault.empty()) return "physics: " + outcome_.physics.fault;
  if (!outcome_.recorder.failure.empty()) return outcome_.recorder.failure;
  if (!outcome_.render.failure.empty()) return "rendering: " + outcome_.render.failure;
  return {};
}

}  // namespace halsted::app
