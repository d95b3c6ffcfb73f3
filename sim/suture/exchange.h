#pragma once
/// Thread and tissue exchange force incrementally: within the strand's solve a hole or a contact is a spring of its own, and the tissue answers
/// afterwards to all of them at once. That comes to rest only if each spring gives at least as much as the tissue will when all the others
/// change too: by the sum of a row of the compliances between them (Gershgorin). Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"
#include "sim/work.h"

namespace halsted {

/// Is that sum reckoned? Between two bowels joined by thread that can be knotted. Not yet elsewhere: on a standing wall two hands then lose a throw
/// (InstrumentTie), and over edges that were cut the first knot of `altemeier` breaks its thread. Why is not known.
bool sumsExchange(const Model&, const State&);

/// Where thread and needle push and pull on the tissue: holes, and contacts of the last step. In a fold the needle has many, too.
void gatherExchange(const Model&, const StrandState&, ExchangeWork&);
/// How far newtons at all contacts, or at all holes, move this vertex of the tissue.  [m/N]
double movedByContacts(const Model&, int vertex, ExchangeWork&);
double movedByHoles(const Model&, int vertex, ExchangeWork&);
/// The vertex that stands for a hole, or for a place in a triangle: the weightiest.
int vertexOf(const Model&, const Hole&);
int vertexOf(const Model&, int triangle, const std::array<double, 3>& weight);

}  // namespace halsted
