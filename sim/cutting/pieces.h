#pragma once
/// Which tissue still hangs together. Two tets belong to one piece when they share a corner, for there the mesh still pulls: a piece is free
/// only where a whole row of tets is gone all the way across. Physics thread; no heap.

namespace halsted {

struct Model;
struct State;
struct StepOutput;

/// From what is gone: pieces, bare particles, ties, and the share of its mass that each particle still has. Takes no step of its own.
void findPieces(const Model&, State&);

/// Free pieces no larger than a crumb are sucked away with the smoke; larger ones are reported.
void settlePieces(const Model&, State&, StepOutput&);

/// Does a hand, or a clamp that stands, hold some of it?
bool heldByHand(const Model&, const State&, int piece);
bool heldByClamp(const Model&, const State&, int piece);

/// A free piece that nobody holds and that has been carried far from the rest is taken out of the scene. True when one was.
bool takeAwayPieces(const Model&, State&, StepOutput&);

}  // namespace halsted
