#pragma once
/// The phases of an instrument tie (scenes/expert_tie.cpp), in the order in which they follow each other. Private to scenes/.
#include "scenes/expert_state.h"

namespace halsted::scenes {

enum TiePhase {
  kLook, kNearer, kNearerDown, kNearerClose, kLiftIt, kHang, kFreeDriver = kHang + kHangingPhases, kFreeLong, kTakeLong, kTakeLongDown, kTakeLongClose,
  kShorten, kTurn, kLiftLong, kStand, kWind, kFollow, kOpen, kToTail, kClose, kThrough, kUnwind, kCross, kDrawTight, kLayTail, kLetTail,
  kAgain, kAgainDown, kAgainClose
};

inline constexpr double kMove = 0.08, kCareful = 0.03;   // [m/s] of a hand through the air; near thread
inline constexpr double kFeelTime = 0.05;      // [s] over which a hand feels a force
inline constexpr double kFirm = 0.6;           // [N] with which a loop that clings is drawn off
inline constexpr int kAttempts = 6;            // at each throw

/// The long end comes into the winding hand: from the driver that holds it (to kHang + kHangingPhases), which takes it first where that hand
/// has it too far from the stitch; or from where it lies.
void takeNearer(const Scene&);
void handOver(const Scene&);
void takeLongEnd(const Scene&, std::string& failure);
/// The long end is drawn straight, and on through the stitch until the tail is no longer than the action wants it.
void shortenTail(const Scene&);
/// It is wound round the driver, which then goes for the tail with the loop on its jaws, or out of the loop; true once it is out.
void wind(const Scene&);
void fetchTail(const Scene&, std::string& failure);
bool unwind(const Scene&);
/// The driver goes back along its shaft; true once it is there.
bool rise(const Scene&);
/// The tail is drawn through the loop and the hands go to their sides.
void drawThrough(const Scene&);
/// Each hand draws its end until it feels the tension; true once both have held it for a moment.
bool drawTight(const Scene&);
/// The tail is laid toward the surgeon; true once it lies.
bool layTail(const Scene&);
/// The driver lets go what it holds and rises; true once it is up.
bool letTailGo(const Scene&);
/// By how much thread beyond its way a loop hangs that has come loose since its throw was drawn, 0 if it has not; have the walls come apart that it
/// is to hold? Asked of a throw that nothing locks yet: locked, they would stay so for good.
double hangsBy(const Scene&);                  // [m]
bool wallsCameApart(const Scene&);
/// The driver takes the tail again, with no loop on its jaws, and both ends are drawn apart once more.
void drawAgain(const Scene&);

}  // namespace halsted::scenes
