// Point snapping, two threads: the servo thread pulls the stylus to a point once it is near, the main thread follows at 60 Hz and counts
// what it is told. Everything goes through IHapticDevice.
#include <HD/hd.h>
#include <HDU/hdu.h>
#include <HDU/hduError.h>
#include <HDU/hduGenericMatrix.h>
#include <HDU/hduHapticDevice.h>
#include <HDU/hduLineSegment.h>
#include <HDU/hduMath.h>
#include <HDU/hduMatrix.h>
#include <HDU/hduPlane.h>
#include <HL/hl.h>
#include <HLU/hlu.h>

#include <chrono>
#include <iostream>
#include <map>
#include <string>
#include <thread>

namespace {

class SnapManager {
public:
    explicit SnapManager(const hduVector3Dd &point) : m_point(point) {}

    bool Setup() {
        m_hHD = hdInitDevice(HD_DEFAULT_DEVICE);
        HDErrorInfo error;
        if (HD_DEVICE_ERROR(error = hdGetError())) {
            std::cerr << error << std::endl;
            return false;
        }
        m_pHT = IHapticDevice::create(IHapticDevice::HAPTIC_THREAD_INTERFACE, m_hHD);
        m_pGT = IHapticDevice::create(IHapticDevice::GRAPHIC_THREAD_INTERFACE, m_hHD);
        m_pGT->setCallback(IHapticDevice::MADE_CONTACT, &SnapManager::OnContact, this);
        m_pGT->setCallback(IHapticDevice::LOST_CONTACT, &SnapManager::OnContact, this);
        m_pGT->setCallback(IHapticDevice::BUTTON_1_DOWN, &SnapManager::OnButton, this);
        m_pGT->setCallback(IHapticDevice::BUTTON_1_UP, &SnapManager::OnButton, this);
        m_pGT->setCallback(IHapticDevice::DEVICE_ERROR, &SnapManager::OnError, this);
        hdEnable(HD_FORCE_OUTPUT);
        m_hUpdate = hdScheduleAsynchronous(&SnapManager::Tick, this, HD_MAX_SCHEDULER_PRIORITY);
        hdStartScheduler();
        UpdateWorkspace();
        return !HD_DEVICE_ERROR(error = hdGetError());
    }

    void Follow(double seconds) {
        const int pictures = static_cast<int>(60.0 * seconds);
        for (int i = 0; i < pictures; ++i) {
            m_pGT->beginUpdate(m_pHT);
            m_pGT->endUpdate(m_pHT);
            std::this_thread::sleep_for(std::chrono::milliseconds(16));
        }
    }

    void Cleanup() {
        hdStopScheduler();
        if (m_hUpdate != HD_INVALID_HANDLE) hdUnschedule(m_hUpdate);
        hdDisableDevice(m_hHD);
        const hduVector3Dd where = m_pGT->getCurrentState()->getPosition();
        hduVector3Dd world;
        hduMatrix(m_pGT->getCurrentState()->getParentCumulativeTransform()).multVecMatrix(where, world);
        IHapticDevice::destroy(m_pGT);
        IHapticDevice::destroy(m_pHT);
        std::cout << "made " << m_contacts[IHapticDevice::MADE_CONTACT] << " lost " << m_contacts[IHapticDevice::LOST_CONTACT] << " down "
                  << m_downs << " up " << m_ups << " errors " << m_errors << " data " << m_data << " strongest " << m_strongest
                  << " gone " << (m_pGT == 0 && m_pHT == 0) << "\nend " << where << " world " << world << std::endl;
    }

private:
    void UpdateWorkspace() {
        const HDdouble projection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -1, 0, 0, -3, 0};
        const HDdouble modelview[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -5, 1};
        hduMapWorkspaceModel(modelview, projection, m_workspace);
        hdScheduleSynchronous(&SnapManager::SetTransform, this, HD_DEFAULT_SCHEDULER_PRIORITY);
    }

    static HDCallbackCode HDCALLBACK SetTransform(void *pUserData) {
        SnapManager *pThis = static_cast<SnapManager *>(pUserData);
        pThis->m_pGT->getCurrentState()->setParentCumulativeTransform(pThis->m_workspace);
        pThis->m_pHT->getCurrentState()->setParentCumulativeTransform(pThis->m_workspace);
        return HD_CALLBACK_DONE;
    }

    static HDCallbackCode HDCALLBACK Tick(void *pUserData) {
        SnapManager *pThis = static_cast<SnapManager *>(pUserData);
        pThis->m_pHT->beginUpdate(0);
        IHapticDevice::IHapticDeviceState *pNow = pThis->m_pHT->getCurrentState();
        const hduVector3Dd position = pNow->getPosition();
        const bool near = position.distance(pThis->m_point) < 12.0;
        pNow->setIsInContact(near);
        pNow->setContactData(reinterpret_cast<void *>(near || pThis->m_pHT->getLastState()->isInContact() ? 7L : -1L));
        pNow->setProxyPosition(near ? pThis->m_point : position);
        hdGetDoublev(HD_CURRENT_TRANSFORM, pNow->getProxyTransform());
        double stiffness = 0;
        hdGetDoublev(HD_NOMINAL_MAX_STIFFNESS, &stiffness);
        stiffness = hduMin(0.1, stiffness);
        const hduVector3Dd force = stiffness * (pNow->getProxyPosition() - position);
        hdSetDoublev(HD_CURRENT_FORCE, force);
        pThis->m_strongest = hduMax(pThis->m_strongest, force.magnitude());
        pThis->m_pHT->endUpdate(0);
        return HD_CALLBACK_CONTINUE;
    }

    static void OnContact(IHapticDevice::EventType event, const IHapticDevice::IHapticDeviceState *const pState, void *pUserData) {
        SnapManager *pThis = static_cast<SnapManager *>(pUserData);
        ++pThis->m_contacts[event];
        pThis->m_data = (long int)pState->getContactData();
    }
    static void OnButton(IHapticDevice::EventType event, const IHapticDevice::IHapticDeviceState *const, void *pUserData) {
        SnapManager *pThis = static_cast<SnapManager *>(pUserData);
        ++(event == IHapticDevice::BUTTON_1_DOWN ? pThis->m_downs : pThis->m_ups);
    }
    static void OnError(IHapticDevice::EventType, const IHapticDevice::IHapticDeviceState *const pState, void *pUserData) {
        std::cerr << pState->getLastError() << (hduIsForceError(&pState->getLastError()) ? " (force)" : "") << std::endl;
        ++static_cast<SnapManager *>(pUserData)->m_errors;
    }

    hduVector3Dd m_point;
    HHD m_hHD = HD_INVALID_HANDLE;
    HDSchedulerHandle m_hUpdate = HD_INVALID_HANDLE;
    IHapticDevice *m_pHT = nullptr, *m_pGT = nullptr;
    hduMatrix m_workspace;
    std::map<int, int> m_contacts;
    int m_downs = 0, m_ups = 0, m_errors = 0;
    long m_data = 0;
    double m_strongest = 0;
};

}  // namespace

int main() {
    SnapManager manager(hduVector3Dd(30, 0, 0));
    if (!manager.Setup()) return 1;
    manager.Follow(1.6);
    manager.Cleanup();
    // What the geometry classes say about the way to the point.
    hduPlaned plane(hduVector3Dd(1, 0, 0), 0.0);
    plane.setPlane(hduVector3Dd(2, 0, 0), hduVector3Dd(15, 0, 0));
    HDdouble t = 0;
    const bool back = plane.intersectSegmentFront(hduLineSegmentd(hduVector3Dd(0, 0, 0), hduVector3Dd(30, 0, 0)), t, 1e-9) == hduPlaned::ResultNone &&
                      plane.intersectSegmentBack(hduLineSegmentd(hduVector3Dd(0, 0, 0), hduVector3Dd(30, 0, 0)), t, 1e-9) == hduPlaned::ResultBack;
    std::cout << "plane " << plane.a() << " " << plane.d() << " t " << t << " back " << back << std::endl;
    return 0;
}
