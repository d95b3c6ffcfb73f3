/// IHapticDevice. The haptic thread's interface lives in the servo callbacks; the graphic thread's copies from it by a synchronous
/// callback, so that neither needs a lock, and a tick takes nothing from the heap. Nothing of the C++ library is needed but new and delete.
#include <HDU/hduHapticDevice.h>
#include <string.h>

namespace {

constexpr int kButtons = 4;
constexpr int kMostErrors = 16;                // taken off the stack in one tick
constexpr unsigned kQueued = 64;               // events that wait for the graphic thread; the oldest are lost beyond

struct Matrix {
  HDdouble m[16];
};

void assign(Matrix& to, const HDdouble* from) {
  if (from) memcpy(to.m, from, sizeof to.m);
}

class State final : public IHapticDevice::IHapticDeviceState {
 public:
  State() {
    for (Matrix* matrix : {&transform_, &proxy_, &parent_}) *matrix = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
  }
  void setPosition(const hduVector3Dd& position) override { position_ = position; }
  const hduVector3Dd& getPosition() const override { return position_; }
  hduVector3Dd& getPosition() override { return position_; }
  void setTransform(const HDdouble* transform) override { assign(transform_, transform); }
  const HDdouble* getTransform() const override { return transform_.m; }
  HDdouble* getTransform() override { return transform_.m; }
  void setProxyPosition(const hduVector3Dd& position) override { proxyPosition_ = position; }
  const hduVector3Dd& getProxyPosition() const override { return proxyPosition_; }
  hduVector3Dd& getProxyPosition() override { return proxyPosition_; }
  void setProxyTransform(const HDdouble* transform) override { assign(proxy_, transform); }
  const HDdouble* getProxyTransform() const override { return proxy_.m; }
  HDdouble* getProxyTransform() override { return proxy_.m; }
  void setParentCumulativeTransform(const HDdouble* transform) override { assign(parent_, transform); }
  const HDdouble* getParentCumulativeTransform() const override { return parent_.m; }
  HDdouble* getParentCumulativeTransform() override { return parent_.m; }
  void setIsInContact(HDboolean contact) override { contact_ = contact; }
  HDboolean isInContact() const override { return contact_; }
  void setContactData(void* data) override { contactData_ = data; }
  void* getContactData() const override { return contactData_; }
  HDint getButtons() const override { return buttons_; }
  const HDErrorInfo& getLastError() const override { return error_; }

  void read() {
    hdGetDoublev(HD_CURRENT_POSITION, position_);
    hdGetDoublev(HD_CURRENT_TRANSFORM, transform_.m);
    hdGetIntegerv(HD_CURRENT_BUTTONS, &buttons_);
  }
  void setError(const HDErrorInfo& error) { error_ = error; }
  /// All but the way to the world, which each thread's interface is given by the program.
  void takeOver(const State& other) {
    const Matrix parent = parent_;
    *this = other;
    parent_ = parent;
  }

 private:
  hduVector3Dd position_, proxyPosition_;      // [mm]
  Matrix transform_, proxy_, parent_;
  HDboolean contact_ = HD_FALSE;
  void* contactData_ = nullptr;
  HDint buttons_ = 0;
  HDErrorInfo error_ = {HD_SUCCESS, 0, HD_INVALID_HANDLE};
};

struct Event {
  IHapticDevice::EventType type = IHapticDevice::NUM_EVENT_TYPES;
  State state;
};

class Interface : public IHapticDevice {
 public:
  Interface(InterfaceType type, HHD device) : type_(type), device_(device) {}
  InterfaceType getInterfaceType() const override { return type_; }
  HHD getHandle() const override { return device_; }
  IHapticDeviceState* getCurrentState() override { return &current_; }
  IHapticDeviceState* getLastState() override { return &last_; }
  void setCallback(EventType event, EventCallback callback, void* userData) override {
    if (event < 0 || event >= NUM_EVENT_TYPES) return;
    callbacks_[event] = {callback, userData};
  }

 protected:
  void call(EventType event, const State& state) const {
    const Callback& callback = callbacks_[event];
    if (callback.function) callback.function(event, &state, callback.data);
  }

  State current_, last_;

 private:
  struct Callback {
    EventCallback function = nullptr;
    void* data = nullptr;
  };
  const InterfaceType type_;
  const HHD device_;
  Callback callbacks_[NUM_EVENT_TYPES];
};

/// Lives in the servo callbacks.
class HapticThread final : public Interface {
 public:
  explicit HapticThread(HHD device) : Interface(HAPTIC_THREAD_INTERFACE, device) {}

  void beginUpdate(IHapticDevice*) override {
    hdBeginFrame(getHandle());
    last_ = current_;
    current_.read();
  }
  void endUpdate(IHapticDevice*) override {
    hdMakeCurrentDevice(getHandle());
    hdEndFrame(getHandle());
    tellButtons();
    if (!current_.isInContact() != !last_.isInContact()) tell(current_.isInContact() ? MADE_CONTACT : LOST_CONTACT);
    tellErrors();
  }

  const State& current() const { return current_; }
  /// For the graphic thread, in a callback of its own: what happened since, the oldest first.
  bool takeEvent(Event& event) {
    if (waiting_ == 0) return false;
    event = queue_[(end_ + kQueued - waiting_--) % kQueued];
    return true;
  }

 private:
  void tell(EventType event) {
    call(event, current_);
    queue_[end_].type = event;
    queue_[end_].state = current_;
    end_ = (end_ + 1) % kQueued;
    if (waiting_ < kQueued) ++waiting_;
  }
  void tellButtons() {
    const HDint now = current_.getButtons(), changed = now ^ last_.getButtons();
    for (int i = 0; i < kButtons; ++i) {
      if (!(changed & (1 << i))) continue;
      const int event = BUTTON_1_DOWN + 2 * i + (now & (1 << i) ? 0 : 1);
      tell(static_cast<EventType>(event));
    }
  }
  void tellErrors() {
    for (int i = 0; i < kMostErrors; ++i) {
      const HDErrorInfo error = hdGetError();
      if (!HD_DEVICE_ERROR(error)) return;
      current_.setError(error);
      tell(DEVICE_ERROR);
    }
  }

  Event queue_[kQueued];
  unsigned end_ = 0, waiting_ = 0;
};

/// Lives in the program's own loop.
class GraphicThread final : public Interface {
 public:
  explicit GraphicThread(HHD device) : Interface(GRAPHIC_THREAD_INTERFACE, device) {}

  void beginUpdate(IHapticDevice* syncTo) override {
    last_ = current_;
    source_ = haptic(syncTo);
    if (source_) hdScheduleSynchronous(takeOver, this, HD_MIN_SCHEDULER_PRIORITY);
  }
  /// The program may do anything in its callbacks, also schedule: they run here, after the servo thread was left.
  void endUpdate(IHapticDevice*) override {
    for (unsigned i = 0; i < count_; ++i) call(events_[i].type, events_[i].state);
    count_ = 0;
  }

 private:
  static HapticThread* haptic(IHapticDevice* device) {
    const bool fits = device && device->getInterfaceType() == HAPTIC_THREAD_INTERFACE;
    return fits ? static_cast<HapticThread*>(device) : nullptr;
  }
  static HDCallbackCode HDCALLBACK takeOver(void* self) {
    GraphicThread& graphic = *static_cast<GraphicThread*>(self);
    graphic.current_.takeOver(graphic.source_->current());
    while (graphic.count_ < kQueued && graphic.source_->takeEvent(graphic.events_[graphic.count_])) ++graphic.count_;
    return HD_CALLBACK_DONE;
  }

  HapticThread* source_ = nullptr;
  Event events_[kQueued];
  unsigned count_ = 0;
};

}  // namespace

IHapticDevice* IHapticDevice::create(InterfaceType type, HHD hHD) {
  if (type == HAPTIC_THREAD_INTERFACE) return new HapticThread(hHD);
  if (type == GRAPHIC_THREAD_INTERFACE) return new GraphicThread(hHD);
  return nullptr;
}

void IHapticDevice::destroy(IHapticDevice*& pInterface) {
  delete pInterface;
  pInterface = nullptr;
}
