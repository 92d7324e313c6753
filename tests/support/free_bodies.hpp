// What the start of a run says about bodies that nothing holds.
#pragma once

#include "errors.hpp"
#include "setup.hpp"
#include "support/test_scene.hpp"

namespace mortise::test {

/// The message about free bodies at the start of a run, or nothing.
inline std::string free_at_the_start(const std::string& deck) {
  const ScratchFolder folder;
  Setup setup(Deck::read(folder.write("deck.xml", deck)), world());
  try {
    setup.first_state();
    return "";
  } catch (const DeckError& error) {
    return error.what();
  }
}

}  // namespace mortise::test
