#pragma once
/// Nothing acts on tissue that is gone: contacts, grasps, holes and stitches there end in the step in which it goes. Physics thread; no heap.

namespace halsted {

struct Model;
struct State;
struct StepOutput;

/// Before the step's forces are gathered. A hole or a stitch in a tet that went has torn out; a grasp of it holds nothing.
void letGoOfGone(const Model&, State&, StepOutput&);

}  // namespace halsted
