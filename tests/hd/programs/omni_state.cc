/* State publisher in the manner of the ROS drivers for these arms: the servo callback fills a struct, a 100 Hz loop prints the messages.
 * The grey button locks the arm in place. */
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <cassert>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

#include <HL/hl.h>
#include <HD/hd.h>
#include <HDU/hduError.h>
#include <HDU/hduVector.h>
#include <HDU/hduMatrix.h>
#include <HDU/hduQuaternion.h>
#define BT_EULER_DEFAULT_ZYX

int calibrationStyle;

struct OmniState {
    hduVector3Dd position;      // mm
    hduVector3Dd velocity;      // mm/s
    hduVector3Dd inp_vel1, inp_vel2, inp_vel3;
    hduVector3Dd out_vel1, out_vel2, out_vel3;
    hduVector3Dd pos_hist1, pos_hist2;
    hduQuaternion rot;
    hduVector3Dd joints;
    hduVector3Dd force;         // N
    float thetas[7];
    int buttons[2];
    int buttons_prev[2];
    bool lock;
    hduVector3Dd lock_pos;
    double units_ratio;
};

class PhantomNode {
public:
    OmniState *state;
    int events, messages;
    double largestLock, largestQuaternionError, lastX;

    explicit PhantomNode(OmniState *s) : state(s), events(0), messages(0), largestLock(0), largestQuaternionError(0), lastX(0) {
        memset(state->thetas, 0, sizeof state->thetas);
        state->buttons[0] = state->buttons[1] = state->buttons_prev[0] = state->buttons_prev[1] = 0;
        state->lock = false;
        state->units_ratio = 1.0;
        hduVector3Dd zeros(0, 0, 0);
        state->velocity = state->inp_vel1 = state->inp_vel2 = state->inp_vel3 = zeros;
        state->out_vel1 = state->out_vel2 = state->out_vel3 = state->pos_hist1 = state->pos_hist2 = zeros;
        state->lock_pos = zeros;
    }

    void publish_omni_state() {
        std::stringstream frame;
        const double norm = state->rot.norm();
        largestQuaternionError = std::max(largestQuaternionError, std::abs(norm - 1.0));
        frame << state->position[0] / state->units_ratio << " " << state->rot.v()[0] << " " << state->rot.s() << " " << state->thetas[1];
        lastX = state->position[0];
        if (state->buttons[0] != state->buttons_prev[0] || state->buttons[1] != state->buttons_prev[1]) {
            if (state->buttons[0] == 1) state->lock = !state->lock;
            state->lock_pos = state->position;
            state->buttons_prev[0] = state->buttons[0];
            state->buttons_prev[1] = state->buttons[1];
            ++events;
        }
        if (state->lock) largestLock = std::max(largestLock, state->force.magnitude());
        if (++messages % 40 == 0) std::cout << "pose " << frame.str() << std::endl;
    }
};

HDCallbackCode HDCALLBACK omni_state_callback(void *pUserData) {
    OmniState *omni_state = static_cast<OmniState *>(pUserData);
    if (hdCheckCalibration() == HD_CALIBRATION_NEEDS_UPDATE) hdUpdateCalibration(calibrationStyle);
    hdBeginFrame(hdGetCurrentDevice());
    hduMatrix transform;
    hdGetDoublev(HD_CURRENT_TRANSFORM, transform);
    omni_state->rot = hduQuaternion(transform);
    hdGetDoublev(HD_CURRENT_POSITION, omni_state->position);
    hdGetDoublev(HD_CURRENT_JOINT_ANGLES, omni_state->joints);
    hduVector3Dd gimbal_angles;
    hdGetDoublev(HD_CURRENT_GIMBAL_ANGLES, gimbal_angles);
    hduVector3Dd vel_buff(0, 0, 0);
    vel_buff = (omni_state->position * 3 - 4 * omni_state->pos_hist1 + omni_state->pos_hist2) / 0.002;
    omni_state->velocity = (.2196 * (vel_buff + omni_state->inp_vel3) + .6588 * (omni_state->inp_vel1 + omni_state->inp_vel2)) / 1000.0 -
                           (-2.7488 * omni_state->out_vel1 + 2.5282 * omni_state->out_vel2 - 0.7776 * omni_state->out_vel3);
    omni_state->pos_hist2 = omni_state->pos_hist1;
    omni_state->pos_hist1 = omni_state->position;
    omni_state->inp_vel3 = omni_state->inp_vel2;
    omni_state->inp_vel2 = omni_state->inp_vel1;
    omni_state->inp_vel1 = vel_buff;
    omni_state->out_vel3 = omni_state->out_vel2;
    omni_state->out_vel2 = omni_state->out_vel1;
    omni_state->out_vel1 = omni_state->velocity;
    if (omni_state->lock == true)
        omni_state->force = 0.04 * omni_state->units_ratio * (omni_state->lock_pos - omni_state->position) - 0.001 * omni_state->velocity;
    else
        omni_state->force.set(0, 0, 0);
    hduVector3Dd feedback;
    feedback[0] = omni_state->force[0];
    feedback[1] = omni_state->force[1];
    feedback[2] = omni_state->force[2];
    hdSetDoublev(HD_CURRENT_FORCE, feedback);
    int nButtons = 0;
    hdGetIntegerv(HD_CURRENT_BUTTONS, &nButtons);
    omni_state->buttons[0] = (nButtons & HD_DEVICE_BUTTON_1) ? 1 : 0;
    omni_state->buttons[1] = (nButtons & HD_DEVICE_BUTTON_2) ? 1 : 0;
    hdEndFrame(hdGetCurrentDevice());
    HDErrorInfo error;
    if (HD_DEVICE_ERROR(error = hdGetError())) {
        hduPrintError(stderr, &error, "Error during main scheduler callback");
        if (hduIsSchedulerError(&error)) return HD_CALLBACK_DONE;
    }
    float t[7] = {0., static_cast<float>(omni_state->joints[0]), static_cast<float>(omni_state->joints[1]),
                  static_cast<float>(omni_state->joints[2] - omni_state->joints[1]), static_cast<float>(gimbal_angles[0]),
                  static_cast<float>(gimbal_angles[1]), static_cast<float>(gimbal_angles[2])};
    for (int i = 0; i < 7; i++) omni_state->thetas[i] = t[i];
    return HD_CALLBACK_CONTINUE;
}

bool HHD_Auto_Calibration() {
    int supportedCalibrationStyles;
    HDErrorInfo error;
    hdGetIntegerv(HD_CALIBRATION_STYLE, &supportedCalibrationStyles);
    if (supportedCalibrationStyles & HD_CALIBRATION_ENCODER_RESET) calibrationStyle = HD_CALIBRATION_ENCODER_RESET;
    if (supportedCalibrationStyles & HD_CALIBRATION_INKWELL) calibrationStyle = HD_CALIBRATION_INKWELL;
    if (supportedCalibrationStyles & HD_CALIBRATION_AUTO) calibrationStyle = HD_CALIBRATION_AUTO;
    int tries = 0;
    do {
        hdUpdateCalibration(calibrationStyle);
        if (HD_DEVICE_ERROR(error = hdGetError())) hduPrintError(stderr, &error, "Calibration failed");
        usleep(10000);
    } while (hdCheckCalibration() != HD_CALIBRATION_OK && ++tries < 50);
    return hdCheckCalibration() == HD_CALIBRATION_OK;
}

void *ros_publish(void *ptr) {
    PhantomNode *omni_ros = static_cast<PhantomNode *>(ptr);
    for (int i = 0; i < 160; ++i) {
        omni_ros->publish_omni_state();
        usleep(10000);
    }
    return NULL;
}

int main(int, char **) {
    HDErrorInfo error;
    HHD hHD = hdInitDevice("Default Device");
    if (HD_DEVICE_ERROR(error = hdGetError())) {
        hduPrintError(stderr, &error, "Failed to initialize haptic device");
        return -1;
    }
    std::cout << "Found " << hdGetString(HD_DEVICE_MODEL_TYPE) << "." << std::endl;
    hdEnable(HD_FORCE_OUTPUT);
    hdStartScheduler();
    if (HD_DEVICE_ERROR(error = hdGetError())) return -1;
    if (!HHD_Auto_Calibration()) return -2;
    OmniState state;
    PhantomNode omni_ros(&state);
    hdScheduleAsynchronous(omni_state_callback, &state, HD_MAX_SCHEDULER_PRIORITY);
    pthread_t publish_thread;
    pthread_create(&publish_thread, NULL, ros_publish, (void *)&omni_ros);
    pthread_join(publish_thread, NULL);
    hdStopScheduler();
    hdDisableDevice(hHD);
    std::cout << "messages " << omni_ros.messages << " events " << omni_ros.events << " locked force " << omni_ros.largestLock
              << " quaternion error " << omni_ros.largestQuaternionError << " last x " << omni_ros.lastX << std::endl;
    return 0;
}
