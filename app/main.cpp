/// From here to the hot loop: commands/command_line -> commands/train -> threads/live_session -> threads/physics_thread -> sim/step.
#include "app/commands/commands.h"

int main(int argc, char** argv) { return halsted::app::runCommandLine(argc, argv); }
