#pragma once
/// Can a state that was read from a file be stepped? `load` has seen to its sizes and bools; here every index and count is held against the
/// model, and every number must be one. To be asked after `load`, before the first step. Any thread; takes some milliseconds.
#include <string>

namespace halsted {

struct Model;
struct State;

/// False (and `error` names the field) when a step of this state could read past the end of what the model has.
bool fits(const Model&, const State&, std::string& error);

}  // namespace halsted
