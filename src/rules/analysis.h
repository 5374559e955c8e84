#pragma once
// What is computed once per deck from the model and shared by the rules.
#include "model/model.h"

namespace drawbead {

struct Analysis {};

Analysis analyse(const Deck&, const Model&, Needs needs, unsigned threads);

} // namespace drawbead
