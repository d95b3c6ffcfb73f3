/* One device, seen by two threads. The interface of the haptic thread opens and closes the frame of each tick; that of the graphic thread
   takes over what the other one has seen, whenever it is updated. Each calls back for what happened, on its own thread: buttons, contact
   (which the program itself says), errors.

     haptic = IHapticDevice::create(IHapticDevice::HAPTIC_THREAD_INTERFACE, hHD);      // each tick: haptic->beginUpdate(0);
     graphic = IHapticDevice::create(IHapticDevice::GRAPHIC_THREAD_INTERFACE, hHD);    //   look, set the force; haptic->endUpdate(0);
                                                                                       // each picture: graphic->beginUpdate(haptic);
                                                                                       //   graphic->endUpdate(haptic);               */
#ifndef HALSTED_HDU_HAPTIC_DEVICE_H
#define HALSTED_HDU_HAPTIC_DEVICE_H

#include <HD/hd.h>
#include <HDU/hduVector.h>

#ifdef __cplusplus

class IHapticDevice {
 public:
  /* What is known at one moment. Coordinates are the device's [mm]; the parent's transform is the program's way to the world. Matrices are
     sixteen doubles, column after column. */
  struct IHapticDeviceState {
    virtual ~IHapticDeviceState() {}

    virtual void setPosition(const hduVector3Dd &position) = 0;
    virtual const hduVector3Dd &getPosition() const = 0;
    virtual hduVector3Dd &getPosition() = 0;
    virtual void setTransform(const HDdouble *transform) = 0;
    virtual const HDdouble *getTransform() const = 0;
    virtual HDdouble *getTransform() = 0;

    virtual void setProxyPosition(const hduVector3Dd &position) = 0;
    virtual const hduVector3Dd &getProxyPosition() const = 0;
    virtual hduVector3Dd &getProxyPosition() = 0;
    virtual void setProxyTransform(const HDdouble *transform) = 0;
    virtual const HDdouble *getProxyTransform() const = 0;
    virtual HDdouble *getProxyTransform() = 0;

    virtual void setParentCumulativeTransform(const HDdouble *transform) = 0;
    virtual const HDdouble *getParentCumulativeTransform() const = 0;
    virtual HDdouble *getParentCumulativeTransform() = 0;

    virtual void setIsInContact(HDboolean contact) = 0;
    virtual HDboolean isInContact() const = 0;
    virtual void setContactData(void *data) = 0;
    virtual void *getContactData() const = 0;

    virtual HDint getButtons() const = 0;
    virtual const HDErrorInfo &getLastError() const = 0;
  };

  enum EventType {
    MADE_CONTACT,
    LOST_CONTACT,
    BUTTON_1_DOWN,
    BUTTON_1_UP,
    BUTTON_2_DOWN,
    BUTTON_2_UP,
    BUTTON_3_DOWN,
    BUTTON_3_UP,
    BUTTON_4_DOWN,
    BUTTON_4_UP,
    DEVICE_ERROR,
    NUM_EVENT_TYPES
  };
  typedef void (*EventCallback)(EventType event, const IHapticDeviceState *const pState, void *pUserData);

  enum InterfaceType { HAPTIC_THREAD_INTERFACE, GRAPHIC_THREAD_INTERFACE };

  /* Null when the type is none of the two. destroy makes the pointer null. */
  static IHapticDevice *create(InterfaceType type, HHD hHD);
  static void destroy(IHapticDevice *&pInterface);

  virtual ~IHapticDevice() {}
  virtual InterfaceType getInterfaceType() const = 0;
  virtual HHD getHandle() const = 0;

  /* Haptic thread: pSyncTo is null. Graphic thread: the interface of the haptic thread. */
  virtual void beginUpdate(IHapticDevice *pSyncTo) = 0;
  virtual void endUpdate(IHapticDevice *pSyncTo) = 0;

  /* Valid as long as the interface; the last one is that of the update before. */
  virtual IHapticDeviceState *getCurrentState() = 0;
  virtual IHapticDeviceState *getLastState() = 0;

  /* One callback an event; null takes it away. */
  virtual void setCallback(EventType event, EventCallback callback, void *pUserData) = 0;
};

#endif

#endif
