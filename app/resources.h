#pragma once
/// What the running program takes from the machine, as the kernel counts it. Any thread.
namespace halsted::app {

double peakResidentMegabytes() noexcept;       // [MB] most memory held at once since the program started; 1 MB = 1e6 B
double threadCpuTime() noexcept;               // [s] of the calling thread: does not grow while others have the core

}  // namespace halsted::app
