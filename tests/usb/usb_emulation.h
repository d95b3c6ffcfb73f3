#pragma once
/// Device models behind the real libusb: umockdev answers the kernel's USB calls of this process and of its children, and the models
/// answer umockdev. The models live in real time here. umockdev calls from a thread of its own: take the lock before touching a model.
/// What it cannot carry, and no test here claims: timing (a transfer costs 0.3 to 0.4 ms) and libusb's own notice of a pulled cable
/// through poll(); an unplugged device shows as ENODEV and ESHUTDOWN, and as a uevent.
#include <umockdev.h>

#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "haptics/usb/loopback_bus.h"

namespace halsted::testing {

class UsbEmulation {
 public:
  UsbEmulation();
  ~UsbEmulation();
  UsbEmulation(const UsbEmulation&) = delete;
  UsbEmulation& operator=(const UsbEmulation&) = delete;

  /// False where the program was not started under umockdev's preload library.
  static bool available();
  int plug(haptics::UsbModel&);                                  // the model must outlive the emulation
  void unplug(int port);
  void replug(int port);
  void replug(int port, haptics::UsbModel& other);               // another device on the same socket
  haptics::UsbFaults& faults(int port) { return ports_[static_cast<std::size_t>(port)]->faults; }   // under the lock
  std::mutex& lock() { return lock_; }

 private:
  struct Urb { UMockdevIoctlData *urb, *buffer; };
  struct Port {
    UsbEmulation* owner = nullptr;
    haptics::UsbModel* model = nullptr;
    haptics::UsbFaults faults;
    UMockdevIoctlBase* handler = nullptr;
    std::string node, sysfs;
    int number = 0;
    bool attached = false;
    std::deque<Urb> flying, discarded;
    double lastTime = 0.0;                     // [s]
  };
  static gboolean onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient*, gpointer port);
  void addDevice(Port&);
  void advance(Port&);
  void handle(Port&, UMockdevIoctlClient*);
  void submit(Port&, UMockdevIoctlClient*, UMockdevIoctlData* argument);
  void reap(Port&, UMockdevIoctlClient*, UMockdevIoctlData* argument);
  void discard(Port&, UMockdevIoctlClient*, UMockdevIoctlData* argument);
  void finish(UMockdevIoctlClient*, UMockdevIoctlData* argument, Urb, int status);
  bool answer(Port&, const Urb&, int& status);

  UMockdevTestbed* testbed_ = nullptr;
  std::vector<std::unique_ptr<Port>> ports_;
  int nextAddress_ = 2;                        // as a kernel does it: another one at every plug
  std::mutex lock_;
};

}  // namespace halsted::testing
